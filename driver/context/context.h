// Context: one GL rendering context. It holds the state, knows the device, and lowers the one to
// the registers of the other before each draw. The GL commands themselves are the functions of
// ffgpu::gl::api (driver/api/, a file a chapter).

#pragma once

#include "driver/context/attribute_stack.h"
#include "driver/context/dirty.h"
#include "driver/context/register_file.h"
#include "driver/gl_types.h"
#include "driver/lower/targets.h"
#include "driver/memory_allocator.h"
#include "driver/objects/name_table.h"
#include "driver/objects/query_objects.h"
#include "driver/state/state.h"
#include "model/device/device.h"

#include <functional>
#include <memory>

namespace ffgpu::gl {

class Drawable;          // driver/framebuffer/drawable.h: the window's or off-screen surface set
class VertexAssembler;   // driver/vertex/vertex_assembler.h
class ImmediateVertices; // driver/vertex/immediate_vertices.h: glBegin/glEnd -> draws
class DrawPath;          // driver/vertex/draw_path.h: vertices -> device
class ListCompiler;      // driver/lists/
class RenderModes;       // driver/feedback/render_modes.h: selection and feedback
struct SharedObjects;    // driver/objects/shared_objects.h: textures, buffers, lists, renderbuffers

// Where the context stands between glBegin and glEnd.
enum class VertexPhase : std::uint8_t {
    Idle,    // outside; nothing waits
    Pending, // outside; vertices wait to be merged with the next primitive
    Inside,  // between glBegin and glEnd
};

class Context {
public:
    // `shared` may be another context's (glXCreateContext's share list). The context is not
    // bound to a drawable yet; see make_current in driver/context/current.h.
    Context(Device& device, std::shared_ptr<SharedObjects> shared);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    State state;
    ClientState client;
    DirtyGroups dirty = DirtyGroups::all();
    bool was_bound = false; // to a drawable: viewport and scissor have their initial values.
    AttributeStack attributes;
    // The window system's: shows what was drawn to a front buffer, at glFlush and glFinish.
    std::function<void()> on_flush;
    QueryObjects queries;

    // Vertex array objects are not shared. Name 0 is an object, too.
    NameTable<VertexArrayObject> vertex_array_objects;
    const std::shared_ptr<VertexArrayObject> default_vertex_array_object = client.arrays.object;

    // What the device's registers must hold for the next command. prepare_draw() fills and updates
    // all but vertex_format and current, which are the draw path's.
    RegisterFile registers;

    Device& device() { return device_; }
    SharedObjects& shared() { return *shared_; }
    // Where the commands of vertices go: to the immediate mode, or to the list being compiled.
    VertexAssembler& vertices() { return *vertices_; }
    void redirect_vertices(VertexAssembler& to) { vertices_ = &to; }
    ImmediateVertices& immediate() { return *immediate_; }
    DrawPath& draw_path() { return *draw_path_; }
    ListCompiler& lists() { return *lists_; }
    RenderModes& render_modes() { return *render_modes_; }

    // Null where the context was made current without a drawable.
    Drawable* draw_drawable() { return draw_drawable_; }
    Drawable* read_drawable() { return read_drawable_; }
    void set_drawables(Drawable* draw, Drawable* read);

    // Records an error: the first one stays until glGetError reads it (GL 1.5, 2.5). The command
    // that failed has no other effect: `return context.error(GL_INVALID_ENUM);`
    void error(GLenum code);
    GLenum take_error();

    // Between glBegin and glEnd most commands are errors: `if (context.fails_inside_begin())
    // return;` records GL_INVALID_OPERATION and says true there. (The dispatcher has seen to it for
    // calls that come through an entry point.)
    bool fails_inside_begin() {
        if (vertex_phase != VertexPhase::Inside) [[likely]]
            return false;
        error(GL_INVALID_OPERATION);
        return true;
    }
    VertexPhase vertex_phase = VertexPhase::Idle; // Set by ImmediateVertices.

    // Before a command that is not a vertex's: false, with the error recorded, between glBegin and
    // glEnd; else what waits is drawn.
    bool settle_vertices() {
        if (vertex_phase == VertexPhase::Idle) [[likely]]
            return true;
        if (fails_inside_begin()) return false;
        flush_vertices();
        return true;
    }

    // Lowers what is dirty to registers.wanted, whether or not something can be drawn, and notes
    // the registers that changed in registers.pending().
    void lower_state();

    // Lowers what is dirty. False: nothing can be drawn (incomplete framebuffer: the error is
    // recorded; empty drawable).
    bool prepare_draw();

    // What prepare_draw() or lower_state() found to draw to.
    const DrawTarget& draw_target() const { return draw_target_; }

    // Sends registers.pending(), then `commands`, after everything before them.
    void submit(const CommandStream& commands);

    // Vertices merged across glBegin/glEnd pairs are drawn now. Every command that changes state
    // which a draw depends on, or reads back, calls it first (the dispatcher does it for all
    // commands but those of vertices: see driver/entry_points/dispatch.h).
    void flush_vertices();

private:
    Device& device_;
    std::shared_ptr<SharedObjects> shared_;
    std::unique_ptr<DrawPath> draw_path_;
    std::unique_ptr<RenderModes> render_modes_;
    std::unique_ptr<ImmediateVertices> immediate_;
    VertexAssembler* vertices_;
    std::unique_ptr<ListCompiler> lists_;
    Drawable* draw_drawable_ = nullptr;
    Drawable* read_drawable_ = nullptr;
    GLenum error_ = GL_NO_ERROR;
    DrawTarget draw_target_;           // As it was lowered last,
    unsigned drawable_generation_ = 0; // with this Drawable::generation().
};

} // namespace ffgpu::gl
