// The surfaces behind a complete framebuffer object. Textures become resident. Format None: nothing
// is attached.

#pragma once

#include "driver/objects/framebuffer_object.h"
#include "driver/texture/residency.h"
#include "model/device/registers/fragment.h"

namespace ffgpu::gl {

// What its draw buffers select, and depth.
Targets framebuffer_targets(DeviceMemory memory, const FramebufferObject& framebuffer);

// Of one colour attachment; of the depth or stencil attachment.
Surface color_surface(DeviceMemory memory, const FramebufferObject& framebuffer, GLenum buffer);
Surface depth_surface(DeviceMemory memory, const FramebufferObject& framebuffer);

} // namespace ffgpu::gl
