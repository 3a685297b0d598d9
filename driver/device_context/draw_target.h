// What is drawn to: a window's buffers or a framebuffer object's.

#pragma once

#include "driver/gl_types.h"
#include "driver/lower/fragment.h"
#include "model/device/registers/fragment.h"

namespace ffgpu::gl {

class DeviceContext;
class Drawable;

// The draw target as the context has it now.
struct DrawTarget {
    GLenum status = GL_FRAMEBUFFER_COMPLETE; // or why nothing can be drawn
    Targets targets{};
    unsigned width = 0, height = 0;      // of the part that all of its surfaces have
    DepthTarget depth{};                 // what of the depth surface is GL's
    Drawable* resolved_window = nullptr; // to be told of drawing; or null
    unsigned supersampling = 1;          // pictures that are drawn; `targets` are the first's
    std::uint8_t srgb_capable = 0;       // a bit for each colour target that may hold sRGB codes
};

// Textures that are drawn to become resident.
DrawTarget find_draw_target(DeviceContext& context);

} // namespace ffgpu::gl
