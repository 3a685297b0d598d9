// DeviceContext: a context as far as the device is concerned. It holds the state, knows what is
// drawn to, and lowers both to the device's registers before each draw.

#pragma once

#include "driver/device_context/draw_target.h"
#include "driver/device_context/register_file.h"
#include "driver/gl_types.h"
#include "driver/objects/query_objects.h"
#include "driver/state/dirty.h"
#include "driver/state/state.h"
#include "model/device/device.h"

#include <memory>

namespace ffgpu::gl {

class Drawable;       // driver/framebuffer/drawable.h: the window's or off-screen surface set
struct DeviceMemory;  // driver/texture/residency.h
struct SharedObjects; // driver/objects/shared_objects.h: textures, buffers, lists, renderbuffers

// Where the context stands between glBegin and glEnd.
enum class VertexPhase : std::uint8_t {
    Idle,    // outside; nothing waits
    Pending, // outside; vertices wait to be merged with the next primitive
    Inside,  // between glBegin and glEnd
};

class DeviceContext {
public:
    DeviceContext(Device& device, std::shared_ptr<SharedObjects> shared);
    ~DeviceContext();
    DeviceContext(const DeviceContext&) = delete;
    DeviceContext& operator=(const DeviceContext&) = delete;

    State state;
    ClientState client;
    DirtyGroups dirty = DirtyGroups::all();
    QueryObjects queries;
    VertexPhase vertex_phase = VertexPhase::Idle; // Set by ImmediateVertices.

    // What the device's registers must hold for the next command. prepare_draw() fills and updates
    // all but vertex_format and current, which are the draw path's.
    RegisterFile registers;

    Device& device() { return device_; }
    SharedObjects& shared() { return *shared_; }
    DeviceMemory device_memory();

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

    // The same of commands that write to what prepare_draw() found: to each picture of a
    // supersampled window.
    void submit_drawing(const CommandStream& commands);

private:
    Device& device_;
    std::shared_ptr<SharedObjects> shared_;
    Drawable* draw_drawable_ = nullptr;
    Drawable* read_drawable_ = nullptr;
    GLenum error_ = GL_NO_ERROR;
    DrawTarget draw_target_;           // As it was lowered last,
    unsigned drawable_generation_ = 0; // with this Drawable::generation().
};

} // namespace ffgpu::gl
