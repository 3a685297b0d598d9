// Per-fragment operations (GL 1.5, state tables 6.18 and 6.19).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl {
namespace {

const StencilFaceState& active_face(const State& state) {
    const StencilState& stencil = state.fragment.stencil;
    return stencil.active_face == GL_BACK ? stencil.two_side_back : stencil.front;
}

} // namespace

std::span<const StateVariable> fragment_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_SCISSOR_BOX,
                    integer(s.fragment.scissor.x,
                            s.fragment.scissor.y,
                            s.fragment.scissor.width,
                            s.fragment.scissor.height)),
        FFGPU_STATE(GL_ALPHA_TEST_FUNC, integer(s.fragment.alpha_test.func)),
        FFGPU_STATE(GL_ALPHA_TEST_REF, normalized(s.fragment.alpha_test.reference)),
        // The active face's, as EXT_stencil_two_side has it.
        FFGPU_STATE(GL_STENCIL_FUNC, integer(active_face(s).func)),
        FFGPU_STATE(GL_STENCIL_VALUE_MASK, integer(active_face(s).compare_mask)),
        FFGPU_STATE(GL_STENCIL_REF, integer(std::clamp(active_face(s).reference, 0, 255))),
        FFGPU_STATE(GL_STENCIL_FAIL, integer(active_face(s).fail)),
        FFGPU_STATE(GL_STENCIL_PASS_DEPTH_FAIL, integer(active_face(s).depth_fail)),
        FFGPU_STATE(GL_STENCIL_PASS_DEPTH_PASS, integer(active_face(s).depth_pass)),
        FFGPU_STATE(GL_STENCIL_WRITEMASK, integer(active_face(s).write_mask)),
        FFGPU_STATE(GL_STENCIL_BACK_FUNC_ATI, integer(s.fragment.stencil.back.func)),
        FFGPU_STATE(GL_STENCIL_BACK_FAIL_ATI, integer(s.fragment.stencil.back.fail)),
        FFGPU_STATE(GL_STENCIL_BACK_PASS_DEPTH_FAIL_ATI,
                    integer(s.fragment.stencil.back.depth_fail)),
        FFGPU_STATE(GL_STENCIL_BACK_PASS_DEPTH_PASS_ATI,
                    integer(s.fragment.stencil.back.depth_pass)),
        FFGPU_STATE(GL_ACTIVE_STENCIL_FACE_EXT, integer(s.fragment.stencil.active_face)),
        FFGPU_STATE(GL_DEPTH_FUNC, integer(s.fragment.depth.func)),
        FFGPU_STATE(GL_DEPTH_BOUNDS_EXT,
                    normalized(s.fragment.depth.bounds_min, s.fragment.depth.bounds_max)),
        FFGPU_STATE(GL_BLEND_SRC, integer(s.fragment.blend.rgb_source)),
        FFGPU_STATE(GL_BLEND_DST, integer(s.fragment.blend.rgb_destination)),
        FFGPU_STATE(GL_BLEND_SRC_RGB, integer(s.fragment.blend.rgb_source)),
        FFGPU_STATE(GL_BLEND_DST_RGB, integer(s.fragment.blend.rgb_destination)),
        FFGPU_STATE(GL_BLEND_SRC_ALPHA, integer(s.fragment.blend.alpha_source)),
        FFGPU_STATE(GL_BLEND_DST_ALPHA, integer(s.fragment.blend.alpha_destination)),
        FFGPU_STATE(GL_BLEND_EQUATION, integer(s.fragment.blend.rgb_equation)),
        FFGPU_STATE(GL_BLEND_EQUATION_ALPHA, integer(s.fragment.blend.alpha_equation)),
        FFGPU_STATE(GL_BLEND_COLOR, normalized(s.fragment.blend.color)),
        FFGPU_STATE(GL_LOGIC_OP_MODE, integer(s.fragment.blend.logic_op)),
    };
    return Table;
}

} // namespace ffgpu::gl
