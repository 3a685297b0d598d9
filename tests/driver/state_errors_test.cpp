// Commands that set state: what they refuse, without any other effect.

#include "tests/driver/state_fixture.h"

#include <functional>

#include <catch2/catch.hpp>

namespace ffgpu::gl {

using namespace entry;

TEST_CASE("Each invalid argument is refused with its error and no other effect") {
    StateFixture f;
    const GLfloat four[4] = {0.5f, 0.5f, 0.5f, 0.5f};
    const GLfloat negative[4] = {-1, -1, -1, -1};
    const GLint ints[4] = {};
    const GLdouble doubles[4] = {};
    struct Case {
        const char* text;
        GLenum error;
        std::function<void()> call;
    };
#define REFUSED(error, call)                                                                       \
    {                                                                                              \
#call, error, [&] { call; }                                                                \
    }
    const Case cases[] = {
        REFUSED(GL_INVALID_ENUM, MatrixMode(GL_COLOR)),
        REFUSED(GL_INVALID_VALUE, Frustum(-1, 1, -1, 1, 0, 1)),
        REFUSED(GL_INVALID_VALUE, Frustum(-1, 1, -1, 1, 1, -1)),
        REFUSED(GL_INVALID_VALUE, Frustum(1, 1, -1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, Frustum(-1, 1, -1, -1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, Frustum(-1, 1, -1, 1, 2, 2)),
        REFUSED(GL_INVALID_VALUE, Ortho(1, 1, -1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, Ortho(-1, 1, 1, 1, 1, 2)),
        REFUSED(GL_INVALID_VALUE, Ortho(-1, 1, -1, 1, 1, 1)),
        REFUSED(GL_INVALID_VALUE, Viewport(0, 0, -1, 1)),
        REFUSED(GL_INVALID_VALUE, Viewport(0, 0, 1, -1)),
        REFUSED(GL_INVALID_ENUM, ClipPlane(GL_CLIP_PLANE0 + 6, doubles)),
        REFUSED(GL_INVALID_ENUM, Lightfv(GL_LIGHT0 + 8, GL_AMBIENT, four)),
        REFUSED(GL_INVALID_ENUM, Lightfv(GL_LIGHT0, GL_SHININESS, four)),
        REFUSED(GL_INVALID_ENUM, Lightf(GL_LIGHT0, GL_SHININESS, 1)),
        REFUSED(GL_INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5f)),
        REFUSED(GL_INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1)),
        REFUSED(GL_INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91)),
        REFUSED(GL_INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1)),
        REFUSED(GL_INVALID_VALUE, Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1)),
        REFUSED(GL_INVALID_ENUM, LightModelf(GL_AMBIENT, 1)),
        REFUSED(GL_INVALID_ENUM, LightModeli(GL_AMBIENT, 1)),
        REFUSED(GL_INVALID_ENUM, LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SMOOTH)),
        REFUSED(GL_INVALID_ENUM, Materialfv(GL_LEFT, GL_AMBIENT, four)),
        REFUSED(GL_INVALID_ENUM, Materialfv(GL_FRONT, GL_POSITION, four)),
        REFUSED(GL_INVALID_ENUM, Materialf(GL_FRONT, GL_POSITION, 1)),
        REFUSED(GL_INVALID_VALUE, Materialf(GL_FRONT, GL_SHININESS, 129)),
        REFUSED(GL_INVALID_VALUE, Materialf(GL_FRONT, GL_SHININESS, -1)),
        REFUSED(GL_INVALID_ENUM, ColorMaterial(GL_LEFT, GL_AMBIENT)),
        REFUSED(GL_INVALID_ENUM, ColorMaterial(GL_FRONT, GL_SHININESS)),
        REFUSED(GL_INVALID_ENUM, ShadeModel(GL_FILL)),
        REFUSED(GL_INVALID_VALUE, PointSize(0)),
        REFUSED(GL_INVALID_VALUE, PointSize(-1)),
        REFUSED(GL_INVALID_VALUE, PointParameterf(GL_POINT_SIZE_MIN, -1)),
        REFUSED(GL_INVALID_ENUM, PointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1)),
        REFUSED(GL_INVALID_ENUM, PointParameterfv(GL_POINT_SIZE, four)),
        REFUSED(GL_INVALID_VALUE, LineWidth(0)),
        REFUSED(GL_INVALID_ENUM, CullFace(GL_LEFT)),
        REFUSED(GL_INVALID_ENUM, FrontFace(GL_FRONT)),
        REFUSED(GL_INVALID_ENUM, PolygonMode(GL_LEFT, GL_FILL)),
        REFUSED(GL_INVALID_ENUM, PolygonMode(GL_FRONT, GL_QUADS)),
        REFUSED(GL_INVALID_ENUM, Fogi(GL_FOG_MODE, GL_NEAREST)),
        REFUSED(GL_INVALID_ENUM, Fogf(GL_FOG_COLOR, 1)),
        REFUSED(GL_INVALID_ENUM, Fogi(GL_FOG_COORD_SRC, GL_FOG)),
        REFUSED(GL_INVALID_ENUM, Fogiv(GL_AMBIENT, ints)),
        REFUSED(GL_INVALID_VALUE, Fogf(GL_FOG_DENSITY, -0.5f)),
        REFUSED(GL_INVALID_ENUM, Fogfv(GL_FOG_MODE, negative)),
        REFUSED(GL_INVALID_VALUE, Scissor(0, 0, -1, 0)),
        REFUSED(GL_INVALID_VALUE, Scissor(0, 0, 0, -1)),
        REFUSED(GL_INVALID_ENUM, AlphaFunc(GL_KEEP, 0)),
        REFUSED(GL_INVALID_ENUM, StencilFunc(GL_KEEP, 0, 0)),
        REFUSED(GL_INVALID_ENUM, StencilOp(GL_KEEP, GL_KEEP, GL_LESS)),
        REFUSED(GL_INVALID_ENUM, StencilFuncSeparateATI(GL_LESS, GL_KEEP, 0, 0)),
        REFUSED(GL_INVALID_ENUM, StencilOpSeparateATI(GL_LEFT, GL_KEEP, GL_KEEP, GL_KEEP)),
        REFUSED(GL_INVALID_ENUM, ActiveStencilFaceEXT(GL_FRONT_AND_BACK)),
        REFUSED(GL_INVALID_ENUM, DepthFunc(GL_ALWAYS + 1)),
        REFUSED(GL_INVALID_VALUE, DepthBoundsEXT(0.75, 0.5)),
        REFUSED(GL_INVALID_ENUM, BlendFunc(GL_LESS, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, BlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE)),
        REFUSED(GL_INVALID_ENUM, BlendFuncSeparate(GL_ONE, GL_ZERO, GL_LESS, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, BlendEquation(GL_LOGIC_OP)),
        REFUSED(GL_INVALID_ENUM, BlendEquationSeparateEXT(GL_FUNC_ADD, GL_ADD)),
        REFUSED(GL_INVALID_ENUM, LogicOp(GL_SET + 1)),
        REFUSED(GL_INVALID_ENUM, DrawBuffer(GL_TEXTURE)),
        REFUSED(GL_INVALID_OPERATION, DrawBuffer(GL_AUX0)),
        REFUSED(GL_INVALID_OPERATION, DrawBuffer(GL_RIGHT)),
        REFUSED(GL_INVALID_OPERATION, DrawBuffer(GL_COLOR_ATTACHMENT0)),
        REFUSED(GL_INVALID_ENUM, ReadBuffer(GL_FRONT_AND_BACK)),
        REFUSED(GL_INVALID_OPERATION, ReadBuffer(GL_BACK_RIGHT)),
        REFUSED(GL_INVALID_VALUE, Clear(GL_CURRENT_BIT)),
        REFUSED(GL_INVALID_ENUM, Accum(GL_BLEND, 1)),
        REFUSED(GL_INVALID_ENUM, Hint(GL_FOG, GL_NICEST)),
        REFUSED(GL_INVALID_ENUM, Hint(GL_FOG_HINT, GL_LINEAR)),
        REFUSED(GL_INVALID_ENUM, Enable(GL_AMBIENT)),
        REFUSED(GL_INVALID_ENUM, Disable(GL_VERTEX_ARRAY_POINTER)),
        REFUSED(GL_STACK_UNDERFLOW, PopAttrib()),
        REFUSED(GL_STACK_UNDERFLOW, PopClientAttrib()),
        REFUSED(GL_INVALID_ENUM, GetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, Vec4().data())),
        REFUSED(GL_INVALID_ENUM, GetLightfv(GL_LIGHT0 + 8, GL_AMBIENT, Vec4().data())),
    };
#undef REFUSED
    for (const Case& refused : cases) {
        INFO(refused.text);
        f.check_refused(refused.error, refused.call);
    }
}

TEST_CASE("State commands between glBegin and glEnd are refused") {
    StateFixture f;
    const std::pair<const char*, std::function<void()>> calls[] = {
        {"MatrixMode", [] { MatrixMode(GL_PROJECTION); }},
        {"LoadIdentity", [] { LoadIdentity(); }},
        {"Enable", [] { Enable(GL_BLEND); }},
        {"Lightf", [] { Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 10); }},
        {"Clear", [] { Clear(GL_COLOR_BUFFER_BIT); }},
        {"PushAttrib", [] { PushAttrib(GL_ALL_ATTRIB_BITS); }},
        {"Viewport", [] { Viewport(1, 1, 1, 1); }},
        {"BlendFunc", [] { BlendFunc(GL_ONE, GL_ONE); }},
        {"Flush", [] { Flush(); }},
        {"Finish", [] { Finish(); }},
        {"Hint", [] { Hint(GL_FOG_HINT, GL_NICEST); }},
    };
    const auto before = f.snapshot();
    for (const auto& [name, call] : calls) {
        INFO(name);
        Begin(GL_TRIANGLES);
        call();
        End();
        CHECK(GetError() == GL_INVALID_OPERATION);
        CHECK(f.snapshot() == before);
    }
    Begin(GL_TRIANGLES);
    GLint value = 77;
    GetIntegerv(GL_MATRIX_MODE, &value);
    CHECK(value == 77);
    CHECK(IsEnabled(GL_DITHER) == GL_FALSE);
    CHECK(GetString(GL_VENDOR) == nullptr);
    End();
    CHECK(GetError() == GL_INVALID_OPERATION);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("The first error stays until it is read") {
    StateFixture f;
    PointSize(-1);
    MatrixMode(0);
    CHECK(GetError() == GL_INVALID_VALUE);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(StateFixture, "a scalar is the first component of a colour, the others are 0") {
    GLfloat color[4] = {};
    Materialf(GL_FRONT, GL_AMBIENT, 0.5f);
    GetMaterialfv(GL_FRONT, GL_AMBIENT, color);
    CHECK(std::vector<GLfloat>(color, color + 4) == std::vector<GLfloat>{0.5f, 0, 0, 0});
    LightModelf(GL_LIGHT_MODEL_AMBIENT, 0.25f);
    GetFloatv(GL_LIGHT_MODEL_AMBIENT, color);
    CHECK(std::vector<GLfloat>(color, color + 4) == std::vector<GLfloat>{0.25f, 0, 0, 0});
    CHECK(GetError() == GL_NO_ERROR);
}

} // namespace ffgpu::gl
