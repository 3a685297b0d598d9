// glReadPixels (GL 1.5, 4.3.2).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/pixel_memory.h"
#include "driver/images/read_target.h"
#include "driver/math/conversion.h"
#include "driver/pixel/pixel_format.h"
#include "driver/texel/texel_codec.h"

#include <cstring>

namespace ffgpu::gl::api {
namespace {

GLenum source_error(const ReadTarget& target, PixelKind kind) {
    bool found = false;
    switch (kind) {
    case PixelKind::Color:
        found = target.color.format != Format::None;
        break;
    case PixelKind::Depth:
        found = target.has_depth;
        break;
    case PixelKind::Stencil:
        found = target.has_stencil;
        break;
    case PixelKind::DepthStencil:
        found = target.has_depth && target.has_stencil;
        break;
    case PixelKind::Index:
        break; // There are no colour-index buffers.
    }
    return found ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

// Turns rows of a surface into rows of the application's memory.
class RowReader {
public:
    RowReader(const PixelState& transfer, const PixelDestination& destination, Format format)
        : transfer_(transfer)
        , destination_(destination)
        , kind_(component_order(destination.format).kind)
        , format_(format)
        , copies_bytes_(can_copy_bytes())
        , colors_(destination.width())
        , depths_(destination.width())
        , stencils_(destination.width())
        , words_(destination.width()) {}

    void operator()(const std::byte* pixels, std::byte* row) {
        if (copies_bytes_) {
            std::memcpy(row, pixels, 4 * destination_.width());
            return;
        }
        switch (kind_) {
        case PixelKind::Depth:
            read_depths(pixels);
            return pack_depths(destination_, row, depths_.data());
        case PixelKind::Stencil:
            read_stencils(pixels);
            return pack_indices(destination_, row, stencils_.data());
        case PixelKind::DepthStencil:
            return read_both(pixels, row);
        default:
            decode_colors(format_, pixels, colors_);
            transfer_colors(transfer_, colors_);
            return pack_colors(destination_, row, colors_.data());
        }
    }

private:
    // The common case: bytes r g b a to the same. Rgbx8's fourth byte is not defined.
    bool can_copy_bytes() const {
        const bool bytes =
            destination_.type == GL_UNSIGNED_BYTE ||
            (destination_.type == GL_UNSIGNED_INT_8_8_8_8_REV && !destination_.swap_bytes);
        return format_ == Format::Rgba8 && destination_.format == GL_RGBA && bytes &&
               keeps_colors(transfer_);
    }

    void read_depths(const std::byte* pixels) {
        decode_depths(format_, pixels, depths_);
        transfer_depths(transfer_, depths_);
    }

    void read_stencils(const std::byte* pixels) {
        for (std::size_t x = 0; x < stencils_.size(); ++x)
            stencils_[x] = std::to_integer<std::int32_t>(pixels[4 * x]);
        transfer_stencil(transfer_, stencils_);
    }

    void read_both(const std::byte* pixels, std::byte* row) {
        read_depths(pixels);
        read_stencils(pixels);
        for (std::size_t x = 0; x < words_.size(); ++x)
            words_[x] = unorm(depths_[x], 24) << 8 | (static_cast<unsigned>(stencils_[x]) & 0xff);
        pack_depth_stencil(destination_, row, words_.data());
    }

    const PixelState& transfer_;
    const PixelDestination& destination_;
    PixelKind kind_;
    Format format_;
    bool copies_bytes_;
    std::vector<PixelColor> colors_;
    std::vector<double> depths_;
    std::vector<std::int32_t> stencils_;
    std::vector<std::uint32_t> words_;
};

// Pixels outside of the surface are undefined: the application's memory keeps what it has.
void skip_outside(PixelDestination& destination,
                  const PixelRectangle& asked,
                  const PixelRectangle& inside) {
    const auto left = static_cast<std::uint64_t>(inside.x - asked.x);
    const auto below = static_cast<std::uint64_t>(inside.y - asked.y);
    PixelLayout& layout = destination.layout;
    if (destination.type == GL_BITMAP) {
        layout.first += (layout.first_bit + left) / 8;
        layout.first_bit = static_cast<unsigned>((layout.first_bit + left) % 8);
    } else {
        layout.first += left * pixel_bytes(destination.format, destination.type);
    }
    layout.first += below * layout.row_stride;
    destination.size = {static_cast<GLsizei>(inside.width), static_cast<GLsizei>(inside.height), 1};
}

} // namespace

void ReadPixels(Context& context,
                GLint x,
                GLint y,
                GLsizei width,
                GLsizei height,
                GLenum format,
                GLenum type,
                void* pixels) {
    if (width < 0 || height < 0) return context.error(GL_INVALID_VALUE);
    if (const GLenum error = format_type_error(format, type)) return context.error(error);
    const ReadTarget target = find_read_target(context);
    if (const GLenum error = target.pixels_error()) return context.error(error);
    const PixelKind kind = component_order(format).kind;
    if (const GLenum error = source_error(target, kind)) return context.error(error);

    auto destination = pixel_destination(context, pixels, {width, height, 1}, format, type);
    if (!destination || !destination->memory) return;
    const Surface surface =
        kind == PixelKind::Color ? target.pixel_colors() : target.pixel_depths();
    const PixelRectangle asked{x, y, width, height};
    const PixelRectangle inside = clip_to(surface, asked);
    if (inside.empty()) return;
    skip_outside(*destination, asked, inside);

    const std::vector<std::byte> rows = read_surface(context.device(), surface, inside);
    const std::size_t stride = row_bytes(surface.format, static_cast<std::uint32_t>(inside.width));
    RowReader read(context.state.pixel, *destination, surface.format);
    for (GLsizei row = 0; row < destination->size.height; ++row)
        read(rows.data() + static_cast<std::size_t>(row) * stride, destination->row(row));
}

} // namespace ffgpu::gl::api
