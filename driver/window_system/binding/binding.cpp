#include "driver/window_system/binding/binding.h"

#include "driver/context/current.h"
#include "driver/window_system/exports/window_hooks.h"
#include "driver/window_system/turn.h"

#include <algorithm>

#include <pthread.h>

namespace ffgpu::gl {
namespace {

bool draws_to_front(const RenderContext& current, const WindowSurface& surface) {
    const DrawBufferList& buffers = current.context.state.framebuffer.draw_buffers;
    const bool has_back = surface.format().double_buffer;
    return std::any_of(buffers.begin(), buffers.end(), [has_back](GLenum buffer) {
        const bool is_back = has_back && (buffer == GL_BACK || buffer == GL_BACK_LEFT);
        return buffer != GL_NONE && !is_back;
    });
}

void show_front(Binding& binding) {
    if (!binding.draw) return;
    if (draws_to_front(*binding.context, *binding.draw)) binding.draw->touch_front();
    binding.draw->show_front();
}

void set_bound(const Binding& binding, bool bound) {
    if (binding.context) binding.context->bound = bound;
    if (binding.draw) binding.draw->bound = bound;
    if (binding.read) binding.read->bound = bound;
}

// A thread that ends with a context current gives it free.
struct ThreadBinding : Binding {
    ~ThreadBinding() {
        if (!context) return;
        const Turn turn;
        make_current(nullptr, nullptr, nullptr);
        set_bound(*this, false);
        static_cast<Binding&>(*this) = {}; // In the turn: device memory is given back.
    }
};

constinit thread_local ThreadBinding* of_thread = nullptr;

// The calling thread's. It ends with the thread, but stays where the process ends: a key's
// destructor, other than a thread_local variable's, is not called by exit(), whose handlers may
// still draw.
ThreadBinding& thread_binding() {
    static const pthread_key_t key = [] {
        pthread_key_t made{};
        ::pthread_key_create(&made, [](void*) {
            delete of_thread;
            of_thread = nullptr;
        });
        return made;
    }();
    if (!of_thread) {
        of_thread = new ThreadBinding;
        ::pthread_setspecific(key, of_thread);
    }
    return *of_thread;
}

} // namespace

const Binding& current_binding() {
    return thread_binding();
}

void bind(Binding next) {
    ThreadBinding& binding = thread_binding();
    if (next.draw) next.draw->follow_window();
    if (next.read && next.read != next.draw) next.read->follow_window();
    if (binding.context) flush_current();
    set_bound(binding, false);
    Context* const context = next.context ? &next.context->context : nullptr;
    make_current(context,
                 next.draw ? &next.draw->drawable() : nullptr,
                 next.read ? &next.read->drawable() : nullptr);
    if (context) context->on_flush = [] { show_front(thread_binding()); };
    static_cast<Binding&>(binding) = std::move(next);
    set_bound(binding, true);
}

void flush_current() {
    ThreadBinding& binding = thread_binding();
    if (!binding.context) return;
    binding.context->context.flush_vertices();
    show_front(binding);
}

void swap_surface(WindowSurface& surface) {
    const ThreadBinding& binding = thread_binding();
    if (binding.context) binding.context->context.flush_vertices();
    if (surface.swaps) surface.swap();
}

void before_viewport() {
    const ThreadBinding& binding = thread_binding();
    if (!binding.draw) return;
    binding.context->context.flush_vertices();
    binding.draw->follow_window_once();
}

void before_draw_buffer() {
    const ThreadBinding& binding = thread_binding();
    if (!binding.draw || binding.context->context.vertex_phase == VertexPhase::Inside) return;
    binding.context->context.flush_vertices();
    if (draws_to_front(*binding.context, *binding.draw)) binding.draw->touch_front();
}

} // namespace ffgpu::gl
