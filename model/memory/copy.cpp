#include "model/memory/copy.h"

#include "model/memory/pixel_format.h"

#include <cstring>
#include <vector>

namespace ffgpu {
namespace {

bool inside(const Surface& surface,
            std::uint32_t x,
            std::uint32_t y,
            const CopyRectangleCommand& copy) {
    return x + copy.width <= surface.width && y + copy.height <= surface.height;
}

// Where the bytes of a rectangle lie in memory, rows and what is between them.
struct Extent {
    std::uint64_t begin, end;
};

Extent
extent(const Surface& surface, std::uint32_t x, std::uint32_t y, const CopyRectangleCommand& copy) {
    const std::uint64_t begin = surface.address + std::uint64_t{y} * surface.stride +
                                std::uint64_t{x} * format_info(surface.format).block_bytes;
    return {begin,
            begin + std::uint64_t{copy.height - 1u} * surface.stride +
                row_bytes(surface.format, copy.width)};
}

// Converts rows of one pair of formats.
struct RowConverter {
    Format from, to;
    std::vector<std::uint32_t> pixels;

    RowConverter(Format source, Format destination, std::uint32_t width)
        : from(source)
        , to(destination)
        , pixels(source == destination ? 0 : width) {}

    void convert(const std::byte* source, std::byte* destination, std::uint32_t width) {
        if (from == to) {
            std::memcpy(destination, source, row_bytes(from, width));
        } else if (is_depth_target(from)) {
            load_depth24(from, source, pixels);
            store_depth24(to, pixels, destination);
        } else {
            load_rgba8(from, source, pixels);
            store_rgba8(to, pixels, destination);
        }
    }
};

// The source rectangle as rows one after the other.
std::vector<std::byte> read_rows(const CopyRectangleCommand& copy, std::span<std::byte> memory) {
    const std::size_t bytes = row_bytes(copy.source.format, copy.width);
    std::vector<std::byte> rows(bytes * copy.height);
    for (std::uint32_t y = 0; y < copy.height; ++y)
        std::memcpy(rows.data() + y * bytes,
                    pixel_address(copy.source, memory, copy.source_x, copy.source_y + y),
                    bytes);
    return rows;
}

} // namespace

void copy_rectangle(const CopyRectangleCommand& copy, std::span<std::byte> memory) {
    if (copy.width == 0 || copy.height == 0) return;
    if (!surface_fits(copy.source, memory.size())) return;
    if (!surface_fits(copy.destination, memory.size())) return;
    if (!inside(copy.source, copy.source_x, copy.source_y, copy)) return;
    if (!inside(copy.destination, copy.destination_x, copy.destination_y, copy)) return;
    if (is_depth_target(copy.source.format) != is_depth_target(copy.destination.format)) return;

    // Where the two meet in memory the source is read first, as a whole.
    const Extent from = extent(copy.source, copy.source_x, copy.source_y, copy);
    const Extent to = extent(copy.destination, copy.destination_x, copy.destination_y, copy);
    const bool overlap = from.begin < to.end && to.begin < from.end;
    const std::vector<std::byte> staged =
        overlap ? read_rows(copy, memory) : std::vector<std::byte>{};
    const std::size_t staged_bytes = row_bytes(copy.source.format, copy.width);

    RowConverter converter(copy.source.format, copy.destination.format, copy.width);
    for (std::uint32_t y = 0; y < copy.height; ++y) {
        const std::byte* source =
            overlap ? staged.data() + y * staged_bytes
                    : pixel_address(copy.source, memory, copy.source_x, copy.source_y + y);
        converter.convert(
            source,
            pixel_address(copy.destination, memory, copy.destination_x, copy.destination_y + y),
            copy.width);
    }
}

} // namespace ffgpu
