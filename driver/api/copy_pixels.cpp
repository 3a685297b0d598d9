// glCopyPixels (GL 1.5, 4.3.3): the framebuffer's pixels through pixel transfer and the fragment
// pipe.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/images/draw_buffers.h"
#include "driver/images/draw_image.h"
#include "driver/images/read_target.h"
#include "driver/texel/texel_codec.h"

#include <optional>

namespace ffgpu::gl::api {
namespace {

// NV_copy_depth_to_color: depth and stencil are drawn as colours.
bool shows_depth(GLenum type) {
    return type == GL_DEPTH_STENCIL_TO_RGBA_NV || type == GL_DEPTH_STENCIL_TO_BGRA_NV;
}

// Of the pixels that are read.
std::optional<PixelKind> kind_of(GLenum type) {
    if (shows_depth(type)) return PixelKind::DepthStencil;
    switch (type) {
    case GL_COLOR:
        return PixelKind::Color;
    case GL_DEPTH:
        return PixelKind::Depth;
    case GL_STENCIL:
        return PixelKind::Stencil;
    case GL_DEPTH_STENCIL:
        return PixelKind::DepthStencil;
    default:
        return std::nullopt;
    }
}

bool has_source(const ReadTarget& target, PixelKind kind) {
    switch (kind) {
    case PixelKind::Color:
        return target.color.format != Format::None;
    case PixelKind::Depth:
        return target.has_depth;
    case PixelKind::Stencil:
        return target.has_stencil;
    default:
        return target.has_depth && target.has_stencil;
    }
}

// The images that are drawn from pixels of one surface. Their formats are wide enough for all
// surfaces, so that a copy without pixel transfer changes nothing.
class CopiedPixels {
public:
    CopiedPixels(Context& context, const Surface& surface, const PixelRectangle& rectangle)
        : transfer_(context.state.pixel)
        , format_(surface.format)
        , width_(static_cast<std::uint32_t>(rectangle.width))
        , height_(static_cast<std::uint32_t>(rectangle.height))
        , count_(std::size_t{width_} * height_)
        , pixels_(read_surface(context.device(), surface, rectangle)) {}

    HostImage colors() const {
        if (format_ == Format::Rgba8 && keeps_colors(transfer_)) return image(format_, pixels_);
        std::vector<PixelColor> colors(count_);
        decode_colors(format_, pixels_.data(), colors);
        transfer_colors(transfer_, colors);
        std::vector<std::byte> encoded(4 * count_);
        encode_colors(Format::Rgba8, colors, encoded.data());
        return image(Format::Rgba8, std::move(encoded));
    }

    HostImage depths() const {
        std::vector<double> depths(count_);
        decode_depths(format_, pixels_.data(), depths);
        transfer_depths(transfer_, depths);
        std::vector<std::byte> encoded(4 * count_);
        encode_depths(Format::Depth24Stencil8, depths, encoded.data());
        return image(Format::Depth24Stencil8, std::move(encoded));
    }

    HostImage stencils() const {
        std::vector<std::int32_t> indices(count_);
        for (std::size_t i = 0; i < count_; ++i)
            indices[i] = std::to_integer<std::int32_t>(pixels_[4 * i]);
        transfer_stencil(transfer_, indices);
        std::vector<std::byte> encoded(count_);
        for (std::size_t i = 0; i < count_; ++i)
            encoded[i] = static_cast<std::byte>(indices[i] & 0xff);
        return image(Format::Stencil8, std::move(encoded));
    }

    // As if they were read as GL_UNSIGNED_INT_24_8 and drawn as GL_UNSIGNED_INT_8_8_8_8 of GL_RGBA
    // or GL_BGRA: the highest byte of the depth is red or blue, the stencil index is alpha.
    HostImage depths_as_colors(bool bgra) const {
        const HostImage depth = depths(), stencil = stencils();
        std::vector<std::byte> colors(4 * count_);
        for (std::size_t i = 0; i < count_; ++i) {
            const std::byte* const word = &depth.pixels[4 * i];
            colors[4 * i] = word[bgra ? 1 : 3];
            colors[4 * i + 1] = word[2];
            colors[4 * i + 2] = word[bgra ? 3 : 1];
            colors[4 * i + 3] = stencil.pixels[i];
        }
        return image(Format::Rgba8, std::move(colors));
    }

private:
    HostImage image(Format format, std::vector<std::byte> pixels) const {
        return {format, width_, height_, std::move(pixels)};
    }

    const PixelState& transfer_;
    Format format_;
    std::uint32_t width_, height_;
    std::size_t count_;
    std::vector<std::byte> pixels_;
};

} // namespace

void CopyPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    const auto kind = kind_of(type);
    if (!kind) return context.error(GL_INVALID_ENUM);
    if (width < 0 || height < 0) return context.error(GL_INVALID_VALUE);
    const ReadTarget target = find_read_target(context);
    if (const GLenum error = target.pixels_error()) return context.error(error);
    if (!has_source(target, *kind)) return context.error(GL_INVALID_OPERATION);
    const PixelKind drawn = shows_depth(type) ? PixelKind::Color : *kind;
    if (const GLenum error = draw_buffers_error(context, drawn)) return context.error(error);
    const RasterPosition& raster = context.state.current.raster;
    if (!raster.valid || context.render_modes().takes_pixels(GL_COPY_PIXEL_TOKEN)) return;

    // Pixels from outside of the surface are undefined; none are drawn.
    const Surface surface =
        *kind == PixelKind::Color ? target.pixel_colors() : target.pixel_depths();
    const PixelRectangle inside = clip_to(surface, {x, y, width, height});
    if (inside.empty()) return;
    const float zoom_x = context.state.pixel.zoom_x, zoom_y = context.state.pixel.zoom_y;
    const ImagePlace place{raster.position[0] + zoom_x * static_cast<float>(inside.x - x),
                           raster.position[1] + zoom_y * static_cast<float>(inside.y - y),
                           zoom_x,
                           zoom_y};
    const CopiedPixels copied(context, surface, inside);
    if (shows_depth(type)) {
        const bool bgra = type == GL_DEPTH_STENCIL_TO_BGRA_NV;
        return draw_image(context, copied.depths_as_colors(bgra), place);
    }
    if (*kind == PixelKind::Color) draw_image(context, copied.colors(), place);
    if (*kind == PixelKind::Depth) draw_image(context, copied.depths(), place);
    if (*kind == PixelKind::DepthStencil) draw_depths_untested(context, copied.depths(), place);
    if (*kind == PixelKind::Stencil || *kind == PixelKind::DepthStencil)
        draw_image(context, copied.stencils(), place);
}

} // namespace ffgpu::gl::api
