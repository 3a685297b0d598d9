// The context that is current in the calling thread.

#pragma once

namespace ffgpu::gl {

class Context;
class Drawable;

namespace detail {
// Initial-exec: every GL call reads it, and libGL.so.1 is there from the program's start.
extern constinit thread_local Context* current
    __attribute__((visibility("hidden"), tls_model("initial-exec")));
} // namespace detail

// Null where the thread has none; GL commands then do nothing.
inline Context* current_context() {
    return detail::current;
}

// Binds (or with nulls unbinds). The caller keeps the context and the drawables alive. At its first
// binding a context's viewport and scissor take the size of `draw` (GLX 1.4, 3.3.7).
void make_current(Context* context, Drawable* draw, Drawable* read);

} // namespace ffgpu::gl
