// Binding: what is current in a thread, whether GLX or EGL made it so. It keeps context and
// surfaces alive after they are destroyed by name (GLX 1.4, 3.3.7).

#pragma once

#include "driver/window_system/binding/render_context.h"
#include "driver/window_system/binding/window_surface.h"

#include <memory>

namespace ffgpu::gl {

struct Binding {
    std::shared_ptr<RenderContext> context; // null: none is current
    std::shared_ptr<WindowSurface> draw, read;
};

// The calling thread's.
const Binding& current_binding();

// In a Turn. What was current before is flushed. Throws std::bad_alloc if a window has grown beyond
// device memory; the binding is then what it was.
void bind(Binding next);

// What glFlush does for the calling thread, for window-system calls that imply it.
void flush_current();

// Swaps, and draws what was called for before if the surface is the current one.
void swap_surface(WindowSurface& surface);

} // namespace ffgpu::gl
