// Lowering: GL state in, register values out.

#include "driver/lower/fragment.h"
#include "driver/lower/lighting.h"
#include "driver/lower/primitive.h"
#include "driver/lower/targets.h"
#include "driver/lower/transform.h"
#include "driver/math/matrix.h"
#include "tests/driver/state_fixture.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

constexpr DepthTarget Depth24{.depth_bits = 24, .stencil_bits = 8};

} // namespace

TEST_CASE("The normal matrix is the inverse transpose of the model-view matrix") {
    TransformState gl;
    gl.matrices.model_view.top() = multiply(translation(5, 6, 7), scaling(2, 4, 0.5));
    const Transform registers = lower_transform(gl);
    CHECK(registers.normal_matrix == std::array<float, 9>{0.5f, 0, 0, 0, 0.25f, 0, 0, 0, 2});
    CHECK(registers.normal_mode == NormalMode::Keep);
    // A normal is a plane's: it turns against the scaling, and a shear takes it along transposed.
    gl.matrices.model_view.top() = {1, 0, 0, 0, 3, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    CHECK(lower_transform(gl).normal_matrix == std::array<float, 9>{1, 0, 0, -3, 1, 0, 0, 0, 1});
}

TEST_CASE("Rescaling undoes a uniform scaling, and normalizing comes before it") {
    TransformState gl;
    gl.group.rescale_normal = true;
    gl.matrices.model_view.top() = multiply(rotation(30, 1, 1, 0), scaling(4, 4, 4));
    Transform registers = lower_transform(gl);
    CHECK(registers.normal_mode == NormalMode::Rescale);
    CHECK(registers.rescale == Approx(4).epsilon(1e-6));
    gl.group.normalize = true;
    CHECK(lower_transform(gl).normal_mode == NormalMode::Normalize);
    gl.group.normalize = false;
    gl.matrices.model_view.top() = scaling(0, 0, 0);
    CHECK(lower_transform(gl).rescale == 1);
}

TEST_CASE("Only enabled clip planes reach the device") {
    TransformGroup gl;
    gl.clip_planes[2] = {1, 2, 3, 4};
    gl.clip_planes[3] = {5, 6, 7, 8};
    gl.clip_plane_enable[3] = true;
    const UserClipPlanes registers = lower_clip_planes(gl);
    CHECK(registers.enable == 8);
    CHECK(registers.planes[2] == Vec4{});
    CHECK(registers.planes[3] == Vec4{5, 6, 7, 8});
}

TEST_CASE("A texture matrix is enabled if it is not the identity") {
    TextureUnit unit;
    CHECK(!lower_tex_coords(unit, Identity4).matrix_enable);
    CHECK(lower_tex_coords(unit, scaling(2, 1, 1)).matrix_enable);
    unit.gen[0] = {
        .enabled = true, .mode = GL_OBJECT_LINEAR, .object_plane = {1, 2, 3, 4}, .eye_plane = {}};
    unit.gen[1] = {
        .enabled = true, .mode = GL_EYE_LINEAR, .object_plane = {}, .eye_plane = {5, 6, 7, 8}};
    unit.gen[2] = {
        .enabled = true, .mode = GL_REFLECTION_MAP, .object_plane = {1}, .eye_plane = {1}};
    const TexCoordSetup registers = lower_tex_coords(unit, Identity4);
    CHECK(registers.mode == std::array{TexGenMode::ObjectLinear,
                                       TexGenMode::EyeLinear,
                                       TexGenMode::ReflectionMap,
                                       TexGenMode::Off});
    CHECK(registers.plane[0] == Vec4{1, 2, 3, 4});
    CHECK(registers.plane[1] == Vec4{5, 6, 7, 8});
    CHECK(registers.plane[2] == Vec4{});
}

TEST_CASE("A spot light has the cosine of its cut-off and a direction of length one") {
    LightSource gl{.enable = true};
    CHECK(lower_light(gl).spot_cutoff_cosine == -1);
    gl.spot_cutoff = 60;
    gl.spot_direction = {0, 3, -4};
    Light registers = lower_light(gl);
    CHECK(registers.spot_cutoff_cosine == Approx(0.5));
    CHECK(registers.spot_direction == std::array<float, 3>{0, 0.6f, -0.8f});
    gl.spot_cutoff = 90;
    CHECK(lower_light(gl).spot_cutoff_cosine == 0);
    gl.spot_direction = {0, 0, 0};
    CHECK(lower_light(gl).spot_direction == std::array<float, 3>{0, 0, 0});
    gl.enable = false;
    CHECK(lower_light(gl) == Light{});
}

TEST_CASE("Colour material is lowered to the faces and colours it tracks") {
    LightingState gl;
    CHECK(lower_lighting(gl).color_material_front == 0);
    gl.color_material.enable = true;
    CHECK(lower_lighting(gl).color_material_back == (ColorMaterialAmbient | ColorMaterialDiffuse));
    gl.color_material = {.enable = true, .face = GL_FRONT, .mode = GL_EMISSION};
    CHECK(lower_lighting(gl).color_material_front == ColorMaterialEmission);
    CHECK(lower_lighting(gl).color_material_back == 0);
}

TEST_CASE("The colour sum follows the light model with lighting and GL_COLOR_SUM without") {
    FragmentState gl;
    LightingState lighting;
    const auto sums = [&] { return lower_fragment_control(gl, lighting, false, 0).color_sum; };
    CHECK(!sums());
    gl.fog.color_sum = true;
    CHECK(sums());
    lighting.enable = true;
    CHECK(!sums());
    lighting.model.color_control = GL_SEPARATE_SPECULAR_COLOR;
    CHECK(sums());
    gl.fog.color_sum = false;
    CHECK(sums());
    lighting.enable = false;
    CHECK(!sums());
}

TEST_CASE("Samples are counted while a query is active") {
    CHECK(lower_fragment_control({}, {}, true, 0).count_samples);
    CHECK(!lower_fragment_control({}, {}, false, 0).count_samples);
}

TEST_CASE("Targets hold sRGB codes while it is enabled and they can") {
    FragmentState gl;
    CHECK(lower_fragment_control(gl, {}, false, 5).srgb_targets == 0);
    gl.blend.framebuffer_srgb = true;
    CHECK(lower_fragment_control(gl, {}, false, 5).srgb_targets == 5);
}

TEST_CASE("Depth is neither tested nor written without the test or without a buffer") {
    DepthState gl;
    CHECK(!lower_depth(gl, Depth24).write_enable);
    gl.enable = true;
    CHECK(lower_depth(gl, Depth24).write_enable);
    CHECK(!lower_depth(gl, {}).test_enable);
    CHECK(!lower_depth(gl, {}).write_enable);
    gl.write_mask = false;
    CHECK(lower_depth(gl, Depth24).test_enable);
    CHECK(!lower_depth(gl, Depth24).write_enable);
    gl.bounds_test = true;
    gl.bounds_min = 0.5;
    CHECK(lower_depth(gl, Depth24).bounds_min == 0x800000);
    CHECK(lower_depth(gl, {.depth_bits = 16}).bounds_min == 0x8000);
    CHECK(lower_depth(gl, {.depth_bits = 16}).bounds_max == 0xffff);
}

TEST_CASE("Comparisons and stencil operations keep their meaning") {
    const std::pair<GLenum, Compare> comparisons[] = {{GL_NEVER, Compare::Never},
                                                      {GL_LESS, Compare::Less},
                                                      {GL_EQUAL, Compare::Equal},
                                                      {GL_LEQUAL, Compare::Lequal},
                                                      {GL_GREATER, Compare::Greater},
                                                      {GL_NOTEQUAL, Compare::Notequal},
                                                      {GL_GEQUAL, Compare::Gequal},
                                                      {GL_ALWAYS, Compare::Always}};
    for (const auto& [gl, compare] : comparisons)
        CHECK(lower_depth({.func = gl}, Depth24).compare == compare);
    const std::pair<GLenum, StencilOp> operations[] = {{GL_KEEP, StencilOp::Keep},
                                                       {GL_ZERO, StencilOp::Zero},
                                                       {GL_REPLACE, StencilOp::Replace},
                                                       {GL_INCR, StencilOp::Increment},
                                                       {GL_DECR, StencilOp::Decrement},
                                                       {GL_INVERT, StencilOp::Invert},
                                                       {GL_INCR_WRAP, StencilOp::IncrementWrap},
                                                       {GL_DECR_WRAP, StencilOp::DecrementWrap}};
    for (const auto& [gl, operation] : operations) {
        StencilState state{.enable = true};
        state.front.depth_pass = gl;
        CHECK(lower_stencil(state, Depth24).front.depth_pass == operation);
    }
}

TEST_CASE("Stencil references are clamped to 8 bits, masks cut, and faces chosen") {
    StencilState gl{.enable = true};
    gl.front.reference = 300;
    gl.front.compare_mask = 0x1ff;
    gl.back.reference = -5;
    gl.two_side_back.reference = 7;
    Stencil registers = lower_stencil(gl, Depth24);
    CHECK(registers.enable);
    CHECK(registers.front.reference == 255);
    CHECK(registers.front.compare_mask == 0xff);
    CHECK(registers.back.reference == 0);
    gl.two_side = true;
    CHECK(lower_stencil(gl, Depth24).back.reference == 7);
    CHECK(!lower_stencil(gl, {.depth_bits = 16}).enable);
}

TEST_CASE("Each blend factor and equation is lowered to its own") {
    const std::pair<GLenum, BlendFactor> factors[] = {
        {GL_ZERO, BlendFactor::Zero},
        {GL_ONE, BlendFactor::One},
        {GL_SRC_COLOR, BlendFactor::SourceColor},
        {GL_ONE_MINUS_SRC_COLOR, BlendFactor::OneMinusSourceColor},
        {GL_DST_COLOR, BlendFactor::DestinationColor},
        {GL_ONE_MINUS_DST_COLOR, BlendFactor::OneMinusDestinationColor},
        {GL_SRC_ALPHA, BlendFactor::SourceAlpha},
        {GL_ONE_MINUS_SRC_ALPHA, BlendFactor::OneMinusSourceAlpha},
        {GL_DST_ALPHA, BlendFactor::DestinationAlpha},
        {GL_ONE_MINUS_DST_ALPHA, BlendFactor::OneMinusDestinationAlpha},
        {GL_CONSTANT_COLOR, BlendFactor::ConstantColor},
        {GL_ONE_MINUS_CONSTANT_COLOR, BlendFactor::OneMinusConstantColor},
        {GL_CONSTANT_ALPHA, BlendFactor::ConstantAlpha},
        {GL_ONE_MINUS_CONSTANT_ALPHA, BlendFactor::OneMinusConstantAlpha},
        {GL_SRC_ALPHA_SATURATE, BlendFactor::SourceAlphaSaturate}};
    const std::array<bool, 4> all{true, true, true, true};
    for (const auto& [gl, factor] : factors) {
        CHECK(lower_blend({.rgb_source = gl}, all).rgb_source == factor);
        CHECK(lower_blend({.alpha_destination = gl}, all).alpha_destination == factor);
    }
    CHECK(lower_blend({.rgb_equation = GL_MAX}, all).rgb_equation == BlendEquation::Max);
    CHECK(lower_blend({.alpha_equation = GL_FUNC_REVERSE_SUBTRACT}, all).alpha_equation ==
          BlendEquation::ReverseSubtract);
    CHECK(lower_blend({.color = {1, 0, 0.5f, 1}}, all).constant == 0xff8000ffu);
    CHECK(lower_blend({}, {true, false, true, false}).write_mask == 5);
    CHECK(lower_blend({.logic_op = GL_XOR}, all).logic_op == LogicOp::Xor);
    const Blend both = lower_blend({.enable = true, .color_logic_op = true}, all);
    CHECK(both.logic_op_enable);
    CHECK(!both.enable);
}

TEST_CASE("Fog takes its coordinate from where NV_fog_distance and GL_FOG_COORD_SRC say") {
    FogState gl;
    CHECK(lower_fog(gl).mode == FogMode::Off);
    gl.enable = true;
    CHECK(lower_fog(gl).mode == FogMode::Exp);
    CHECK(lower_fog(gl).source == FogCoordinateSource::EyeZ);
    gl.distance_mode = GL_EYE_PLANE;
    CHECK(lower_fog(gl).source == FogCoordinateSource::EyeZSigned);
    gl.distance_mode = GL_EYE_RADIAL_NV;
    CHECK(lower_fog(gl).source == FogCoordinateSource::EyeRadial);
    gl.coordinate_source = GL_FOG_COORD;
    CHECK(lower_fog(gl).source == FogCoordinateSource::Attribute);
}

TEST_CASE("Line and point sizes stay within the device's range") {
    RasterizationState gl;
    gl.line.width = 1000;
    gl.point.size_max = 1e9f;
    gl.point.size_min = 1e8f;
    PrimitiveSetup registers = lower_primitive(gl, {}, GL_FLAT);
    CHECK(registers.line_width == 64);
    CHECK(registers.point_size_max == 256);
    CHECK(registers.point_size_min == 256);
    CHECK(registers.flat_shading);
    gl.line.width = 0.1f;
    CHECK(lower_primitive(gl, {}, GL_SMOOTH).line_width == 1);
}

TEST_CASE("Faces are culled only while GL_CULL_FACE is enabled") {
    RasterizationState gl;
    CHECK(!lower_primitive(gl, {}, GL_SMOOTH).cull_back);
    gl.polygon.cull = true;
    CHECK(lower_primitive(gl, {}, GL_SMOOTH).cull_back);
    CHECK(!lower_primitive(gl, {}, GL_SMOOTH).cull_front);
    gl.polygon.cull_face = GL_FRONT_AND_BACK;
    CHECK(lower_primitive(gl, {}, GL_SMOOTH).cull_front);
    CHECK(lower_primitive(gl, {}, GL_SMOOTH).cull_back);
}

TEST_CASE("The scissor is cut to the target, wherever the application puts it") {
    const auto cut = [](GLint x, GLint y, GLsizei width, GLsizei height) {
        return lower_scissor(
            {.enable = true, .x = x, .y = y, .width = width, .height = height}, 64, 48);
    };
    CHECK(cut(10, 20, 30, 20) == Scissor{10, 20, 30, 20});
    CHECK(cut(-10, -10, 20, 15) == Scissor{0, 0, 10, 5});
    CHECK(cut(60, 40, 2147483647, 2147483647) == Scissor{60, 40, 4, 8});
    CHECK(cut(-2147483647 - 1, 0, 2147483647, 10).width == 0);
    CHECK(cut(100, 0, 5, 10).width == 0);
    CHECK(lower_scissor({.x = 5, .width = 1}, 64, 48) == Scissor{0, 0, 64, 48});
}

TEST_CASE("Depth is clamped instead of clipped where GL says so") {
    StateFixture f;
    CHECK_FALSE(f.drawn().viewport.clamp_depth);
    entry::Enable(GL_DEPTH_CLAMP);
    CHECK(f.drawn().viewport.clamp_depth);
    entry::PushAttrib(GL_TRANSFORM_BIT);
    entry::Disable(GL_DEPTH_CLAMP);
    CHECK_FALSE(f.drawn().viewport.clamp_depth);
    entry::PopAttrib();
    CHECK(f.drawn().viewport.clamp_depth);
}

TEST_CASE("The draw buffers choose the colour targets") {
    StateFixture f;
    const Drawable& drawable = f.gl.drawable();
    CHECK(lower_window_targets(drawable, {GL_BACK}).color[0] == drawable.back());
    CHECK(lower_window_targets(drawable, {GL_FRONT}).color[0] == drawable.front());
    CHECK(lower_window_targets(drawable, {GL_NONE}).color[0] == Surface{});
    const Targets both = lower_window_targets(drawable, {GL_FRONT_AND_BACK});
    CHECK(both.color[0] == drawable.back());
    CHECK(both.color[1] == drawable.front());
    CHECK(both.depth == drawable.depth());
    CHECK(lower_window_targets(drawable, {GL_LEFT}) == both);
    CHECK(lower_window_targets(drawable, {GL_NONE, GL_FRONT_LEFT, GL_BACK_LEFT}) == both);
    CHECK(both.color[2] == Surface{});
}

TEST_CASE("A drawable of one buffer is one target, whatever the draw buffers are called") {
    StateFixture f({.double_buffer = false});
    const Drawable& drawable = f.gl.drawable();
    const Targets front = lower_window_targets(drawable, {GL_FRONT});
    CHECK(front.color[0] == drawable.front());
    CHECK(lower_window_targets(drawable, {GL_FRONT_AND_BACK}) == front);
    CHECK(lower_window_targets(drawable, {GL_BACK_LEFT, GL_FRONT_LEFT}) == front);
}

TEST_CASE("A draw sends only the registers that changed") {
    StateFixture f;
    f.drawn();
    f.device.forget();
    f.drawn();
    CHECK(f.device.written.empty());
    entry::DepthFunc(GL_GREATER);
    entry::Enable(GL_DEPTH_TEST);
    CHECK(f.drawn().depth.compare == Compare::Greater);
    CHECK(f.device.written == std::vector{find_register_address<&Registers::depth>()});
    f.device.forget();
    entry::DepthFunc(GL_GREATER);
    f.drawn();
    CHECK(f.device.written.empty());
}

TEST_CASE("A swap and a new size of the drawable reach the targets of the next draw") {
    StateFixture f;
    const Surface before = f.drawn().targets.color[0];
    f.gl.drawable().swap(SwapMode::Exchange);
    CHECK(f.drawn().targets.color[0] == f.gl.drawable().back());
    CHECK(f.drawn().targets.color[0] != before);
    f.gl.drawable().resize(100, 20);
    CHECK(f.drawn().targets.color[0].width == 100);
    CHECK(f.drawn().scissor == Scissor{0, 0, 100, 20});
}

TEST_CASE("A context that becomes current after another sends all of its registers") {
    StateFixture f;
    f.drawn();
    OffscreenContext other(f.device,
                           {.width = 8, .height = 8, .format = {}, .shared = f.gl.shared()});
    other.make_current();
    entry::LineWidth(5);
    other.context().prepare_draw();
    other.context().submit({});
    CHECK(f.device.registers.primitive.line_width == 5);
    f.gl.make_current();
    CHECK(f.drawn().primitive.line_width == 1);
    CHECK(f.drawn().targets.color[0].width == 64);
}

} // namespace ffgpu::gl
