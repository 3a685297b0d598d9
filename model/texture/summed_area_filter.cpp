// The mean over a box, from a summed-area table.

#include "model/texture/wide_filters.h"
#include "model/texture/wide_texels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ffgpu {
namespace {

using Sums = std::array<std::uint64_t, 4>; // by channel

// A part of the box along one axis: from .. to within the image, in 256ths of a texel.
struct Interval {
    std::int32_t from = 0, to = 0;

    std::int32_t length() const { return to - from; }
};

// At most two parts: a box is no longer than the image, so it crosses one edge.
struct Intervals {
    std::array<Interval, 2> parts;
    unsigned count = 0;

    void add(std::int32_t from, std::int32_t to) {
        if (from < to) parts[count++] = {from, to};
    }
};

// The part of the box in the image's repetition number `period`, of `length` 256ths of a texel.
void add_period(
    Intervals& intervals, Interval box, std::int32_t period, std::int32_t length, bool mirrored) {
    const std::int32_t from = std::max(box.from - period * length, 0);
    const std::int32_t to = std::min(box.to - period * length, length);
    if (mirrored && period % 2 != 0) return intervals.add(length - to, length - from);
    intervals.add(from, to);
}

// What the pixel covers, one texel at least, around the coordinate. Beyond a clamped edge there is
// nothing.
Intervals box_along(const TextureUnit& unit, unsigned axis, float s, const QuadSampling& quad) {
    const std::int32_t length = 256 * unit.size[axis];
    const float covered = std::max(std::fabs(quad.steps.x[axis]), std::fabs(quad.steps.y[axis]));
    const float texels =
        std::clamp(covered * unit.density[axis], 1.0f, static_cast<float>(unit.size[axis]));
    const std::int32_t width = round_to_int(texels * 256);

    const Fold fold = unit.linear_rules[axis].fold;
    const bool repeats = fold == Fold::Repeat || fold == Fold::Mirror;
    std::int32_t at = texel_position(fold, s, unit.size[axis]);
    if (!repeats) at = std::clamp(at, 0, length);
    const Interval box{at - width / 2, at - width / 2 + width};
    Intervals result;
    if (!repeats) {
        result.add(std::max(box.from, 0), std::min(box.to, length));
        return result;
    }
    const std::int32_t first = box.from < 0 ? -1 : box.from / length;
    for (std::int32_t period = first; period <= first + 1; ++period)
        add_period(result, box, period, length, fold == Fold::Mirror);
    return result;
}

class SummedAreaTable {
public:
    SummedAreaTable(const TextureUnit& unit, const FilterWitness& witness)
        : unit_(unit)
        , witness_(witness) {}

    // Of the rectangle, in units of 2^-16: 64 bits hold the sums of the corners modulo 2^48.
    Sums over(Interval x, Interval y) const {
        const Sums corners[]{
            below(x.to, y.to), below(x.from, y.to), below(x.to, y.from), below(x.from, y.from)};
        Sums sums{};
        for (unsigned channel = 0; channel < 4; ++channel)
            sums[channel] = (corners[0][channel] - corners[1][channel] - corners[2][channel] +
                             corners[3][channel]) &
                            ((std::uint64_t{1} << 48) - 1);
        return sums;
    }

private:
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
    const Intervals x = box_along(unit, 0, fragment.coord.s, quad);
    const Intervals y = box_along(unit, 1, fragment.coord.t, quad);
    const SummedAreaTable table(unit, witness);
    Sums sum{};
    std::uint64_t area = 0;
    for (unsigned j = 0; j < y.count; ++j)
        for (unsigned i = 0; i < x.count; ++i) {
            const Sums part = table.over(x.parts[i], y.parts[j]);
            for (unsigned channel = 0; channel < 4; ++channel)
                sum[channel] += part[channel];
            area += static_cast<std::uint64_t>(x.parts[i].length()) *
                    static_cast<std::uint64_t>(y.parts[j].length());
        }
    Rgba color{};
    for (unsigned channel = 0; channel < 4; ++channel)
        color[channel] = static_cast<std::uint8_t>((sum[channel] + area / 2) / area);
    return color;
}

} // namespace ffgpu
