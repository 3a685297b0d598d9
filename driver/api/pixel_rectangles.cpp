// glDrawPixels (GL 1.5, 3.6.4).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/images/draw_buffers.h"
#include "driver/images/draw_image.h"
#include "driver/images/pixel_memory.h"
#include "driver/pixel/pixel_format.h"
#include "driver/texture/image_upload.h"

namespace ffgpu::gl::api {
namespace {

HostImage stencil_image(const PixelSource& source, const PixelState& transfer) {
    const std::size_t width = source.width();
    HostImage image{Format::Stencil8,
                    static_cast<std::uint32_t>(source.size.width),
                    static_cast<std::uint32_t>(source.size.height),
                    std::vector<std::byte>(width * static_cast<std::size_t>(source.size.height))};
    std::vector<std::int32_t> indices(width);
    std::byte* to = image.pixels.data();
    for (GLsizei y = 0; y < source.size.height; ++y) {
        unpack_indices(source, source.row(y), indices.data());
        transfer_stencil(transfer, indices);
        for (const std::int32_t index : indices)
            *to++ = static_cast<std::byte>(index & 0xff);
    }
    return image;
}

HostImage image_of(const PixelSource& source, const PixelState& transfer, InternalFormat format) {
    return {format.format,
            static_cast<std::uint32_t>(source.size.width),
            static_cast<std::uint32_t>(source.size.height),
            unpack_texels(source, transfer, format)};
}

} // namespace

void DrawPixels(Context& context,
                GLsizei width,
                GLsizei height,
                GLenum format,
                GLenum type,
                const void* pixels) {
    if (width < 0 || height < 0) return context.error(GL_INVALID_VALUE);
    if (const GLenum error = format_type_error(format, type)) return context.error(error);
    const PixelKind kind = component_order(format).kind;
    if (const GLenum error = draw_buffers_error(context, kind)) return context.error(error);
    const RasterPosition& raster = context.state.current.raster;
    if (!raster.valid || context.render_modes().takes_pixels(GL_DRAW_PIXEL_TOKEN)) return;

    const auto source = pixel_source(context, pixels, {width, height, 1}, format, type);
    if (!source || !source->memory || source->size.empty()) return;
    const PixelState& transfer = context.state.pixel;
    const ImagePlace place{
        raster.position[0], raster.position[1], transfer.zoom_x, transfer.zoom_y};
    constexpr InternalFormat Color{BaseFormat::Rgba, Format::Rgba8};
    constexpr InternalFormat Depth{BaseFormat::Depth, Format::Depth24Stencil8};
    if (kind == PixelKind::Color || kind == PixelKind::Index)
        draw_image(context, image_of(*source, transfer, Color), place);
    if (kind == PixelKind::Depth) draw_image(context, image_of(*source, transfer, Depth), place);
    if (kind == PixelKind::Stencil || kind == PixelKind::DepthStencil)
        draw_image(context, stencil_image(*source, transfer), place);
    if (kind == PixelKind::DepthStencil)
        draw_depths_untested(context, image_of(*source, transfer, Depth), place);
}

} // namespace ffgpu::gl::api
