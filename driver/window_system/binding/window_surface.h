// WindowSurface: what GLX and EGL call a drawable or surface: a window, a pixmap or an off-screen
// buffer, with its colour, depth and stencil in the device's memory.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "driver/window_system/x11/x_target.h"

#include <memory>

namespace ffgpu::gl {

class WindowSurface {
public:
    // Off-screen. Throws std::bad_alloc if device memory is full; so do all that may resize.
    WindowSurface(const PixelFormat& format, Size size);
    // Shown in a window or pixmap.
    WindowSurface(const PixelFormat& format, std::unique_ptr<XTarget> target);

    gl::Drawable& drawable() { return drawable_; }
    const PixelFormat& format() const { return drawable_.format(); }
    Size size() const { return {drawable_.width(), drawable_.height()}; }
    XTarget* target() { return target_.get(); }

    // Takes the size of the window. False: it is gone.
    bool follow_window();
    // The same, at most once between two swaps.
    void follow_window_once();

    // The back buffer becomes the picture that is seen. Of a single-buffered surface: shows it.
    void swap();

    // Shows the front buffer, if something may have been drawn there.
    void show_front();
    // Something was drawn there that is not shown yet.
    void touch_front() { front_touched_ = true; }

    // How it is named by the window system above.
    XID id = 0;
    int config_id = 0;
    bool bound = false; // to a context in some thread
    bool swaps = true;  // false: of a pixmap, where a swap does nothing (GLX 1.4, 3.3.10)

private:
    void show();

    std::unique_ptr<XTarget> target_;
    Size window_size_;
    gl::Drawable drawable_;
    bool size_is_fresh_ = false;
    bool front_touched_ = false;
};

} // namespace ffgpu::gl
