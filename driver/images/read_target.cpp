#include "driver/images/read_target.h"

#include "driver/device_context/device_context.h"
#include "driver/framebuffer/attachment_surfaces.h"
#include "driver/framebuffer/drawable.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

ReadTarget window_target(DeviceContext& context) {
    Drawable* const drawable = context.read_drawable();
    if (!drawable) return {.status = GL_FRAMEBUFFER_UNDEFINED};
    drawable->settle();
    ReadTarget target{.window = drawable};
    switch (context.state.framebuffer.read_buffer) {
    case GL_NONE:
        break;
    case GL_FRONT:
    case GL_FRONT_LEFT:
    case GL_LEFT:
        target.color = drawable->front();
        break;
    default:
        target.color = drawable->back();
    }
    target.depth = drawable->depth();
    target.has_depth = drawable->format().depth_bits > 0;
    target.has_stencil = drawable->format().stencil_bits > 0;
    return target;
}

ReadTarget object_target(DeviceContext& context, const FramebufferObject& object) {
    ReadTarget target{.status = framebuffer_status(object)};
    if (target.status != GL_FRAMEBUFFER_COMPLETE) return target;
    target.color = color_surface(context.device_memory(), object, object.read_buffer);
    target.depth = depth_surface(context.device_memory(), object);
    target.has_depth = has_depth(object);
    target.has_stencil = has_stencil(object);
    return target;
}

// Calls visitor(address, offset in the pixels, bytes) for each contiguous run.
template <class Visitor>
void for_each_run(const Surface& surface, const PixelRectangle& rectangle, Visitor&& visitor) {
    const std::uint64_t pixel = format_info(surface.format).block_bytes;
    const std::uint64_t row = static_cast<std::uint64_t>(rectangle.width) * pixel;
    const std::uint64_t first = surface.address +
                                static_cast<std::uint64_t>(rectangle.y) * surface.stride +
                                static_cast<std::uint64_t>(rectangle.x) * pixel;
    const auto height = static_cast<std::uint64_t>(rectangle.height);
    if (row == surface.stride) return visitor(first, 0, row * height);
    for (std::uint64_t y = 0; y < height; ++y)
        visitor(first + y * surface.stride, y * row, row);
}

std::size_t pixels_bytes(const Surface& surface, const PixelRectangle& rectangle) {
    return static_cast<std::size_t>(rectangle.width) * static_cast<std::size_t>(rectangle.height) *
           format_info(surface.format).block_bytes;
}

} // namespace

ReadTarget find_read_target(DeviceContext& context) {
    const auto& object = context.state.framebuffer.read_object;
    return object ? object_target(context, *object) : window_target(context);
}

bool ReadTarget::is_supersampled() const {
    return window && window->format().supersampling > 1;
}

GLenum ReadTarget::pixels_error() const {
    if (status != GL_FRAMEBUFFER_COMPLETE) return GL_INVALID_FRAMEBUFFER_OPERATION;
    const bool multisampled = color.samples > 1 || depth.samples > 1;
    return multisampled && !window ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

Surface ReadTarget::pixel_colors() const {
    if (!window || !window->is_resolved()) return color;
    return color == window->front() ? window->readable_front() : window->readable_back();
}

Surface ReadTarget::pixel_depths() const {
    return depth.samples == 1 ? depth : window->readable_depth();
}

PixelRectangle clip_to(const Surface& surface, PixelRectangle rectangle) {
    const std::int64_t left = std::clamp<std::int64_t>(rectangle.x, 0, surface.width);
    const std::int64_t bottom = std::clamp<std::int64_t>(rectangle.y, 0, surface.height);
    const std::int64_t right =
        std::clamp<std::int64_t>(rectangle.x + rectangle.width, left, surface.width);
    const std::int64_t top =
        std::clamp<std::int64_t>(rectangle.y + rectangle.height, bottom, surface.height);
    return {left, bottom, right - left, top - bottom};
}

std::vector<std::byte>
read_surface(Device& device, const Surface& surface, const PixelRectangle& rectangle) {
    std::vector<std::byte> pixels(pixels_bytes(surface, rectangle));
    for_each_run(surface, rectangle, [&](std::uint64_t at, std::uint64_t to, std::uint64_t bytes) {
        device.read_memory(static_cast<DeviceAddress>(at), std::span(pixels).subspan(to, bytes));
    });
    return pixels;
}

void write_surface(Device& device,
                   const Surface& surface,
                   const PixelRectangle& rectangle,
                   const std::vector<std::byte>& pixels) {
    for_each_run(
        surface, rectangle, [&](std::uint64_t at, std::uint64_t from, std::uint64_t bytes) {
            device.write_memory(static_cast<DeviceAddress>(at),
                                std::span(pixels).subspan(from, bytes));
        });
}

} // namespace ffgpu::gl
