#include "tools/heatmap/heat_picture.h"

#include "model/base/input_error.h"
#include "tools/image/small_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr unsigned RampHeight = 8, Margin = 2;
constexpr unsigned LegendHeight = RampHeight + SmallTextHeight + 3 * Margin;

double full_scale(HeatMap map, const HeatPlane& plane, const HeatMapOptions& options) {
    const double wanted = options.full_scale.value_or(info(map).full_scale);
    if (wanted > 0 || plane.values.empty()) return wanted > 0 ? wanted : 1;
    // A few pixels that stand out, as the frame's first, would leave all the others dark.
    std::vector<float> values = plane.values;
    const auto nearly_most = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 200);
    std::ranges::nth_element(values, nearly_most);
    if (*nearly_most > 0) return *nearly_most;
    const double most = *std::max_element(nearly_most, values.end());
    return most > 0 ? most : 1;
}

// By eye: 3 parts red, 6 green, 1 blue.
std::uint8_t grey(const std::uint8_t* rgb) {
    return static_cast<std::uint8_t>((3 * rgb[0] + 6 * rgb[1] + rgb[2]) / 10);
}

void draw_legend(Image& image, unsigned top, std::string_view what, double scale) {
    for (unsigned y = top + Margin; y < top + Margin + RampHeight; ++y)
        for (unsigned x = 0; x < image.width; ++x)
            std::ranges::copy(heat_color(x / std::max(1.0, image.width - 1.0)),
                              &image.rgb[3 * (std::size_t{image.width} * y + x)]);
    const unsigned y = top + 2 * Margin + RampHeight;
    const std::string most = fmt::format("{:g}", scale);
    const unsigned ends = small_text_width("0 ") + small_text_width(most) + SmallTextAdvance;
    draw_small_text(image, 1, y, "0");
    if (image.width > small_text_width(most))
        draw_small_text(image, image.width - small_text_width(most), y, most);
    if (image.width >= ends + small_text_width(what))
        draw_small_text(image, (image.width - small_text_width(what)) / 2, y, what);
}

} // namespace

double parse_heat_scale(const std::string& text) {
    if (text == "auto") return 0;
    double scale = 0;
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, scale);
    if (error != std::errc() || at != end || !std::isfinite(scale) || scale <= 0)
        throw InputError("--heatmap-scale " + text + ": expected auto or a number above 0");
    return scale;
}

std::array<std::uint8_t, 3> heat_color(double value) {
    static constexpr std::array<std::array<double, 3>, 7> Ramp{{{0, 0, 0},
                                                                {0, 0, 255},
                                                                {0, 255, 255},
                                                                {0, 255, 0},
                                                                {255, 255, 0},
                                                                {255, 0, 0},
                                                                {255, 255, 255}}};
    const double at = std::clamp(value, 0.0, 1.0) * (Ramp.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), Ramp.size() - 2);
    const double share = at - static_cast<double>(low);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t c = 0; c < 3; ++c)
        color[c] =
            static_cast<std::uint8_t>(Ramp[low][c] * (1 - share) + Ramp[low + 1][c] * share + 0.5);
    return color;
}

namespace {

// Calls each(square) with the rows of each square: pointers into the plane and their length.
template <class Each>
void for_each_square(HeatPlane& plane, unsigned tile, Each&& each) {
    for (unsigned y0 = 0; y0 < plane.height; y0 += tile) {
        for (unsigned x0 = 0; x0 < plane.width; x0 += tile) {
            std::vector<std::span<float>> rows;
            for (unsigned y = y0; y < std::min(plane.height, y0 + tile); ++y)
                rows.push_back(std::span(plane.values)
                                   .subspan(std::size_t{y} * plane.width + x0,
                                            std::min(plane.width - x0, tile)));
            each(rows);
        }
    }
}

void fill(const std::vector<std::span<float>>& rows, float value) {
    for (const std::span<float> row : rows)
        std::ranges::fill(row, value);
}

} // namespace

HeatPlane averaged(const HeatPlane& plane, unsigned tile) {
    HeatPlane result = plane;
    for_each_square(result, tile, [](const std::vector<std::span<float>>& rows) {
        double sum = 0;
        for (const std::span<float> row : rows)
            for (const float value : row)
                sum += value;
        fill(rows, static_cast<float>(sum / static_cast<double>(rows.size() * rows[0].size())));
    });
    return result;
}

HeatPlane most_common(const HeatPlane& plane, unsigned tile) {
    HeatPlane result = plane;
    for_each_square(result, tile, [](const std::vector<std::span<float>>& rows) {
        std::map<float, std::size_t> counts;
        for (const std::span<float> row : rows)
            for (const float value : row)
                ++counts[value];
        const auto most = std::ranges::max_element(
            counts, [](const auto& a, const auto& b) { return a.second < b.second; });
        fill(rows, most->first);
    });
    return result;
}

std::array<std::uint8_t, 3> name_color(std::size_t number) {
    // As many as the machine has resources, in their order; by eye, neighbours in the pipe apart.
    static constexpr std::array<std::uint32_t, timing::Resources> Colors{0x888888,
                                                                         0xbbbbbb,
                                                                         0x8c564b,
                                                                         0xc49c94,
                                                                         0xe377c2,
                                                                         0xf7b6d2,
                                                                         0x7f3f9f,
                                                                         0xb080e0,
                                                                         0x5050ff,
                                                                         0xffff00,
                                                                         0x00c0ff,
                                                                         0x00d000,
                                                                         0x90ff90,
                                                                         0xff00ff,
                                                                         0xffa000,
                                                                         0xff0000,
                                                                         0xff8080,
                                                                         0xffffff,
                                                                         0x007070};
    if (number == 0) return {};
    const std::uint32_t color = Colors[(number - 1) % Colors.size()];
    return {static_cast<std::uint8_t>(color >> 16),
            static_cast<std::uint8_t>(color >> 8 & 0xff),
            static_cast<std::uint8_t>(color & 0xff)};
}

namespace {

using Color = std::array<std::uint8_t, 3>;

// The plane, above room for a legend.
template <class ColorOf>
Image painted(const HeatPlane& plane,
              unsigned legend_height,
              const Image* under,
              ColorOf&& color_of) {
    Image image(plane.width, plane.height + legend_height);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        Color color = color_of(plane.values[i]);
        if (under)
            for (std::uint8_t& channel : color)
                channel = static_cast<std::uint8_t>((channel + grey(&under->rgb[3 * i])) / 2);
        std::ranges::copy(color, &image.rgb[3 * i]);
    }
    return image;
}

struct NamedColor {
    std::size_t number = 0;
    std::string_view name;
    unsigned x = 0, y = 0; // in the legend
};

constexpr unsigned NameHeight = RampHeight + Margin;

// The names that occur, in rows below the map's title.
std::vector<NamedColor> names_in(const HeatMapInfo& map, const HeatPlane& plane) {
    const std::set<float> values(plane.values.begin(), plane.values.end());
    std::vector<NamedColor> found;
    unsigned x = 0, y = SmallTextHeight + 2 * Margin;
    for (std::size_t number = 1; number <= map.names.size(); ++number) {
        if (!values.contains(static_cast<float>(number))) continue;
        const std::string_view name = map.names[number - 1];
        const unsigned width = RampHeight + Margin + small_text_width(name) + SmallTextAdvance;
        if (x > 0 && x + width > plane.width) {
            x = 0;
            y += NameHeight;
        }
        found.push_back({number, name, x, y});
        x += width;
    }
    return found;
}

void draw_names(Image& image, unsigned top, const std::vector<NamedColor>& names) {
    for (const NamedColor& name : names) {
        const Color color = name_color(name.number);
        for (unsigned y = top + name.y; y < top + name.y + RampHeight; ++y)
            for (unsigned x = name.x; x < std::min(image.width, name.x + RampHeight); ++x)
                std::ranges::copy(color, &image.rgb[3 * (std::size_t{image.width} * y + x)]);
        draw_small_text(image, name.x + RampHeight + Margin, top + name.y, name.name);
    }
}

Image names_picture(HeatMap map, const HeatPlane& plane, const Image* under) {
    const std::vector<NamedColor> names = names_in(info(map), plane);
    const unsigned height =
        (names.empty() ? SmallTextHeight + Margin : names.back().y) + NameHeight;
    Image image = painted(plane, height, under, [](float value) {
        return name_color(static_cast<std::size_t>(value));
    });
    draw_small_text(
        image, 1, plane.height + Margin, fmt::format("{}: {}", info(map).name, info(map).unit));
    draw_names(image, plane.height, names);
    return image;
}

} // namespace

Image heat_picture(HeatMap map,
                   const HeatPlane& plane,
                   const HeatMapOptions& options,
                   const Image& frame) {
    const Image* const under = options.blend ? &frame : nullptr;
    if (!info(map).names.empty()) return names_picture(map, plane, under);
    const double scale = full_scale(map, plane, options);
    Image image =
        painted(plane, LegendHeight, under, [&](float value) { return heat_color(value / scale); });
    draw_legend(image, plane.height, fmt::format("{}: {}", info(map).name, info(map).unit), scale);
    return image;
}

} // namespace ffgpu::tools
