#include "driver/images/blit.h"

#include "driver/texel/texel_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ffgpu::gl {

namespace {

struct Span {
    std::int64_t begin, end;
};

Span ordered(std::int64_t a, std::int64_t b) {
    return {std::min(a, b), std::max(a, b)};
}

PixelRectangle intersect(const PixelRectangle& a, const PixelRectangle& b) {
    const std::int64_t left = std::max(a.x, b.x), bottom = std::max(a.y, b.y);
    const std::int64_t right = std::min(a.x + a.width, b.x + b.width);
    const std::int64_t top = std::min(a.y + a.height, b.y + b.height);
    return {left, bottom, right - left, top - bottom};
}

// The two source pixels that a target pixel mixes, and the weight of the second.
struct Tap {
    std::int64_t first = 0, second = 0;
    float weight = 0;
    bool inside = false;
};

// Linear filters do not reach beyond the source rectangle or the surface.
std::vector<Tap>
make_taps(const BlitAxis& axis, Span target, Span rectangle, std::int64_t size, bool linear) {
    const Span limit{std::max<std::int64_t>(rectangle.begin, 0), std::min(rectangle.end, size)};
    std::vector<Tap> taps;
    for (std::int64_t i = target.begin; i < target.end; ++i) {
        const double source = axis.source_of(i);
        const auto nearest = static_cast<std::int64_t>(std::floor(source));
        Tap tap{nearest, nearest, 0, nearest >= limit.begin && nearest < limit.end};
        if (linear && tap.inside) {
            const double corner = source - 0.5;
            const auto first = static_cast<std::int64_t>(std::floor(corner));
            tap.weight = static_cast<float>(corner - static_cast<double>(first));
            tap.first = std::clamp(first, limit.begin, limit.end - 1);
            tap.second = std::clamp(first + 1, limit.begin, limit.end - 1);
        }
        taps.push_back(tap);
    }
    return taps;
}

PixelColor mix(const PixelColor& a, const PixelColor& b, float weight) {
    PixelColor result;
    for (std::size_t i = 0; i < 4; ++i)
        result[i] = a[i] + (b[i] - a[i]) * weight;
    return result;
}

// What both kinds of blits share: the rectangles and the taps.
struct Plan {
    PixelRectangle source, target;
    std::vector<Tap> x, y;

    Plan(const Blit& blit, const Surface& from, const Surface& to)
        : source(clip_to(from, blit.source()))
        , target(clip_to(to, blit.target())) {
        if (target.empty()) return;
        const PixelRectangle whole = blit.source();
        x = make_taps(blit.x,
                      {target.x, target.x + target.width},
                      {whole.x, whole.x + whole.width},
                      from.width,
                      blit.linear);
        y = make_taps(blit.y,
                      {target.y, target.y + target.height},
                      {whole.y, whole.y + whole.height},
                      from.height,
                      blit.linear);
    }

    bool empty() const { return source.empty() || target.empty(); }

    std::size_t source_index(std::int64_t column, std::int64_t row) const {
        return static_cast<std::size_t>((row - source.y) * source.width + column - source.x);
    }

    // Calls visitor(index of the target pixel, tap in x, tap in y).
    template <class Visitor>
    void for_each(Visitor&& visitor) const {
        std::size_t index = 0;
        for (const Tap& row : y) {
            for (const Tap& column : x) {
                if (row.inside && column.inside) visitor(index, column, row);
                ++index;
            }
        }
    }
};

} // namespace

PixelRectangle Blit::source() const {
    const Span across = ordered(x.source_begin, x.source_end);
    const Span up = ordered(y.source_begin, y.source_end);
    return {across.begin, up.begin, across.end - across.begin, up.end - up.begin};
}

PixelRectangle Blit::target() const {
    const Span across = ordered(x.target_begin, x.target_end);
    const Span up = ordered(y.target_begin, y.target_end);
    return intersect({across.begin, up.begin, across.end - across.begin, up.end - up.begin}, clip);
}

bool Blit::empty() const {
    return source().empty() || target().empty();
}

void blit_colors(Device& device, const Surface& from, const Surface& to, const Blit& blit) {
    const Plan plan(blit, from, to);
    if (plan.empty()) return;
    const auto stored = read_surface(device, from, plan.source);
    std::vector<PixelColor> colors(
        static_cast<std::size_t>(plan.source.width * plan.source.height));
    decode_colors(from.format, stored.data(), colors);

    auto result = read_surface(device, to, plan.target);
    const std::size_t bytes = format_info(to.format).block_bytes;
    plan.for_each([&](std::size_t index, const Tap& x, const Tap& y) {
        const auto at = [&](std::int64_t column, std::int64_t row) -> const PixelColor& {
            return colors[plan.source_index(column, row)];
        };
        const PixelColor below = mix(at(x.first, y.first), at(x.second, y.first), x.weight);
        const PixelColor above = mix(at(x.first, y.second), at(x.second, y.second), x.weight);
        const PixelColor color = mix(below, above, y.weight);
        encode_colors(to.format, std::span(&color, 1), result.data() + index * bytes);
    });
    write_surface(device, to, plan.target, result);
}

void blit_depth_stencil(Device& device,
                        const Surface& from,
                        const Surface& to,
                        const Blit& blit,
                        DepthStencilMask mask) {
    const Plan plan(blit, from, to);
    if (plan.empty()) return;
    const std::size_t bytes = format_info(to.format).block_bytes; // The formats are the same.
    const std::size_t first = bytes == 4 && !mask.stencil ? 1 : 0;
    const std::size_t last = bytes == 4 && !mask.depth ? 1 : bytes;
    const auto stored = read_surface(device, from, plan.source);
    auto result = read_surface(device, to, plan.target);
    plan.for_each([&](std::size_t index, const Tap& x, const Tap& y) {
        const std::size_t source = plan.source_index(x.first, y.first);
        std::memcpy(result.data() + index * bytes + first,
                    stored.data() + source * bytes + first,
                    last - first);
    });
    write_surface(device, to, plan.target, result);
}

} // namespace ffgpu::gl
