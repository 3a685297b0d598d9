#include "driver/trace/player/window_system.h"

#include "driver/context/current.h"
#include "model/device/layout/limits.h"

#include <algorithm>

namespace ffgpu::trace {
namespace {

// Until a viewport or scissor tells better.
constexpr unsigned FirstSize = 1;

} // namespace

WindowSystem::WindowSystem(Device& device,
                           unsigned samples,
                           gl::SwapMode swap,
                           const gl::ControlPanel& panel)
    : device_(device)
    , format_{.samples = static_cast<std::uint8_t>(samples),
              .supersampling = static_cast<std::uint8_t>(panel.supersampling)}
    , swap_(swap)
    , panel_(panel)
    , memory_(std::make_shared<gl::MemoryAllocator>(0, device.memory_size())) {}

WindowSystem::~WindowSystem() {
    gl::make_current(nullptr, nullptr, nullptr);
    contexts_.clear(); // They know the drawables.
}

// Contexts that share nothing must stay apart, since objects keep the names the program saw.
void WindowSystem::create_context(Handle handle, Handle share) {
    if (handle == 0) return;
    destroy_context(handle); // The program's allocator may use an address again.
    const auto shared = groups_.find(share);
    auto group = share != 0 && shared != groups_.end()
                     ? shared->second
                     : std::make_shared<gl::SharedObjects>(memory_, panel_);
    contexts_[handle] = std::make_unique<gl::Context>(device_, group);
    groups_[handle] = std::move(group);
}

void WindowSystem::destroy_context(Handle handle) {
    if (!contexts_.contains(handle)) return;
    for (auto& [thread, binding] : bindings_) {
        if (binding.context != handle) continue;
        binding = {};
        if (thread == thread_) bind(binding);
    }
    contexts_.erase(handle);
    groups_.erase(handle);
}

void WindowSystem::create_pbuffer(Handle handle, std::int64_t width, std::int64_t height) {
    if (handle == 0) return;
    const auto cut = [](std::int64_t size) {
        return static_cast<unsigned>(std::clamp<std::int64_t>(size, 1, MaxSurfaceSize));
    };
    destroy_drawable(handle);
    windows_[handle] = {
        std::make_unique<gl::Drawable>(device_, *memory_, format_, cut(width), cut(height)), false};
}

void WindowSystem::destroy_drawable(Handle handle) {
    if (!windows_.contains(handle)) return;
    for (auto& [thread, binding] : bindings_) {
        if (binding.draw != handle && binding.read != handle) continue;
        binding.draw = binding.read = 0;
        if (thread == thread_) bind(binding);
    }
    windows_.erase(handle);
}

void WindowSystem::enter_thread(std::uint32_t thread) {
    if (thread == thread_) [[likely]]
        return;
    thread_ = thread;
    bind(bindings_[thread]);
}

void WindowSystem::make_current(std::uint32_t thread, Binding binding) {
    Binding& now = bindings_[thread];
    if (binding == now) return;
    now = binding;
    if (thread == thread_) bind(binding);
}

void WindowSystem::bind(const Binding& binding) {
    gl::Context* const bound = context(binding.context);
    if (!bound) return gl::make_current(nullptr, nullptr, nullptr);
    gl::make_current(bound, drawable(binding.draw), drawable(binding.read));
}

// One that the trace did not see being made gets made now.
gl::Context* WindowSystem::context(Handle handle) {
    if (handle == 0) return nullptr;
    if (!contexts_.contains(handle))
        create_context(handle, groups_.empty() ? 0 : groups_.begin()->first);
    return contexts_[handle].get();
}

gl::Drawable* WindowSystem::drawable(Handle handle) {
    if (handle == 0) return nullptr;
    Window& window = windows_[handle];
    if (!window.drawable)
        window.drawable =
            std::make_unique<gl::Drawable>(device_, *memory_, format_, FirstSize, FirstSize);
    return window.drawable.get();
}

void WindowSystem::grow(std::int64_t width, std::int64_t height) {
    gl::Context* const current = gl::current_context();
    const auto window = windows_.find(bindings_[thread_].draw);
    if (!current || window == windows_.end() || !window->second.grows) return;
    if (current->state.framebuffer.draw_object) return; // It is another picture's size.
    gl::Drawable& drawable = *window->second.drawable;
    const auto larger = [](std::int64_t size, unsigned now) {
        return std::max(now,
                        static_cast<unsigned>(std::clamp<std::int64_t>(size, 1, MaxSurfaceSize)));
    };
    const unsigned new_width = larger(width, drawable.width());
    const unsigned new_height = larger(height, drawable.height());
    if (new_width == drawable.width() && new_height == drawable.height()) return;
    current->flush_vertices();
    drawable.resize(new_width, new_height);
}

void WindowSystem::swap_buffers(Handle handle) {
    if (gl::Context* const current = gl::current_context()) current->flush_vertices();
    shown_.emplace();
    if (const auto window = windows_.find(handle); window != windows_.end()) {
        window->second.drawable->swap(swap_);
        shown_ = window->second.drawable->readable_front();
    }
    CommandStream commands;
    commands.add(Opcode::EndFrame);
    device_.submit(commands);
}

} // namespace ffgpu::trace
