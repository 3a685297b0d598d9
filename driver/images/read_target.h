// The framebuffer as a source of pixels (GL 1.5, 4.3.2): what glReadPixels, glCopyPixels,
// glCopyTexImage and glBlitFramebuffer read.

#pragma once

#include "driver/gl_types.h"
#include "driver/pixel/pixel_transfer.h"
#include "model/device/device.h"
#include "model/device/registers/fragment.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {

class DeviceContext;
class Drawable;

struct ReadTarget {
    GLenum status = GL_FRAMEBUFFER_COMPLETE; // or why nothing can be read
    Surface color{};                         // what glReadBuffer selects; format None: nothing
    Surface depth{};                         // format None: neither depth nor stencil
    bool has_depth = false;
    bool has_stencil = false;
    Drawable* window = nullptr; // that they are of; null: they are a framebuffer object's

    // Of a window that is several pictures; `color` and `depth` are the first's.
    bool is_supersampled() const;

    // Why single pixels cannot be read, or GL_NO_ERROR: GL_INVALID_FRAMEBUFFER_OPERATION where
    // nothing can; GL_INVALID_OPERATION of a multisampled framebuffer object
    // (EXT_framebuffer_multisample).
    GLenum pixels_error() const;

    // The surfaces with one sample a pixel: those of a multisampled or supersampled window are
    // resolved. Only where pixels can be read.
    Surface pixel_colors() const;
    Surface pixel_depths() const;
};

ReadTarget find_read_target(DeviceContext& context);

// A rectangle of pixels; it may lie outside the surface in part.
struct PixelRectangle {
    std::int64_t x = 0, y = 0;
    std::int64_t width = 0, height = 0;

    bool empty() const { return width <= 0 || height <= 0; }
    bool operator==(const PixelRectangle&) const = default;
};

// The part that lies inside the surface.
PixelRectangle clip_to(const Surface& surface, PixelRectangle rectangle);

// Pixels of a surface, which the rectangle lies in, in the surface's format, tightly packed.
std::vector<std::byte>
read_surface(Device& device, const Surface& surface, const PixelRectangle& rectangle);

// Writes such pixels back.
void write_surface(Device& device,
                   const Surface& surface,
                   const PixelRectangle& rectangle,
                   const std::vector<std::byte>& pixels);

} // namespace ffgpu::gl
