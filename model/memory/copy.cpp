#include "model/memory/copy.h"

#include "model/base/check.h"
#include "model/memory/pixel_format.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace ffgpu {
namespace {

bool inside(const Surface& surface,
            std::uint32_t x,
            std::uint32_t y,
            const CopyRectangleCommand& copy) {
    return x + copy.width <= surface.width && y + copy.height <= surface.height;
}

// A rectangle's place, in so many planes.
struct SurfacePart {
    const Surface& surface;
    std::uint32_t x, y;
    unsigned planes;
};

// Samples, or pictures.
unsigned source_planes(const CopyRectangleCommand& copy) {
    return copy.pictures > 1 ? copy.pictures : copy.source.samples;
}

// Where the bytes of a rectangle lie in memory: its rows and what is between them, from the first
// plane to the last.
struct Extent {
    std::uint64_t begin, end;
};

Extent extent(const SurfacePart& part, const CopyRectangleCommand& copy) {
    const auto& [surface, x, y, planes] = part;
    const std::uint64_t begin = surface.address + std::uint64_t{y} * surface.stride +
                                std::uint64_t{x} * format_info(surface.format).block_bytes;
    return {begin,
            begin + (planes - 1u) * surface.plane_bytes() +
                std::uint64_t{copy.height - 1u} * surface.stride +
                row_bytes(surface.format, copy.width)};
}

bool overlap(const CopyRectangleCommand& copy) {
    const Extent from =
        extent({copy.source, copy.source_x, copy.source_y, source_planes(copy)}, copy);
    const Surface& written = copy.destination;
    const Extent to =
        extent({written, copy.destination_x, copy.destination_y, written.samples}, copy);
    return from.begin < to.end && to.begin < from.end;
}

// The rows of the source, one of each plane; where source and destination meet in memory they were
// read first, as a whole.
class SourceRows {
public:
    SourceRows(const CopyRectangleCommand& copy, std::span<std::byte> memory)
        : copy_(copy)
        , memory_(memory)
        , bytes_(row_bytes(copy.source.format, copy.width)) {
        if (!overlap(copy)) return;
        std::vector<std::byte> rows(bytes_ * copy.height * source_planes(copy));
        for (unsigned sample = 0; sample < source_planes(copy); ++sample)
            for (std::uint32_t y = 0; y < copy.height; ++y)
                std::memcpy(rows.data() + staged_at(y, sample), row(y, sample), bytes_);
        staged_ = std::move(rows);
    }

    unsigned planes() const { return source_planes(copy_); }

    const std::byte* row(std::uint32_t y, unsigned sample) const {
        if (!staged_.empty()) return staged_.data() + staged_at(y, sample);
        return pixel_address(
            copy_.source.plane(sample), memory_, copy_.source_x, copy_.source_y + y);
    }

private:
    std::size_t staged_at(std::uint32_t y, unsigned sample) const {
        return (std::size_t{sample} * copy_.height + y) * bytes_;
    }

    const CopyRectangleCommand& copy_;
    std::span<std::byte> memory_;
    std::size_t bytes_;
    std::vector<std::byte> staged_;
};

// Converts rows of one pair of formats.
class RowConverter {
public:
    RowConverter(Format source, Format destination, std::uint32_t width)
        : from_(source)
        , to_(destination)
        , pixels_(width) {}

    void convert(const std::byte* source, std::byte* destination) {
        if (from_ == to_) {
            std::memcpy(
                destination, source, row_bytes(from_, static_cast<std::uint32_t>(pixels_.size())));
        } else if (is_depth_target(from_)) {
            load_depth24(from_, source, pixels_);
            store_depth24(to_, pixels_, destination);
        } else {
            load_rgba8(from_, source, pixels_);
            store_rgba8(to_, pixels_, destination);
        }
    }

    // Four rows of samples to one of pixels: the mean of colours, sample 0 of depth and stencil.
    void resolve(const std::array<const std::byte*, MaxSamples>& samples, std::byte* destination) {
        if (is_depth_target(from_)) return convert(samples[0], destination);
        for (unsigned i = 0; i < MaxSamples; ++i) {
            colors_[i].resize(pixels_.size());
            load_rgba8(from_, samples[i], colors_[i]);
        }
        for (std::size_t x = 0; x < pixels_.size(); ++x)
            pixels_[x] = mean_rgba8({colors_[0][x], colors_[1][x], colors_[2][x], colors_[3][x]});
        store_rgba8(to_, pixels_, destination);
    }

    // Rows of as many pictures as wanted to their mean: to nearest, halves up.
    void average(const SourceRows& source, std::uint32_t y, std::byte* destination) {
        const unsigned count = source.planes();
        check(count > 0, "a mean of something");
        sums_.assign(pixels_.size(), {});
        for (unsigned picture = 0; picture < count; ++picture) {
            load_rgba8(from_, source.row(y, picture), pixels_);
            for (std::size_t x = 0; x < pixels_.size(); ++x)
                for (unsigned channel = 0; channel < 4; ++channel)
                    sums_[x][channel] += pixels_[x] >> (8 * channel) & 0xff;
        }
        for (std::size_t x = 0; x < pixels_.size(); ++x) {
            pixels_[x] = 0;
            for (unsigned channel = 0; channel < 4; ++channel)
                pixels_[x] |= (sums_[x][channel] + count / 2) / count << (8 * channel);
        }
        store_rgba8(to_, pixels_, destination);
    }

private:
    Format from_, to_;
    std::vector<std::uint32_t> pixels_;
    std::vector<std::array<std::uint32_t, 4>> sums_;
    std::array<std::vector<std::uint32_t>, MaxSamples> colors_;
};

} // namespace

std::uint32_t mean_rgba8(const std::array<std::uint32_t, MaxSamples>& samples) {
    // Two channels at a time: their sums fit 16 bits.
    constexpr std::uint32_t Even = 0x00ff00ff, Half = 0x00020002;
    std::uint32_t even = Half, odd = Half;
    for (const std::uint32_t color : samples) {
        even += color & Even;
        odd += color >> 8 & Even;
    }
    return (even >> 2 & Even) | (odd >> 2 & Even) << 8;
}

void copy_rectangle(const CopyRectangleCommand& copy, std::span<std::byte> memory) {
    if (copy.width == 0 || copy.height == 0) return;
    if (!surface_fits(copy.source, memory.size())) return;
    if (!surface_fits(copy.destination, memory.size())) return;
    if (!inside(copy.source, copy.source_x, copy.source_y, copy)) return;
    if (!inside(copy.destination, copy.destination_x, copy.destination_y, copy)) return;
    if (is_depth_target(copy.source.format) != is_depth_target(copy.destination.format)) return;
    if (copy.source.address + copy.source_bytes() > memory.size()) return;

    const SourceRows source(copy, memory);
    const auto to = [&](std::uint32_t y, unsigned sample) {
        return pixel_address(
            copy.destination.plane(sample), memory, copy.destination_x, copy.destination_y + y);
    };
    RowConverter converter(copy.source.format, copy.destination.format, copy.width);
    for (std::uint32_t y = 0; y < copy.height; ++y) {
        if (copy.pictures > 1) {
            converter.average(source, y, to(y, 0));
            continue;
        }
        if (copy.destination.samples < copy.source.samples) {
            converter.resolve(
                {source.row(y, 0), source.row(y, 1), source.row(y, 2), source.row(y, 3)}, to(y, 0));
            continue;
        }
        for (unsigned i = 0; i < copy.destination.samples; ++i)
            converter.convert(source.row(y, std::min(i, copy.source.samples - 1u)), to(y, i));
    }
}

} // namespace ffgpu
