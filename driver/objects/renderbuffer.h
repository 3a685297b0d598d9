// Renderbuffer: an image that can only be drawn to (EXT_framebuffer_object).

#pragma once

#include "driver/gl_types.h"
#include "driver/objects/device_block.h"
#include "driver/texture/internal_format.h"
#include "model/device/registers/fragment.h"

namespace ffgpu::gl {

struct Renderbuffer {
    GLuint name = 0;
    GLenum internal_format = GL_RGBA;
    InternalFormat format{}; // base None: it has no storage yet
    GLsizei width = 0, height = 0;
    GLsizei samples = 0; // always drawn with one sample a pixel
    DeviceBlock block{};

    Surface surface() const {
        if (!block) return {};
        return {.address = block.address(),
                .format = format.format,
                .width = static_cast<std::uint16_t>(width),
                .height = static_cast<std::uint16_t>(height),
                .stride = row_bytes(format.format, static_cast<std::uint32_t>(width))};
    }
};

} // namespace ffgpu::gl
