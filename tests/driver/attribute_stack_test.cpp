// glPushAttrib and glPushClientAttrib: each group saves its variables, all of them and no others.

#include "tests/driver/attribute_groups.h"
#include "tests/driver/state_fixture.h"

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

using namespace entry;

void change_enables() {
    for (const Capability& capability : capabilities()) {
        for (GLenum name = capability.name; name < capability.name + capability.count; ++name)
            IsEnabled(name) ? Disable(name) : Enable(name);
    }
}

void change_current_values() {
    Color4f(0.1f, 0.2f, 0.3f, 0.4f);
    SecondaryColor3f(0.5f, 0.6f, 0.7f);
    Indexf(9);
    TexCoord4f(1, 2, 3, 4);
    Normal3f(1, 2, 3);
    FogCoordf(5);
    EdgeFlag(GL_FALSE);
    WindowPos2f(7, 8);
}

void change_rasterization() {
    PointSize(3);
    PointParameterf(GL_POINT_SIZE_MIN, 2);
    PointParameterf(GL_POINT_SIZE_MAX, 5);
    PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 4);
    const GLfloat attenuation[] = {0, 1, 2};
    PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
    LineWidth(4);
    LineStipple(3, 0x1234);
    CullFace(GL_FRONT);
    FrontFace(GL_CW);
    PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    PolygonOffset(1, 2);
    SampleCoverage(0.5f, GL_TRUE);
}

void change_pixels() {
    PixelTransferi(GL_MAP_COLOR, GL_TRUE);
    PixelTransferi(GL_INDEX_SHIFT, 2);
    PixelTransferf(GL_RED_SCALE, 2);
    PixelTransferf(GL_ALPHA_BIAS, 0.5f);
    PixelTransferf(GL_DEPTH_SCALE, 3);
    PixelZoom(2, 3);
    ReadBuffer(GL_FRONT);
    const GLfloat map[] = {0, 1};
    PixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, map);
    PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void change_lighting_and_fog() {
    const GLfloat color[] = {0.5f, 0.25f, 0.75f, 0.5f};
    ShadeModel(GL_FLAT);
    ColorMaterial(GL_FRONT, GL_SPECULAR);
    LightModelfv(GL_LIGHT_MODEL_AMBIENT, color);
    LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    Fogfv(GL_FOG_COLOR, color);
    Fogf(GL_FOG_INDEX, 3);
    Fogf(GL_FOG_DENSITY, 2);
    Fogf(GL_FOG_START, 5);
    Fogf(GL_FOG_END, 6);
    Fogi(GL_FOG_MODE, GL_LINEAR);
    Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    Fogi(GL_FOG_DISTANCE_MODE_NV, GL_EYE_RADIAL_NV);
}

void change_fragment_operations() {
    DepthFunc(GL_GREATER);
    DepthMask(GL_FALSE);
    ClearDepth(0.5);
    DepthBoundsEXT(0.25, 0.75);
    ClearAccum(1, 1, 1, 1);
    StencilFunc(GL_LESS, 5, 6);
    StencilOp(GL_INCR, GL_DECR, GL_INVERT);
    StencilMask(7);
    ClearStencil(8);
    Viewport(1, 2, 3, 4);
    DepthRange(0.25, 0.5);
    AlphaFunc(GL_LESS, 0.5f);
    BlendFuncSeparate(GL_DST_COLOR, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    BlendEquationSeparateEXT(GL_MIN, GL_MAX);
    BlendColor(1, 1, 1, 1);
    LogicOp(GL_XOR);
    const GLenum buffers[] = {GL_FRONT_LEFT, GL_BACK_LEFT};
    DrawBuffers(2, buffers);
    IndexMask(1);
    ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    ClearColor(1, 1, 1, 1);
    ClearIndex(3);
    Scissor(5, 6, 7, 8);
}

void change_the_rest() {
    Translatef(1, 2, 3);
    MatrixMode(GL_TEXTURE);
    Translatef(1, 2, 3);
    MatrixMode(GL_PROJECTION);
    Translatef(1, 2, 3);
    for (const int hint : {GL_PERSPECTIVE_CORRECTION_HINT,
                           GL_POINT_SMOOTH_HINT,
                           GL_LINE_SMOOTH_HINT,
                           GL_POLYGON_SMOOTH_HINT,
                           GL_FOG_HINT,
                           GL_GENERATE_MIPMAP_HINT,
                           GL_TEXTURE_COMPRESSION_HINT})
        Hint(static_cast<GLenum>(hint), GL_NICEST);
    MapGrid1f(4, 2, 3);
    MapGrid2f(5, 1, 2, 6, 3, 4);
    ListBase(11);
    BindTexture(GL_TEXTURE_2D, 17);
    ClientActiveTexture(GL_TEXTURE1);
}

void change_everything() {
    change_current_values();
    change_rasterization();
    change_pixels();
    change_lighting_and_fog();
    change_fragment_operations();
    change_the_rest();
    change_enables();
}

void check_group(GLbitfield mask) {
    StateFixture f;
    const auto before = f.snapshot();
    PushAttrib(mask);
    change_everything();
    const auto changed = f.snapshot();
    PopAttrib();
    const auto after = f.snapshot();
    REQUIRE(GetError() == GL_NO_ERROR);
    for (const auto& [name, groups] : GroupsOf) {
        INFO("variable " << std::hex << name << ", mask " << mask);
        CHECK(changed.at(name) != before.at(name));
        CHECK(after.at(name) == (groups & mask ? before : changed).at(name));
    }
}

} // namespace

TEST_CASE("Each attribute group restores its variables and no others") {
    for (unsigned bit = 0; bit < 20; ++bit)
        check_group(1u << bit);
    check_group(GL_MULTISAMPLE_BIT);
}

TEST_CASE("All groups together restore everything, none restores nothing") {
    check_group(GL_ALL_ATTRIB_BITS);
    check_group(0);
}

TEST_CASE("The attribute stacks are sixteen deep") {
    StateFixture f;
    for (unsigned i = 0; i < 16; ++i) {
        PointSize(static_cast<GLfloat>(i + 1));
        PushAttrib(GL_POINT_BIT);
        PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    }
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(get_int(GL_ATTRIB_STACK_DEPTH) == 16);
    PushAttrib(GL_POINT_BIT);
    CHECK(GetError() == GL_STACK_OVERFLOW);
    PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    CHECK(GetError() == GL_STACK_OVERFLOW);
    for (GLint i = 16; i > 0; --i) {
        PopAttrib();
        PopClientAttrib();
        CHECK(get_int(GL_POINT_SIZE) == i);
    }
    CHECK(GetError() == GL_NO_ERROR);
    PopAttrib();
    CHECK(GetError() == GL_STACK_UNDERFLOW);
    PopClientAttrib();
    CHECK(GetError() == GL_STACK_UNDERFLOW);
}

TEST_CASE("Texture state is restored for every unit, and the active unit too") {
    StateFixture f;
    ActiveTexture(GL_TEXTURE2);
    PushAttrib(GL_TEXTURE_BIT);
    TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    Enable(GL_TEXTURE_2D);
    ActiveTexture(GL_TEXTURE5);
    Enable(GL_TEXTURE_GEN_R);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    PopAttrib();
    CHECK(get_int(GL_ACTIVE_TEXTURE) == GL_TEXTURE2);
    CHECK(IsEnabled(GL_TEXTURE_2D) == GL_FALSE);
    GLint value = 0;
    GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &value);
    CHECK(value == GL_MODULATE);
    ActiveTexture(GL_TEXTURE5);
    CHECK(IsEnabled(GL_TEXTURE_GEN_R) == GL_FALSE);
    GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &value);
    CHECK(value == GL_REPEAT);
}

TEST_CASE("Sprites' coordinates belong to the point group alone") {
    StateFixture f;
    const auto replaced = [] {
        GLint value = 0;
        GetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &value);
        return value;
    };
    for (const GLbitfield group : {GL_TEXTURE_BIT, GL_POINT_BIT}) {
        TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_FALSE);
        PushAttrib(group);
        TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
        PopAttrib();
        CHECK(replaced() == (group == GL_TEXTURE_BIT ? GL_TRUE : GL_FALSE));
    }
}

TEST_CASE("Restoring enables restores those of every texture unit") {
    StateFixture f;
    ActiveTexture(GL_TEXTURE3);
    Enable(GL_TEXTURE_1D);
    PushAttrib(GL_ENABLE_BIT);
    Disable(GL_TEXTURE_1D);
    ActiveTexture(GL_TEXTURE0);
    Enable(GL_TEXTURE_1D);
    PopAttrib();
    CHECK(get_int(GL_ACTIVE_TEXTURE) == GL_TEXTURE0);
    CHECK(IsEnabled(GL_TEXTURE_1D) == GL_FALSE);
    ActiveTexture(GL_TEXTURE3);
    CHECK(IsEnabled(GL_TEXTURE_1D) == GL_TRUE);
}

TEST_CASE("Restored state reaches the registers") {
    StateFixture f;
    Enable(GL_DEPTH_TEST);
    const Registers before = f.drawn();
    PushAttrib(GL_ALL_ATTRIB_BITS);
    change_everything();
    CHECK(!(f.drawn().primitive == before.primitive));
    PopAttrib();
    const Registers& after = f.drawn();
    CHECK(after.primitive == before.primitive);
    CHECK(after.fragment == before.fragment);
    CHECK(after.depth == before.depth);
    CHECK(after.blend == before.blend);
    CHECK(after.stencil == before.stencil);
    CHECK(after.fog == before.fog);
    CHECK(after.lighting == before.lighting);
    CHECK(after.viewport == before.viewport);
    CHECK(after.scissor == before.scissor);
    CHECK(after.targets == before.targets);
    CHECK(after.clip_planes == before.clip_planes);
}

TEST_CASE("Client state is restored by its own stack, group by group") {
    StateFixture f;
    PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    PixelStorei(GL_PACK_ALIGNMENT, 8);
    EnableClientState(GL_NORMAL_ARRAY);
    ClientActiveTexture(GL_TEXTURE4);
    EnableClientState(GL_TEXTURE_COORD_ARRAY);
    GLuint buffer = 0;
    GenBuffers(1, &buffer);
    BindBuffer(GL_ARRAY_BUFFER, buffer);
    BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    PopClientAttrib();
    CHECK(get_int(GL_PACK_ALIGNMENT) == 8);
    CHECK(get_int(GL_PIXEL_PACK_BUFFER_BINDING) == static_cast<GLint>(buffer));
    CHECK(get_int(GL_ARRAY_BUFFER_BINDING) == 0);
    CHECK(IsEnabled(GL_NORMAL_ARRAY) == GL_FALSE);
    CHECK(get_int(GL_CLIENT_ACTIVE_TEXTURE) == GL_TEXTURE0);
    PopClientAttrib();
    CHECK(get_int(GL_PACK_ALIGNMENT) == 4);
    CHECK(get_int(GL_PIXEL_PACK_BUFFER_BINDING) == 0);
    CHECK(GetError() == GL_NO_ERROR);
}

} // namespace ffgpu::gl
