#include "driver/device_context/draw_target.h"

#include "driver/device_context/device_context.h"
#include "driver/framebuffer/attachment_surfaces.h"
#include "driver/framebuffer/drawable.h"
#include "driver/lower/targets.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

unsigned depth_bits(Format format) {
    switch (format) {
    case Format::Depth24Stencil8:
        return 24;
    case Format::Depth16:
        return 16;
    default:
        return 0;
    }
}

// The colour targets for which is_capable(i) holds.
template <class Predicate>
std::uint8_t srgb_capable(const Targets& targets, Predicate&& is_capable) {
    unsigned mask = 0;
    for (unsigned i = 0; i < ColorTargets; ++i)
        if (targets.color[i].format != Format::None && is_capable(i)) mask |= 1u << i;
    return static_cast<std::uint8_t>(mask);
}

DrawTarget window_target(DeviceContext& context) {
    Drawable* const drawable = context.draw_drawable();
    if (!drawable) return {.status = GL_FRAMEBUFFER_UNDEFINED};
    const PixelFormat& format = drawable->format();
    const Targets targets = lower_window_targets(*drawable, context.state.framebuffer.draw_buffers);
    return {.targets = targets,
            .width = drawable->width(),
            .height = drawable->height(),
            .depth = {.depth_bits = format.depth_bits == 0 ? 0 : depth_bits(targets.depth.format),
                      .stencil_bits = format.stencil_bits},
            .resolved_window = drawable->is_resolved() ? drawable : nullptr,
            .supersampling = format.supersampling,
            // Windows have 8 bits a channel: whether these are codes is the program's choice.
            .srgb_capable = srgb_capable(targets, [](unsigned) { return true; })};
}

DrawTarget object_target(DeviceContext& context, const FramebufferObject& object) {
    DrawTarget found{.status = framebuffer_status(object)};
    if (found.status != GL_FRAMEBUFFER_COMPLETE) return found;
    found.targets = framebuffer_targets(context.device_memory(), object);
    found.srgb_capable = srgb_capable(found.targets, [&object](unsigned i) {
        return object.colors[object.draw_buffers[i] - GL_COLOR_ATTACHMENT0].format().srgb;
    });
    found.width = found.height = MaxSurfaceSize;
    Targets::for_each(found.targets, [&found](const Surface& surface) {
        if (surface.format == Format::None) return;
        found.width = std::min<unsigned>(found.width, surface.width);
        found.height = std::min<unsigned>(found.height, surface.height);
    });
    found.depth.depth_bits = has_depth(object) ? depth_bits(found.targets.depth.format) : 0;
    found.depth.stencil_bits = has_stencil(object) ? 8 : 0;
    return found;
}

} // namespace

DrawTarget find_draw_target(DeviceContext& context) {
    const auto& object = context.state.framebuffer.draw_object;
    return object ? object_target(context, *object) : window_target(context);
}

} // namespace ffgpu::gl
