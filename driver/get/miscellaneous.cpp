// Evaluators, lists, selection, feedback and the stacks (GL 1.5, state tables 6.28 to 6.35).

#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/get/state_variable.h"
#include "driver/lists/list_compiler.h"

#include <array>

namespace ffgpu::gl {
namespace {

StateValue grid2_domain(const EvaluatorSettings& settings) {
    const auto& [u, v] = settings.grid2;
    return values::real(u.from, u.to, v.from, v.to);
}

} // namespace

std::span<const StateVariable> miscellaneous_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_MAP1_GRID_DOMAIN,
                    real(s.evaluator.settings.grid1.from, s.evaluator.settings.grid1.to)),
        FFGPU_STATE(GL_MAP1_GRID_SEGMENTS, integer(s.evaluator.settings.grid1.segments)),
        FFGPU_STATE(GL_MAP2_GRID_DOMAIN, grid2_domain(s.evaluator.settings)),
        FFGPU_STATE(GL_MAP2_GRID_SEGMENTS,
                    integer(s.evaluator.settings.grid2[0].segments,
                            s.evaluator.settings.grid2[1].segments)),
        FFGPU_STATE(GL_LIST_BASE, integer(c.lists().base)),
        FFGPU_STATE(GL_LIST_INDEX, integer(c.lists().name())),
        FFGPU_STATE(GL_LIST_MODE, integer(c.lists().mode())),
        FFGPU_STATE(GL_RENDER_MODE, integer(c.render_modes().mode())),
        FFGPU_STATE(GL_SELECTION_BUFFER_SIZE, integer(c.render_modes().selection.buffer_size())),
        FFGPU_STATE(GL_NAME_STACK_DEPTH, integer(c.render_modes().selection.names().size())),
        FFGPU_STATE(GL_FEEDBACK_BUFFER_SIZE, integer(c.render_modes().feedback.buffer_size())),
        FFGPU_STATE(GL_FEEDBACK_BUFFER_TYPE, integer(c.render_modes().feedback.type())),
        FFGPU_STATE(GL_ATTRIB_STACK_DEPTH, integer(c.attributes.depth())),
        FFGPU_STATE(GL_CLIENT_ATTRIB_STACK_DEPTH, integer(c.attributes.client_depth())),
    };
    return Table;
}

} // namespace ffgpu::gl
