// glBitmap (GL 1.5, 3.7).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/images/draw_buffers.h"
#include "driver/images/draw_image.h"
#include "driver/images/pixel_memory.h"
#include "model/device/layout/limits.h"

#include <cmath>

namespace ffgpu::gl::api {
namespace {

// Rows from bit 0 of their first byte on, lowest bit first.
HostImage bitmap_image(const PixelSource& source) {
    HostImage image{Format::Bitmap,
                    static_cast<std::uint32_t>(source.size.width),
                    static_cast<std::uint32_t>(source.size.height),
                    {}};
    const std::size_t stride = row_bytes(Format::Bitmap, image.width);
    image.pixels.resize(stride * image.height);
    for (GLsizei y = 0; y < source.size.height; ++y) {
        const std::byte* const from = source.row(y);
        std::byte* const to = image.pixels.data() + static_cast<std::size_t>(y) * stride;
        for (std::size_t x = 0; x < source.width(); ++x) {
            if (bitmap_pixel(source, from, x)) to[x / 8] |= static_cast<std::byte>(1u << (x % 8));
        }
    }
    return image;
}

// The pixel that a position lies in. Positions are rounded to 1/256 pixel, as those of vertices
// are: one that the transformation made a hair less than a whole number is that number.
float pixel_of(float position) {
    constexpr float Steps = 1 << SubPixelBits;
    return std::floor(std::floor(position * Steps + 0.5f) / Steps);
}

} // namespace

void Bitmap(Context& context,
            GLsizei width,
            GLsizei height,
            GLfloat xorig,
            GLfloat yorig,
            GLfloat xmove,
            GLfloat ymove,
            const GLubyte* bitmap) {
    if (width < 0 || height < 0) return context.error(GL_INVALID_VALUE);
    if (const GLenum error = draw_buffers_error(context, PixelKind::Color))
        return context.error(error);
    RasterPosition& raster = context.state.current.raster;
    if (!raster.valid) return;
    if (!context.render_modes().takes_pixels(GL_BITMAP_TOKEN)) {
        const auto source =
            pixel_source(context, bitmap, {width, height, 1}, GL_COLOR_INDEX, GL_BITMAP);
        if (!source) return;
        if (source->memory && !source->size.empty()) {
            draw_image(
                context,
                bitmap_image(*source),
                {pixel_of(raster.position[0] - xorig), pixel_of(raster.position[1] - yorig)});
        }
    }
    raster.position[0] += xmove;
    raster.position[1] += ymove;
}

} // namespace ffgpu::gl::api
