// Fog and the per-fragment operations (GL 1.5, 3.10 and 4.1; state tables 6.8, 6.18 and 6.19).

#pragma once

#include "driver/gl_types.h"
#include "model/device/registers/geometry.h"

#include <array>

namespace ffgpu::gl {

struct FogState { // GL_FOG_BIT
    bool enable = false;
    GLenum mode = GL_EXP;
    Vec4 color{0, 0, 0, 0};
    float density = 1;
    float start = 0;
    float end = 1;
    float index = 0;
    GLenum coordinate_source = GL_FRAGMENT_DEPTH;
    GLenum distance_mode = GL_EYE_PLANE_ABSOLUTE_NV; // NV_fog_distance
    bool color_sum = false;
};

struct ScissorState { // GL_SCISSOR_BIT
    bool enable = false;
    GLint x = 0, y = 0;
    GLsizei width = 0, height = 0; // of the first drawable
};

struct AlphaTestState { // GL_COLOR_BUFFER_BIT, as the blend state
    bool enable = false;
    GLenum func = GL_ALWAYS;
    float reference = 0;
};

struct BlendState {
    bool enable = false;
    GLenum rgb_source = GL_ONE;
    GLenum rgb_destination = GL_ZERO;
    GLenum alpha_source = GL_ONE;
    GLenum alpha_destination = GL_ZERO;
    GLenum rgb_equation = GL_FUNC_ADD;
    GLenum alpha_equation = GL_FUNC_ADD;
    Vec4 color{0, 0, 0, 0};
    bool color_logic_op = false;
    bool index_logic_op = false;
    GLenum logic_op = GL_COPY;
    bool dither = true;
    bool framebuffer_srgb = false; // EXT_framebuffer_sRGB
};

struct StencilFaceState {
    GLenum func = GL_ALWAYS;
    GLint reference = 0;
    GLuint compare_mask = ~GLuint{0};
    GLuint write_mask = ~GLuint{0};
    GLenum fail = GL_KEEP;
    GLenum depth_fail = GL_KEEP;
    GLenum depth_pass = GL_KEEP;
};

// GL_STENCIL_BUFFER_BIT. The two extensions keep their back faces apart: glStencilFunc sets front
// and back of ATI_separate_stencil, but the active face alone of EXT_stencil_two_side, whose back
// face is in force only while GL_STENCIL_TEST_TWO_SIDE_EXT is enabled.
struct StencilState {
    bool enable = false;
    bool two_side = false;
    GLenum active_face = GL_FRONT;
    StencilFaceState front{};
    StencilFaceState back{};          // ATI_separate_stencil
    StencilFaceState two_side_back{}; // EXT_stencil_two_side
    GLint clear_value = 0;
};

struct DepthState { // GL_DEPTH_BUFFER_BIT
    bool enable = false;
    GLenum func = GL_LESS;
    bool write_mask = true;
    double clear_value = 1;
    bool bounds_test = false; // EXT_depth_bounds_test
    double bounds_min = 0, bounds_max = 1;
};

struct FragmentState {
    FogState fog;
    ScissorState scissor;
    AlphaTestState alpha_test;
    BlendState blend;
    StencilState stencil;
    DepthState depth;
};

} // namespace ffgpu::gl
