// XTarget: an X window or pixmap that pictures are shown in, by the shared-memory extension where
// the server can, else through the connection.

#pragma once

#include "driver/window_system/x11/xlib.h"
#include "model/device/device.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ffgpu::gl {

struct Size {
    unsigned width = 0, height = 0;
    bool operator==(const Size&) const = default;
};

class XTarget {
public:
    XTarget(Display* display, XID drawable);
    ~XTarget();
    XTarget(const XTarget&) = delete;
    XTarget& operator=(const XTarget&) = delete;

    Display* display() const { return display_; }
    XID drawable() const { return drawable_; }
    // The window is gone or the connection closes: from now on X is not called any more.
    void abandon();

    // Asks the server. Nothing: the drawable does not exist (any more).
    std::optional<Size> size();

    // Copies the picture's lower left corner to that of the drawable of `size`; `read` gets its
    // rows from device memory.
    using Read = std::function<void(DeviceAddress at, std::span<std::byte> bytes)>;
    void show(const Surface& picture, Size size, const Read& read);

private:
    struct Pixels; // an XImage with its memory
    Pixels& pixels(Size size);
    void free_graphics();

    Display* display_; // Null once abandoned.
    XID drawable_;
    const Visual* visual_ = nullptr;
    int depth_ = 0;
    GC graphics_ = nullptr;
    std::unique_ptr<Pixels> pixels_;
    std::vector<std::byte> rows_; // of the picture, as the device has them
};

} // namespace ffgpu::gl
