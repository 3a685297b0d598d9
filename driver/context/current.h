// The context that is current in the calling thread.

#pragma once

namespace ffgpu::gl {

class Context;
class Drawable;

// Null where the thread has none; GL commands then do nothing.
Context* current_context();

// Binds (or with nulls unbinds). The caller keeps the context and the drawables alive. At its first
// binding a context's viewport and scissor take the size of `draw` (GLX 1.4, 3.3.7).
void make_current(Context* context, Drawable* draw, Drawable* read);

} // namespace ffgpu::gl
