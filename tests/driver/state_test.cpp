// Commands that set state: what they store, what they refuse.

#include "driver/math/matrix.h"
#include "tests/driver/state_fixture.h"

#include <limits>

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

using namespace entry;

Vec4 get_light_value(GLenum light, GLenum name) {
    Vec4 values{};
    GetLightfv(light, name, values.data());
    return values;
}

Vec4 get_material_value(GLenum face, GLenum name) {
    Vec4 values{};
    GetMaterialfv(face, name, values.data());
    return values;
}

Mat4 get_matrix(GLenum name) {
    Mat4 matrix;
    GetFloatv(name, matrix.data());
    return matrix;
}

} // namespace

TEST_CASE("Rotations about an axis by quarter turns are exact") {
    StateFixture f;
    Rotatef(90, 0, 0, 5);
    CHECK(get_matrix(GL_MODELVIEW_MATRIX) == Mat4{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    Rotated(-90, 0, 0, 1);
    CHECK(get_matrix(GL_MODELVIEW_MATRIX) == Identity4);
    Rotatef(40, 0, 0, 0);
    CHECK(get_matrix(GL_MODELVIEW_MATRIX) == Identity4);
}

TEST_CASE("Matrix commands multiply from the right, transposes by the transposed matrix") {
    StateFixture f;
    const Mat4 m{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17};
    LoadTransposeMatrixf(m.data());
    CHECK(get_matrix(GL_TRANSPOSE_MODELVIEW_MATRIX) == m);
    CHECK(get_matrix(GL_MODELVIEW_MATRIX)[1] == 5);
    LoadIdentity();
    Translatef(1, 2, 3);
    Scalef(2, 3, 4);
    CHECK(get_matrix(GL_MODELVIEW_MATRIX) == Mat4{2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1});
    LoadMatrixf(m.data());
    MultMatrixf(m.data());
    const Mat4 square = get_matrix(GL_MODELVIEW_MATRIX);
    CHECK(square[0] == 1 * 1 + 2 * 5 + 3 * 9 + 4 * 13);
    CHECK(square[15] == 13 * 4 + 14 * 8 + 15 * 12 + 17 * 17);
}

TEST_CASE("The projections have the elements of the specification") {
    StateFixture f;
    MatrixMode(GL_PROJECTION);
    Frustum(-1, 3, -2, 2, 1, 5);
    CHECK(get_matrix(GL_PROJECTION_MATRIX) ==
          Mat4{0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0.5f, 0, -1.5f, -1, 0, 0, -2.5f, 0});
    LoadIdentity();
    Ortho(0, 4, 0, 2, -1, 1);
    CHECK(get_matrix(GL_PROJECTION_MATRIX) ==
          Mat4{0.5f, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1});
}

TEST_CASE("Matrix stacks overflow at their depth and underflow at their last matrix") {
    const std::pair<GLenum, GLint> stacks[] = {
        {GL_MODELVIEW, 32}, {GL_PROJECTION, 32}, {GL_TEXTURE, 10}};
    StateFixture f;
    for (const auto& [mode, depth] : stacks) {
        MatrixMode(mode);
        f.check_refused(GL_STACK_UNDERFLOW, [] { PopMatrix(); });
        for (GLint i = 1; i < depth; ++i) {
            Translatef(1, 0, 0);
            PushMatrix();
        }
        CHECK(GetError() == GL_NO_ERROR);
        f.check_refused(GL_STACK_OVERFLOW, [] { PushMatrix(); });
        for (GLint i = 1; i < depth; ++i)
            PopMatrix();
        CHECK(GetError() == GL_NO_ERROR);
    }
    CHECK(get_matrix(GL_MODELVIEW_MATRIX)[12] == 1);
}

TEST_CASE("Each texture unit has a matrix stack of its own") {
    StateFixture f;
    MatrixMode(GL_TEXTURE);
    ActiveTexture(GL_TEXTURE2);
    Scalef(2, 2, 2);
    PushMatrix();
    ActiveTexture(GL_TEXTURE0);
    CHECK(get_matrix(GL_TEXTURE_MATRIX) == Identity4);
    CHECK(get_int(GL_TEXTURE_STACK_DEPTH) == 1);
    CHECK(f.drawn().tex_coords[2].matrix_enable);
    CHECK(!f.drawn().tex_coords[0].matrix_enable);
}

TEST_CASE("Light positions and spot directions are transformed when they are set") {
    StateFixture f;
    Translatef(10, 0, 0);
    Scalef(2, 2, 2);
    const GLfloat position[] = {1, 2, 3, 1};
    Lightfv(GL_LIGHT1, GL_POSITION, position);
    const GLint direction[] = {0, 1, 0};
    Lightiv(GL_LIGHT1, GL_SPOT_DIRECTION, direction);
    LoadIdentity();
    CHECK(get_light_value(GL_LIGHT1, GL_POSITION) == Vec4{12, 4, 6, 1});
    CHECK(get_light_value(GL_LIGHT1, GL_SPOT_DIRECTION) == Vec4{0, 2, 0, 0});
}

TEST_CASE("Light 0 is white and the others are black at first") {
    StateFixture f;
    CHECK(get_light_value(GL_LIGHT0, GL_DIFFUSE) == Vec4{1, 1, 1, 1});
    CHECK(get_light_value(GL_LIGHT0, GL_SPECULAR) == Vec4{1, 1, 1, 1});
    CHECK(get_light_value(GL_LIGHT1, GL_DIFFUSE) == Vec4{0, 0, 0, 1});
    CHECK(get_light_value(GL_LIGHT7, GL_AMBIENT) == Vec4{0, 0, 0, 1});
    CHECK(get_light_value(GL_LIGHT0, GL_POSITION) == Vec4{0, 0, 1, 0});
    CHECK(get_light_value(GL_LIGHT0, GL_SPOT_DIRECTION) == Vec4{0, 0, -1, 0});
    CHECK(get_light_value(GL_LIGHT0, GL_SPOT_CUTOFF)[0] == 180);
    CHECK(get_light_value(GL_LIGHT0, GL_CONSTANT_ATTENUATION)[0] == 1);
}

TEST_CASE("Integers given as colours stand for the range of one, others for themselves") {
    StateFixture f;
    constexpr GLint Max = std::numeric_limits<GLint>::max();
    const GLint color[] = {Max, 0, -Max - 1, Max};
    Lightiv(GL_LIGHT0, GL_AMBIENT, color);
    const Vec4 ambient = get_light_value(GL_LIGHT0, GL_AMBIENT);
    CHECK(ambient[0] == 1);
    CHECK(ambient[2] == -1);
    GLint back[4];
    GetLightiv(GL_LIGHT0, GL_AMBIENT, back);
    CHECK(back[0] == Max);
    CHECK(back[2] == -Max - 1);
    Lighti(GL_LIGHT0, GL_SPOT_CUTOFF, 45);
    CHECK(get_light_value(GL_LIGHT0, GL_SPOT_CUTOFF)[0] == 45);
    Fogi(GL_FOG_END, 7);
    CHECK(get_floats(GL_FOG_END, 1)[0] == 7);
}

TEST_CASE("While colour material is enabled the materials follow the current colour") {
    StateFixture f;
    Color4f(0.5f, 0.25f, 0.75f, 1);
    const GLfloat red[] = {1, 0, 0, 1};
    Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, red);
    CHECK(get_material_value(GL_BACK, GL_DIFFUSE) == Vec4{1, 0, 0, 1});

    ColorMaterial(GL_FRONT, GL_DIFFUSE);
    Enable(GL_COLOR_MATERIAL);
    CHECK(get_material_value(GL_FRONT, GL_DIFFUSE) == Vec4{0.5f, 0.25f, 0.75f, 1});
    CHECK(get_material_value(GL_BACK, GL_DIFFUSE) == Vec4{1, 0, 0, 1});
    Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red);
    CHECK(get_material_value(GL_FRONT, GL_DIFFUSE) == Vec4{0.5f, 0.25f, 0.75f, 1});
    CHECK(get_material_value(GL_FRONT, GL_AMBIENT) == Vec4{1, 0, 0, 1});

    Color4f(0, 1, 0, 1);
    Disable(GL_COLOR_MATERIAL);
    Color4f(0, 0, 1, 1);
    CHECK(get_material_value(GL_FRONT, GL_DIFFUSE) == Vec4{0, 1, 0, 1});
    CHECK(f.drawn().materials[0].diffuse == Vec4{0, 1, 0, 1});
}

TEST_CASE("A colour that is no longer tracked keeps the last current colour") {
    StateFixture f;
    ColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION);
    Enable(GL_COLOR_MATERIAL);
    Color4f(0.25f, 0.5f, 0, 1);
    ColorMaterial(GL_FRONT_AND_BACK, GL_SPECULAR);
    Color4f(1, 1, 1, 1);
    CHECK(get_material_value(GL_FRONT, GL_EMISSION) == Vec4{0.25f, 0.5f, 0, 1});
    CHECK(get_material_value(GL_FRONT, GL_SPECULAR) == Vec4{1, 1, 1, 1});
}

TEST_CASE("Clip planes are kept in eye coordinates") {
    StateFixture f;
    Translatef(0, 0, -5);
    const GLdouble plane[] = {0, 0, 1, 2};
    ClipPlane(GL_CLIP_PLANE1, plane);
    GLdouble eye[4];
    GetClipPlane(GL_CLIP_PLANE1, eye);
    CHECK(std::vector<double>(eye, eye + 4) == std::vector<double>{0, 0, 1, 7});
}

TEST_CASE("The polygon stipple goes in and out through the pixel store") {
    StateFixture f;
    GLubyte pattern[128], back[128] = {};
    for (unsigned i = 0; i < 128; ++i)
        pattern[i] = static_cast<GLubyte>(i * 7 + 3);
    PolygonStipple(pattern);
    GetPolygonStipple(back);
    CHECK(std::equal(pattern, pattern + 128, back));
    CHECK(f.drawn().polygon_stipple.rows[1] == 0x1f262d34u);

    PixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
    PixelStorei(GL_UNPACK_SKIP_PIXELS, 4);
    PixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    PixelStorei(GL_UNPACK_ROW_LENGTH, 40);
    GLubyte wide[8 * 33] = {};
    wide[8 + 0] = 0x10; // pixel 4 of row 1: lowest bits come first
    PolygonStipple(wide);
    CHECK(f.drawn().polygon_stipple.rows[0] == 0x80000000u);
    CHECK(f.drawn().polygon_stipple.rows[1] == 0);
}

TEST_CASE("Stencil commands set the faces that their extensions say") {
    StateFixture f;
    StencilFunc(GL_LESS, 3, 0xf0);
    StencilOpSeparateATI(GL_BACK, GL_INCR, GL_DECR, GL_INVERT);
    const StencilState& stencil = f.state().fragment.stencil;
    CHECK(stencil.front.func == GL_LESS);
    CHECK(stencil.back.func == GL_LESS);
    CHECK(stencil.back.fail == GL_INCR);
    CHECK(stencil.front.fail == GL_KEEP);
    CHECK(stencil.two_side_back.func == GL_ALWAYS);
    ActiveStencilFaceEXT(GL_BACK);
    StencilFunc(GL_GREATER, 4, 0x0f);
    StencilMask(5);
    CHECK(stencil.back.func == GL_LESS);
    CHECK(stencil.two_side_back.func == GL_GREATER);
    CHECK(get_int(GL_STENCIL_FUNC) == GL_GREATER);
    CHECK(get_int(GL_STENCIL_WRITEMASK) == 5);
    CHECK(get_int(GL_STENCIL_BACK_FUNC_ATI) == GL_LESS);
    StencilFuncSeparateATI(GL_NEVER, GL_EQUAL, 9, 1);
    CHECK(stencil.front.func == GL_NEVER);
    CHECK(stencil.back.func == GL_EQUAL);
}

TEST_CASE("Values out of range are clamped where the specification says so") {
    StateFixture f;
    DepthRange(-3, 7);
    CHECK(get_floats(GL_DEPTH_RANGE, 2) == std::vector<GLfloat>{0, 1});
    AlphaFunc(GL_LESS, 2);
    CHECK(get_floats(GL_ALPHA_TEST_REF, 1)[0] == 1);
    ClearColor(-1, 2, 0.5f, 3);
    CHECK(get_floats(GL_COLOR_CLEAR_VALUE, 4) == std::vector<GLfloat>{0, 1, 0.5f, 1});
    ClearAccum(-2, 2, -0.5f, 0);
    CHECK(get_floats(GL_ACCUM_CLEAR_VALUE, 4) == std::vector<GLfloat>{-1, 1, -0.5f, 0});
    ClearDepth(5);
    CHECK(get_floats(GL_DEPTH_CLEAR_VALUE, 1)[0] == 1);
    LineStipple(1000, 1);
    CHECK(get_int(GL_LINE_STIPPLE_REPEAT) == 256);
    Viewport(-5, -6, 100000, 10);
    CHECK(get_floats(GL_VIEWPORT, 4) == std::vector<GLfloat>{-5, -6, 4096, 10});
    SampleCoverage(4, GL_TRUE);
    CHECK(get_floats(GL_SAMPLE_COVERAGE_VALUE, 1)[0] == 1);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("The first drawable gives viewport and scissor their sizes, later ones do not") {
    StateFixture f;
    Viewport(1, 2, 3, 4);
    f.gl.drawable().resize(20, 10);
    f.gl.make_current();
    CHECK(get_floats(GL_VIEWPORT, 4) == std::vector<GLfloat>{1, 2, 3, 4});
    CHECK(get_floats(GL_SCISSOR_BOX, 4) == std::vector<GLfloat>{0, 0, 64, 48});
}

TEST_CASE("Without a current context commands do nothing") {
    make_current(nullptr, nullptr, nullptr);
    Enable(GL_BLEND);
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(GetString(GL_VENDOR) == nullptr);
}

} // namespace ffgpu::gl
