// WindowSystem: what the window-system calls of a trace (GLX, EGL, WGL, CGL) do: contexts and
// drawables under the handles that the traced program saw, and which is current in which thread.
//
// A trace does not tell what a window looks like, so that each is double-buffered with 8 bits a
// channel, 24 of depth and 8 of stencil, and of as many samples as the player is told: what the
// program asked for was a wish, and its pictures elsewhere may well be single-sampled. It does not
// tell its size either: a window grows to the largest viewport or scissor set on it, and its
// picture stays. A pixel buffer has the size that it was made with.

#pragma once

#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/shared_objects.h"
#include "driver/trace/reader/call.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

namespace ffgpu::trace {

class WindowSystem {
public:
    // `samples`: of a pixel of every window.
    WindowSystem(Device& device,
                 unsigned samples,
                 gl::SwapMode swap,
                 const gl::ControlPanel& panel);
    ~WindowSystem();

    // What carries out the calls of that name; null where there is none.
    using Handler = void (WindowSystem::*)(const Call& call);
    static Handler find(std::string_view name);

    // Calls that have no effect on pictures: queries, choices of visuals, waits.
    static bool is_harmless(std::string_view name);

    // Calls that hand a picture over to the display.
    static bool hands_over(std::string_view name);

    // Makes what is current in that thread of the traced program current here.
    void enter_thread(std::uint32_t thread);

    // The current window is at least that large.
    void grow(std::int64_t width, std::int64_t height);

    // The picture that the last call handed over to the display, if it did. Format None: of a
    // window that was never drawn on.
    std::optional<Surface> take_shown() { return std::exchange(shown_, std::nullopt); }

private:
    using Handle = std::uint64_t;

    struct Window {
        std::unique_ptr<gl::Drawable> drawable;
        bool grows = true;
    };
    struct Binding {
        Handle context = 0, draw = 0, read = 0;
        bool operator==(const Binding&) const = default;
    };

    void create_context(Handle handle, Handle share);
    void destroy_context(Handle handle);
    void create_pbuffer(Handle handle, std::int64_t width, std::int64_t height);
    void destroy_drawable(Handle handle);
    void make_current(std::uint32_t thread, Binding binding);
    void bind(const Binding& binding);
    void swap_buffers(Handle handle);

    gl::Context* context(Handle handle);
    gl::Drawable* drawable(Handle handle);
    bool is_current_somewhere(Handle context) const;

    // By name: what each call's arguments mean.
    void glx_create_context(const Call& call);
    void glx_make_current(const Call& call);
    void glx_make_context_current(const Call& call);
    void glx_destroy_context(const Call& call);
    void glx_create_pbuffer(const Call& call);
    void glx_destroy_drawable(const Call& call);
    void glx_swap_buffers(const Call& call);
    void egl_create_context(const Call& call);
    void egl_make_current(const Call& call);
    void egl_destroy_context(const Call& call);
    void egl_create_pbuffer(const Call& call);
    void egl_destroy_surface(const Call& call);
    void egl_swap_buffers(const Call& call);
    void wgl_create_context(const Call& call);
    void wgl_make_current(const Call& call);
    void wgl_make_context_current(const Call& call);
    void wgl_share_lists(const Call& call);
    void wgl_delete_context(const Call& call);
    void wgl_swap_buffers(const Call& call);
    void cgl_create_context(const Call& call);
    void cgl_set_current_context(const Call& call);
    void cgl_destroy_context(const Call& call);
    void cgl_flush_drawable(const Call& call);

    Device& device_;
    const gl::PixelFormat format_; // of every window
    const gl::SwapMode swap_;
    const gl::ControlPanel panel_;
    std::shared_ptr<gl::MemoryAllocator> memory_;
    std::map<Handle, std::shared_ptr<gl::SharedObjects>> groups_; // by context
    std::map<Handle, std::unique_ptr<gl::Context>> contexts_;
    std::map<Handle, Window> windows_;
    std::map<std::uint32_t, Binding> bindings_; // by thread
    std::uint32_t thread_ = 0;                  // the one that runs
    std::optional<Surface> shown_;
};

} // namespace ffgpu::trace
