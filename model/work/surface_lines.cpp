#include "model/work/surface_lines.h"

#include <algorithm>
#include <bit>

namespace ffgpu::work {
namespace {

constexpr unsigned Red = 1, Alpha = 8, AllChannels = 15;

constexpr PixelBytes all_bytes(std::uint32_t bytes) {
    return {bytes, bytes};
}

// A format whose channels share bytes: written in part where the mask is.
constexpr PixelBytes shared_bytes(std::uint32_t bytes, bool some, bool all) {
    return {some ? bytes : 0, all ? bytes : 0};
}

// Runs of bytes of pixels [begin, end) that are written alike: calls add(first, last, covered).
template <class Add>
void for_each_written(
    std::uint64_t begin, std::uint64_t end, std::uint32_t pixel, PixelBytes bytes, const Add& add) {
    const auto touched = [&](std::uint32_t byte) { return (bytes.touched >> byte & 1) != 0; };
    const auto covered = [&](std::uint32_t byte) { return (bytes.covered >> byte & 1) != 0; };
    std::uint64_t first = begin; // of the run
    std::uint32_t of_first = 0;  // byte of its pixel
    for (std::uint64_t at = begin; at < end;) {
        for (std::uint32_t i = 0; i < pixel; ++i, ++at) {
            if (touched(i) == touched(of_first) && covered(i) == covered(of_first)) continue;
            if (touched(of_first)) add(first, at, covered(of_first));
            first = at;
            of_first = i;
        }
    }
    if (touched(of_first)) add(first, end, covered(of_first));
}

// The lines of a part of a surface, which collect what is written of them.
class Collector {
public:
    // Of bytes [begin, end) of memory.
    Collector(std::uint64_t begin, std::uint64_t end, const LineGrain& grain)
        : grain_(grain)
        , first_(begin / grain.line_bytes())
        , lines_((end - 1) / grain.line_bytes() - first_ + 1) {}

    // Bytes [begin, end) of memory.
    void add(std::uint64_t begin, std::uint64_t end, bool covered) {
        add_masked(begin, end, {~LineMask{0}, covered ? ~LineMask{0} : 0});
    }
    // Of each line no other bits than these.
    void add_masked(std::uint64_t begin, std::uint64_t end, WrittenBytes mask) {
        const std::uint64_t bytes = grain_.line_bytes();
        for (std::uint64_t line = quotient(begin, bytes); line * bytes < end; ++line) {
            const std::uint64_t at = line * bytes;
            const auto from = static_cast<std::uint32_t>(std::max(begin, at) - at);
            const auto to = static_cast<std::uint32_t>(std::min(end - at, bytes));
            WrittenBytes& written = lines_[line - first_];
            written.touched |= grain_.touched(from, to) & mask.touched;
            written.covered |= grain_.covered(from, to) & mask.covered;
        }
    }

    // A run of pixels that lie together, of which only some bytes are written.
    void add_pixels(std::uint64_t begin, std::uint64_t end, std::uint32_t pixel, PixelBytes bytes) {
        if (grain_.bytes() == 1 && std::has_single_bit(pixel) && pixel <= grain_.line_bytes() &&
            remainder(begin, pixel) == 0)
            return add_masked(
                begin, end, {repeat(bytes.touched, pixel), repeat(bytes.covered, pixel)});
        for_each_written(begin, end, pixel, bytes, [this](auto... run) { add(run...); });
    }

    std::vector<WrittenLine> result() const {
        std::vector<WrittenLine> result;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (lines_[i].touched != 0) result.push_back({first_ + i, lines_[i]});
        return result;
    }

private:
    // The bytes of one pixel for all of a line, with a bit a byte.
    static LineMask repeat(LineMask bytes, std::uint32_t pixel) {
        for (std::uint32_t bits = pixel; bits < LineMaskBits; bits *= 2)
            bytes |= bytes << bits;
        return bytes;
    }

    const LineGrain& grain_;
    std::uint64_t first_;
    std::vector<WrittenBytes> lines_;
};

} // namespace

PixelBytes written_color_bytes(Format format, unsigned write_mask) {
    switch (format) {
    case Format::Rgba8:
        return all_bytes(write_mask & AllChannels);
    case Format::Rgbx8: // The fourth byte may hold anything: it goes with the other three.
        return all_bytes((write_mask & 7) == 7 ? 15 : write_mask & 7);
    case Format::Luminance8:
    case Format::Intensity8:
        return all_bytes(write_mask & Red ? 1 : 0);
    case Format::Alpha8:
        return all_bytes(write_mask & Alpha ? 1 : 0);
    case Format::LuminanceAlpha8:
        return all_bytes((write_mask & Red ? 1u : 0u) | (write_mask & Alpha ? 2u : 0u));
    default:
        break;
    }
    const unsigned channels = format == Format::Rgb565 ? 7 : AllChannels;
    const unsigned written = write_mask & channels;
    return shared_bytes(whole_pixel(format).covered, written != 0, written == channels);
}

PixelBytes cleared_depth_bytes(Format format, const ClearCommand& clear, unsigned stencil_mask) {
    if (format != Format::Depth24Stencil8) return clear.depth ? whole_pixel(format) : PixelBytes{};
    const PixelBytes depth = all_bytes(clear.depth ? 0xe : 0);
    const unsigned bits = clear.stencil ? stencil_mask & 0xff : 0;
    const PixelBytes stencil = shared_bytes(1, bits != 0, bits == 0xff);
    return {depth.touched | stencil.touched, depth.covered | stencil.covered};
}

PixelBytes whole_pixel(Format format) {
    return all_bytes((1u << format_info(format).block_bytes) - 1);
}

namespace {

// In lines whose bits are several bytes: bits that several samples cover together are covered, too.
WrittenBytes coarse_quad_bytes(const PlacedLevel& place,
                               const LineGrain& grain,
                               const WrittenQuad& quad,
                               std::uint64_t number,
                               PixelBytes bytes) {
    const std::uint64_t line_begin = number * grain.line_bytes();
    const std::uint64_t line_end = line_begin + grain.line_bytes();
    const std::uint32_t sample = place.layout.element_bytes / place.samples;
    const bool whole = bytes.covered == (1u << sample) - 1;
    WrittenBytes written;
    const auto add = [&](std::uint64_t first, std::uint64_t last, bool covered) {
        if (std::max(first, line_begin) >= std::min(last, line_end)) return;
        const auto from = static_cast<std::uint32_t>(std::max(first, line_begin) - line_begin);
        const auto to = static_cast<std::uint32_t>(std::min(last, line_end) - line_begin);
        written.touched |= grain.touched(from, to);
        if (covered) written.covered |= grain.covered(from, to);
    };
    std::uint64_t begin = 0, end = 0; // a run of written samples that lie together
    const auto close = [&] {
        if (whole) return add(begin, end, true);
        for_each_written(begin, end, sample, bytes, add);
    };
    for (unsigned lane = 0; lane < 4; ++lane) {
        if ((quad.lanes >> lane & 1) == 0) continue;
        const std::uint64_t at = quad.addresses[lane];
        for (unsigned i = 0; i < place.samples; ++i) {
            if (place.samples > 1 && (quad.samples >> (4 * lane + i) & 1) == 0) continue;
            if (at + i * sample != end) {
                close();
                begin = at + i * sample;
            }
            end = at + (i + 1) * sample;
        }
    }
    close();
    return written;
}

// Of a pixel, of which these samples are written, with a bit a byte.
WrittenBytes pixel_bytes(const PlacedLevel& place, unsigned samples, PixelBytes bytes) {
    const std::uint32_t sample = place.layout.element_bytes / place.samples;
    WrittenBytes written;
    for (unsigned i = 0; i < place.samples; ++i)
        if (samples >> i & 1)
            written |=
                {LineMask{bytes.touched} << i * sample, LineMask{bytes.covered} << i * sample};
    return written;
}

} // namespace

WrittenBytes quad_bytes(const PlacedLevel& place,
                        const LineGrain& grain,
                        const WrittenQuad& quad,
                        std::uint64_t number,
                        PixelBytes bytes) {
    WrittenBytes written;
    if (bytes.touched == 0) return written;
    if (grain.bytes() > 1) return coarse_quad_bytes(place, grain, quad, number, bytes);
    const std::uint64_t line_begin = number * grain.line_bytes();
    const std::uint32_t pixel = place.layout.element_bytes;
    WrittenBytes of_pixel{bytes.touched, bytes.covered};
    for (unsigned lane = 0; lane < 4; ++lane) {
        if ((quad.lanes >> lane & 1) == 0) continue;
        const std::uint64_t at = quad.addresses[lane] - line_begin;
        if (place.samples > 1) of_pixel = pixel_bytes(place, quad.samples >> 4 * lane, bytes);
        if (at < grain.line_bytes())
            written |= {of_pixel.touched << at, of_pixel.covered << at};
        else if (std::uint64_t{0} - at < pixel) // It begins in the line before.
            written |= {of_pixel.touched >> -at, of_pixel.covered >> -at};
    }
    return {written.touched & grain.all(), written.covered & grain.all()};
}

namespace {

// All of a surface whose pixels lie side by side without gaps: one run of bytes. Where blocks are
// so small that their rows are parts of a line's bits, what is covered is told row by row.
bool is_one_run(const PlacedLevel& place, const LineGrain& grain, const Rectangle& cut) {
    const ImageLayout& layout = place.layout;
    const bool all = cut.x0 == 0 && cut.y0 == 0 && cut.x1 == static_cast<int>(layout.width) &&
                     cut.y1 == static_cast<int>(layout.height);
    const std::uint32_t row = layout.block * layout.element_bytes;
    return all &&
           layout.bytes() == std::uint64_t{layout.width} * layout.height * layout.element_bytes &&
           (layout.kind == Layout::Linear || remainder(row, grain.bytes()) == 0);
}

// Pixels [x0, x1) of row y0.
template <class Add>
void add_row(const PlacedLevel& place, const Rectangle& row, const Add& add) {
    const auto x1 = static_cast<std::uint32_t>(row.x1);
    std::uint64_t begin = 0, end = 0; // a run of pixels that lie together
    std::uint32_t run = 0;            // of them in a block
    for (auto x = static_cast<std::uint32_t>(row.x0); x < x1; x += run) {
        run = std::min(place.layout.run(x), x1 - x);
        const std::uint64_t at = place.address(x, static_cast<std::uint32_t>(row.y0), 0);
        if (at != end) {
            if (begin != end) add(begin, end);
            begin = at;
        }
        end = at + std::uint64_t{run} * place.layout.element_bytes;
    }
    if (begin != end) add(begin, end);
}

// A row of blocks from row y0 of the rectangle on: those that lie wholly in it are one run of
// bytes. Returns the rows; none: not so.
template <class Add>
std::uint32_t add_blocks(const PlacedLevel& place, const Rectangle& cut, const Add& add) {
    const ImageLayout& layout = place.layout;
    const std::uint32_t block = layout.block;
    const auto y = static_cast<std::uint32_t>(cut.y0);
    if (layout.kind != Layout::Blocked || remainder(y, block) != 0) return 0;
    if (y + block > static_cast<std::uint32_t>(cut.y1)) return 0;
    const auto x0 = static_cast<std::uint32_t>(cut.x0), x1 = static_cast<std::uint32_t>(cut.x1);
    const std::uint32_t first = (x0 + block - 1) & ~(block - 1), last = x1 & ~(block - 1);
    if (first >= last) return 0;
    const std::uint64_t begin = place.address(first, y, 0);
    add(begin, begin + std::uint64_t{last - first} * block * layout.element_bytes);
    for (int row = cut.y0; row < cut.y0 + static_cast<int>(block); ++row) {
        add_row(place, {cut.x0, row, static_cast<int>(first), 0}, add);
        add_row(place, {static_cast<int>(last), row, cut.x1, 0}, add);
    }
    return block;
}

} // namespace

std::vector<WrittenLine> rectangle_lines(const PlacedLevel& place,
                                         const LineGrain& grain,
                                         Rectangle rectangle,
                                         PixelBytes pixel) {
    const Rectangle cut = intersect(
        rectangle,
        {0, 0, static_cast<int>(place.layout.width), static_cast<int>(place.layout.height)});
    if (cut.empty() || pixel.touched == 0) return {};
    const std::uint32_t element = place.layout.element_bytes;
    const std::uint32_t sample = element / place.samples;
    const bool whole = pixel.covered == (1u << sample) - 1;
    // In every layout the first and the last byte are those of the corners.
    const auto corner = [&](int x, int y) {
        return place.address(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0);
    };
    Collector lines(
        corner(cut.x0, cut.y0), corner(cut.x1 - 1, cut.y1 - 1) + place.layout.element_bytes, grain);
    const auto add = [&](std::uint64_t begin, std::uint64_t end) {
        if (whole) return lines.add(begin, end, true);
        lines.add_pixels(begin, end, sample, pixel);
    };
    if (whole && is_one_run(place, grain, cut)) {
        add(place.base, place.base + place.layout.bytes());
        return lines.result();
    }
    // No bit of a line is of two rows of pixels.
    const bool by_blocks = remainder(place.layout.block * element, grain.bytes()) == 0;
    for (Rectangle left = cut; left.y0 < left.y1;) {
        const std::uint32_t rows = by_blocks ? add_blocks(place, left, add) : 0;
        if (rows == 0) add_row(place, left, add);
        left.y0 += static_cast<int>(std::max(rows, 1u));
    }
    return lines.result();
}

} // namespace ffgpu::work
