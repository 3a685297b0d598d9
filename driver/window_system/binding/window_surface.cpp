#include "driver/window_system/binding/window_surface.h"

#include "driver/window_system/binding/formats.h"
#include "driver/window_system/process_gpu.h"

namespace ffgpu::gl {

WindowSurface::WindowSurface(const PixelFormat& format, Size size)
    : window_size_(size)
    , drawable_(ProcessGpu::instance().device(),
                *ProcessGpu::instance().memory(),
                format,
                size.width,
                size.height) {}

WindowSurface::WindowSurface(const PixelFormat& format, std::unique_ptr<XTarget> target)
    : target_(std::move(target))
    , window_size_(target_->size().value_or(Size{}))
    , drawable_(ProcessGpu::instance().device(),
                *ProcessGpu::instance().memory(),
                format,
                window_size_.width,
                window_size_.height) {}

bool WindowSurface::follow_window() {
    size_is_fresh_ = true;
    if (!target_) return true;
    const auto size = target_->size();
    if (!size) return false;
    window_size_ = *size;
    drawable_.resize(size->width, size->height);
    return true;
}

void WindowSurface::follow_window_once() {
    if (!size_is_fresh_) follow_window();
}

void WindowSurface::swap() {
    drawable_.swap(swap_mode());
    front_touched_ = false;
    ProcessGpu::instance().frame_shown(drawable_.readable_front());
    follow_window();
    show();
    size_is_fresh_ = false;
}

void WindowSurface::show_front() {
    if (!front_touched_) return;
    front_touched_ = false;
    show();
}

void WindowSurface::show() {
    if (!target_) return;
    target_->show(
        drawable_.readable_front(), window_size_, [](DeviceAddress at, std::span<std::byte> bytes) {
            ProcessGpu::instance().read_picture(at, bytes);
        });
}

} // namespace ffgpu::gl
