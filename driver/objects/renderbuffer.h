// Renderbuffer: an image that can only be drawn to (EXT_framebuffer_object).

#pragma once

#include "driver/gl_types.h"
#include "driver/objects/device_block.h"
#include "driver/texel/internal_format.h"
#include "model/device/registers/fragment.h"

namespace ffgpu::gl {

struct Renderbuffer {
    GLuint name = 0;
    GLenum internal_format = GL_RGBA;
    InternalFormat format{}; // base None: it has no storage yet
    GLsizei width = 0, height = 0;
    GLsizei samples = 0; // of a pixel: 0 (single-sampled) or MaxSamples
    DeviceBlock block{};

    Surface surface() const {
        Surface all = layout();
        all.address = block.address();
        return block ? all : Surface{};
    }
    // The surface that the storage must hold, at address 0.
    Surface layout() const {
        return {.address = 0,
                .format = format.format,
                .width = static_cast<std::uint16_t>(width),
                .height = static_cast<std::uint16_t>(height),
                .stride = row_bytes(format.format, static_cast<std::uint32_t>(width)),
                .samples = static_cast<std::uint8_t>(samples > 1 ? samples : 1)};
    }
};

} // namespace ffgpu::gl
