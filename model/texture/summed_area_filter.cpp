// The mean over a box, from a summed-area table.

#include "model/base/check.h"
#include "model/texture/wide_filters.h"
#include "model/texture/wide_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace ffgpu {
namespace {

using Sums = std::array<std::uint64_t, 4>; // by channel

// Along one axis, from .. to within the image, in 256ths of a texel.
struct Interval {
    std::int32_t from = 0, to = 0;

    std::int32_t length() const { return to - from; }
};

// Texels, and how much of the box they stand for: their own length, but that an edge's texel stands
// for all that lies beyond it.
struct Part {
    Interval texels;
    std::int32_t covers = 0; // 256ths of a texel
};

// A box along one axis. Two parts at most: it is no longer than the image, so it crosses one edge.
// What they leave of it is border.
struct BoxParts {
    std::array<Part, 2> parts;
    unsigned count = 0;
    std::int32_t width = 0;

    void add(const Interval& texels) {
        if (texels.length() > 0) parts[count++] = {texels, texels.length()};
    }
    void add_edge(std::int32_t first_texel, std::int32_t covers) {
        if (covers > 0) parts[count++] = {{first_texel, first_texel + 256}, covers};
    }
};

// The part of the box in the image's repetition number `period`, of `length` 256ths of a texel.
void add_period(
    BoxParts& parts, Interval box, std::int32_t period, std::int32_t length, bool mirrored) {
    const std::int32_t from = std::max(box.from - period * length, 0);
    const std::int32_t to = std::min(box.to - period * length, length);
    if (mirrored && period % 2 != 0) return parts.add({length - to, length - from});
    parts.add({from, to});
}

void add_repeated(BoxParts& parts, const Interval& box, std::int32_t length, bool mirrored) {
    const std::int32_t first = box.from < 0 ? -1 : box.from / length;
    for (std::int32_t period = first; period <= first + 1; ++period)
        add_period(parts, box, period, length, mirrored);
}

// Below 0 a mirrored coordinate comes back; what is not said here is border.
void add_clamped(BoxParts& parts, const Interval& box, std::int32_t length, Wrap wrap) {
    const bool edge = wrap == Wrap::ClampToEdge || wrap == Wrap::MirrorClampToEdge;
    parts.add({std::max(box.from, 0), std::min(box.to, length)});
    if (wrap_rule(wrap, true).fold == Fold::MirrorClamp)
        parts.add({std::max(-box.to, 0), std::min(-box.from, length)});
    else if (edge)
        parts.add_edge(0, std::min(-box.from, parts.width));
    if (edge) parts.add_edge(length - 256, std::min(box.to - length, parts.width));
}

// What the pixel covers, one texel at least, around the coordinate.
BoxParts box_along(const TextureUnit& unit, unsigned axis, float s, const QuadSampling& quad) {
    const std::int32_t length = 256 * unit.size[axis];
    const float covered = std::max(std::fabs(quad.steps.x[axis]), std::fabs(quad.steps.y[axis]));
    const float texels =
        std::clamp(covered * unit.density[axis], 1.0f, static_cast<float>(unit.size[axis]));

    const Wrap wrap = unit.sampler.wrap[axis];
    BoxParts parts{.parts = {}, .width = round_to_int(texels * 256)};
    const bool mirrored = wrap_rule(wrap, true).fold == Fold::MirrorClamp;
    const std::int32_t at = texel_position(wrap, s, unit.size[axis]);
    const std::int32_t from = (mirrored ? std::abs(at) : at) - parts.width / 2;
    const Interval box{from, from + parts.width};
    if (wrap == Wrap::Repeat || wrap == Wrap::MirroredRepeat)
        add_repeated(parts, box, length, wrap == Wrap::MirroredRepeat);
    else
        add_clamped(parts, box, length, wrap);
    return parts;
}

class SummedAreaTable {
public:
    SummedAreaTable(const TextureUnit& unit, const FilterWitness& witness)
        : unit_(unit)
        , witness_(witness) {}

    // Of the box's part, in units of 2^-16. A texel that stands for more than itself has a sum that
    // is a multiple of 256.
    Sums over(const Part& x, const Part& y) const {
        Sums sums = over(x.texels, y.texels);
        for (const Part& part : {x, y})
            if (part.covers != part.texels.length())
                for (std::uint64_t& sum : sums)
                    sum = sum / 256 * static_cast<std::uint64_t>(part.covers);
        return sums;
    }

    // Of a border's part of so many units.
    Sums over_border(std::uint64_t area) const {
        constexpr std::uint16_t Border = TexelAccess::BorderTexel;
        witness_.tell({.lane = static_cast<std::uint16_t>(witness_.lane),
                       .level = 0,
                       .linear = 0,
                       .x0 = Border,
                       .x1 = Border,
                       .y0 = Border,
                       .y1 = Border,
                       .layer0 = 0,
                       .layer1 = 0},
                      {AxisTexels{-1, -1, 0}, AxisTexels{-1, -1, 0}, AxisTexels{}});
        const Rgba color = read_stored_texel(unit_, {Border, Border}, witness_.observer);
        Sums sums{};
        for (unsigned channel = 0; channel < 4; ++channel)
            sums[channel] = color[channel] * area;
        return sums;
    }

private:
    // A word is below 2^32, a corner below 2^48.
    Sums over(const Interval& x, const Interval& y) const {
        const Sums corners[]{
            below(x.to, y.to), below(x.from, y.to), below(x.to, y.from), below(x.from, y.from)};
        Sums sums{};
        for (unsigned channel = 0; channel < 4; ++channel)
            sums[channel] = corners[0][channel] - corners[1][channel] - corners[2][channel] +
                            corners[3][channel];
        return sums;
    }

    // The integral from the first texel's corner to (x, y): between the table's words it is
    // bilinear.
    Sums below(std::int32_t x, std::int32_t y) const {
        const std::uint64_t wx = x & 0xff, wy = y & 0xff;
        const std::array<Sums, 4> words = entries((x >> 8) - 1, (y >> 8) - 1, wx != 0, wy != 0);
        Sums sums{};
        for (unsigned channel = 0; channel < 4; ++channel)
            sums[channel] = (words[0][channel] * (256 - wx) + words[1][channel] * wx) * (256 - wy) +
                            (words[2][channel] * (256 - wx) + words[3][channel] * wx) * wy;
        return sums;
    }

    // Entries (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1), as far as they are wanted. Column and
    // row -1 are 0 and not read.
    std::array<Sums, 4> entries(std::int32_t x, std::int32_t y, bool right, bool lower) const {
        std::array<Sums, 4> result{};
        const std::int32_t first_row = y < 0 ? 0 : y, last_row = lower ? y + 1 : y;
        if (first_row > last_row) return result;
        for (std::int32_t column = std::max(x, 0); column <= (right ? x + 1 : x); ++column)
            for (std::uint32_t half = 0; half < TableChannels; half += 2)
                read(column, first_row, last_row, half, &result[column == x ? 0 : 1], y);
        return result;
    }

    // Channels `half` and the next of a column's entries in one or two rows.
    void read(std::int32_t column,
              std::int32_t first_row,
              std::int32_t last_row,
              std::uint32_t half,
              Sums* into,
              std::int32_t y) const {
        const auto x0 =
            static_cast<std::uint16_t>(TableChannels * static_cast<std::uint32_t>(column) + half);
        const auto x1 = static_cast<std::uint16_t>(x0 + 1);
        witness_.tell({.lane = static_cast<std::uint16_t>(witness_.lane),
                       .level = 0,
                       .linear = static_cast<std::uint8_t>(first_row == last_row ? 1 : 3),
                       .x0 = x0,
                       .x1 = x1,
                       .y0 = static_cast<std::uint16_t>(first_row),
                       .y1 = static_cast<std::uint16_t>(last_row),
                       .layer0 = 0,
                       .layer1 = 0},
                      {AxisTexels{x0, x1, 0}, AxisTexels{first_row, last_row, 0}, AxisTexels{}});
        for (std::int32_t row = first_row; row <= last_row; ++row)
            for (std::uint32_t i = 0; i < 2; ++i)
                into[row == y ? 0 : 2][half + i] = word(i == 0 ? x0 : x1, row);
    }

    std::uint32_t word(std::uint16_t x, std::int32_t y) const {
        const Rgba bytes = read_stored_texel(
            unit_, {.x = x, .y = static_cast<std::uint16_t>(y)}, witness_.observer);
        std::uint32_t value = 0;
        for (unsigned i = 0; i < 4; ++i)
            value |= std::uint32_t{bytes[i]} << (8 * i);
        return value;
    }

    const TextureUnit& unit_;
    const FilterWitness& witness_;
};

} // namespace

Rgba filter_summed_area(const TextureUnit& unit,
                        const SampledFragment& fragment,
                        const QuadSampling& quad,
                        const FilterWitness& witness) {
    const BoxParts x = box_along(unit, 0, fragment.coord.s, quad);
    const BoxParts y = box_along(unit, 1, fragment.coord.t, quad);
    const SummedAreaTable table(unit, witness);
    const auto area_of = [](std::int32_t width, std::int32_t height) {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    };
    const std::uint64_t area = area_of(x.width, y.width);
    check(area > 0, "a box is at least a texel wide and high");
    std::uint64_t border = area;
    Sums sum{};
    const auto add = [&sum](const Sums& part) {
        for (unsigned channel = 0; channel < 4; ++channel)
            sum[channel] += part[channel];
    };
    for (unsigned j = 0; j < y.count; ++j)
        for (unsigned i = 0; i < x.count; ++i) {
            add(table.over(x.parts[i], y.parts[j]));
            border -= area_of(x.parts[i].covers, y.parts[j].covers);
        }
    if (border != 0) add(table.over_border(border));
    Rgba color{};
    for (unsigned channel = 0; channel < 4; ++channel)
        color[channel] = static_cast<std::uint8_t>((sum[channel] + area / 2) / area);
    return color;
}

} // namespace ffgpu
