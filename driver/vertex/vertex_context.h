// VertexContext: a device context with the way of vertices to the device.

#pragma once

#include "driver/device_context/device_context.h"

#include <memory>

namespace ffgpu::gl {

class VertexAssembler;   // driver/vertex/vertex_assembler.h
class ImmediateVertices; // driver/vertex/immediate_vertices.h: glBegin/glEnd -> draws
class DrawPath;          // driver/vertex/draw_path.h: vertices -> device
class RenderModes;       // driver/feedback/render_modes.h: selection and feedback

class VertexContext : public DeviceContext {
public:
    VertexContext(Device& device, std::shared_ptr<SharedObjects> shared);
    ~VertexContext();

    // Where the commands of vertices go: to the immediate mode, or to the list being compiled.
    VertexAssembler& vertices() { return *vertices_; }
    void redirect_vertices(VertexAssembler& to) { vertices_ = &to; }
    ImmediateVertices& immediate() { return *immediate_; }
    DrawPath& draw_path() { return *draw_path_; }
    RenderModes& render_modes() { return *render_modes_; }

    // Vertices merged across glBegin/glEnd pairs are drawn now. Every command that changes state
    // which a draw depends on, or reads back, calls it first (the dispatcher does it for all
    // commands but those of vertices: see driver/entry_points/dispatch.h).
    void flush_vertices();

    // Before a command that is not a vertex's: false, with the error recorded, between glBegin and
    // glEnd; else what waits is drawn.
    bool settle_vertices() {
        if (vertex_phase == VertexPhase::Idle) [[likely]]
            return true;
        if (fails_inside_begin()) return false;
        flush_vertices();
        return true;
    }

private:
    std::unique_ptr<RenderModes> render_modes_;
    std::unique_ptr<DrawPath> draw_path_;
    std::unique_ptr<ImmediateVertices> immediate_;
    VertexAssembler* vertices_;
};

} // namespace ffgpu::gl
