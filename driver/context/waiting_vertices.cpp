#include "driver/context/waiting_vertices.h"

#include "driver/context/context.h"
#include "driver/context/current.h"
#include "driver/vertex/immediate_vertices.h"

namespace ffgpu::gl {

bool vertices_wait() {
    const Context* const context = current_context();
    return context && context->vertex_phase != VertexPhase::Idle;
}

std::uint32_t waiting_vertices() {
    return vertices_wait() ? current_context()->immediate().count() : 0;
}

} // namespace ffgpu::gl
