#include "driver/context/context.h"

#include "driver/feedback/render_modes.h"
#include "driver/lists/list_compiler.h"
#include "driver/objects/shared_objects.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/immediate_vertices.h"

#include <utility>

namespace ffgpu::gl {

Context::Context(Device& device, std::shared_ptr<SharedObjects> shared)
    : device_(device)
    , shared_(std::move(shared))
    , draw_path_(std::make_unique<DrawPath>(*this))
    , render_modes_(std::make_unique<RenderModes>(*this))
    , immediate_(std::make_unique<ImmediateVertices>(*this))
    , vertices_(immediate_.get())
    , lists_(std::make_unique<ListCompiler>(*this)) {}

Context::~Context() = default;

void Context::set_drawables(Drawable* draw, Drawable* read) {
    draw_drawable_ = draw;
    read_drawable_ = read;
}

void Context::error(GLenum code) {
    if (error_ == GL_NO_ERROR) error_ = code;
}

GLenum Context::take_error() {
    return std::exchange(error_, GL_NO_ERROR);
}

void Context::submit(const CommandStream& commands) {
    CommandStream& pending = registers.pending();
    if (!pending.empty()) {
        device_.submit(pending);
        pending.clear();
    }
    device_.submit(commands);
}

void Context::flush_vertices() {
    if (vertex_phase == VertexPhase::Pending) immediate_->flush();
    // A command that is legal there changes what the vertices so far were made with.
    if (vertex_phase == VertexPhase::Inside) immediate_->cut();
}

} // namespace ffgpu::gl
