#include "driver/framebuffer/attachment_surfaces.h"

namespace ffgpu::gl {
namespace {

Surface surface_of(DeviceMemory memory, const Attachment& attachment) {
    if (attachment.renderbuffer) return attachment.renderbuffer->surface();
    if (!attachment.texture) return {};
    return image_surface(
        memory, *attachment.texture, {attachment.face, attachment.level}, attachment.layer);
}

} // namespace

Surface color_surface(DeviceMemory memory, const FramebufferObject& framebuffer, GLenum buffer) {
    const GLuint index = buffer - GL_COLOR_ATTACHMENT0;
    return index < MaxColorAttachments ? surface_of(memory, framebuffer.colors[index]) : Surface{};
}

Surface depth_surface(DeviceMemory memory, const FramebufferObject& framebuffer) {
    return surface_of(memory, framebuffer.depth ? framebuffer.depth : framebuffer.stencil);
}

Targets framebuffer_targets(DeviceMemory memory, const FramebufferObject& framebuffer) {
    Targets targets;
    for (unsigned i = 0; i < ColorTargets; ++i)
        targets.color[i] = color_surface(memory, framebuffer, framebuffer.draw_buffers[i]);
    targets.depth = depth_surface(memory, framebuffer);
    return targets;
}

} // namespace ffgpu::gl
