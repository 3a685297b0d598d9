#include "driver/vertex/vertex_context.h"

#include "driver/feedback/render_modes.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/immediate_vertices.h"

#include <utility>

namespace ffgpu::gl {

VertexContext::VertexContext(Device& device, std::shared_ptr<SharedObjects> shared)
    : DeviceContext(device, std::move(shared))
    , render_modes_(std::make_unique<RenderModes>(*this))
    , draw_path_(std::make_unique<DrawPath>(*this))
    , immediate_(std::make_unique<ImmediateVertices>(*this))
    , vertices_(immediate_.get()) {}

VertexContext::~VertexContext() = default;

void VertexContext::flush_vertices() {
    if (vertex_phase == VertexPhase::Pending) immediate_->flush();
    // A command that is legal there changes what the vertices so far were made with.
    if (vertex_phase == VertexPhase::Inside) immediate_->cut();
}

} // namespace ffgpu::gl
