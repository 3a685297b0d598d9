// Transformation state (GL 1.5, state table 6.7).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"
#include "driver/math/matrix.h"

#include <array>

namespace ffgpu::gl {
namespace {

const MatrixStack& texture_stack(const State& state) {
    return state.transform.matrices.texture[state.texture.active_unit];
}

StateValue viewport(const ViewportState& state) {
    return values::integer(state.x, state.y, state.width, state.height);
}

} // namespace

std::span<const StateVariable> transform_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_MODELVIEW_MATRIX, real(s.transform.matrices.model_view.top())),
        FFGPU_STATE(GL_PROJECTION_MATRIX, real(s.transform.matrices.projection.top())),
        FFGPU_STATE(GL_TEXTURE_MATRIX, real(texture_stack(s).top())),
        FFGPU_STATE(GL_TRANSPOSE_MODELVIEW_MATRIX,
                    real(transpose(s.transform.matrices.model_view.top()))),
        FFGPU_STATE(GL_TRANSPOSE_PROJECTION_MATRIX,
                    real(transpose(s.transform.matrices.projection.top()))),
        FFGPU_STATE(GL_TRANSPOSE_TEXTURE_MATRIX, real(transpose(texture_stack(s).top()))),
        FFGPU_STATE(GL_MODELVIEW_STACK_DEPTH, integer(s.transform.matrices.model_view.depth())),
        FFGPU_STATE(GL_PROJECTION_STACK_DEPTH, integer(s.transform.matrices.projection.depth())),
        FFGPU_STATE(GL_TEXTURE_STACK_DEPTH, integer(texture_stack(s).depth())),
        FFGPU_STATE(GL_MATRIX_MODE, integer(s.transform.group.matrix_mode)),
        FFGPU_STATE(GL_VIEWPORT, viewport(s.transform.viewport)),
        FFGPU_STATE(GL_DEPTH_RANGE,
                    normalized(s.transform.viewport.near_depth, s.transform.viewport.far_depth)),
    };
    return Table;
}

} // namespace ffgpu::gl
