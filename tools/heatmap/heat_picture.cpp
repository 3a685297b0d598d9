#include "tools/heatmap/heat_picture.h"

#include "model/base/input_error.h"
#include "tools/image/small_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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
    using Color = std::array<double, 3>;
    static constexpr std::array<Color, 7> Ramp{{{0, 0, 0},
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

HeatPlane averaged(const HeatPlane& plane, unsigned tile) {
    HeatPlane result = plane;
    for (unsigned y0 = 0; y0 < plane.height; y0 += tile) {
        for (unsigned x0 = 0; x0 < plane.width; x0 += tile) {
            const unsigned y1 = std::min(plane.height, y0 + tile);
            const unsigned x1 = std::min(plane.width, x0 + tile);
            const auto row = [&](auto& values, unsigned y) {
                return values.begin() + static_cast<std::ptrdiff_t>(y) * plane.width;
            };
            double sum = 0;
            for (unsigned y = y0; y < y1; ++y)
                for (unsigned x = x0; x < x1; ++x)
                    sum += row(plane.values, y)[x];
            const auto mean = static_cast<float>(sum / ((y1 - y0) * (x1 - x0)));
            for (unsigned y = y0; y < y1; ++y)
                std::fill(row(result.values, y) + x0, row(result.values, y) + x1, mean);
        }
    }
    return result;
}

Image heat_picture(HeatMap map,
                   const HeatPlane& plane,
                   const HeatMapOptions& options,
                   const Image& frame) {
    const double scale = full_scale(map, plane, options);
    Image image(plane.width, plane.height + LegendHeight);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        auto color = heat_color(plane.values[i] / scale);
        if (options.blend)
            for (std::uint8_t& channel : color)
                channel = static_cast<std::uint8_t>((channel + grey(&frame.rgb[3 * i])) / 2);
        std::ranges::copy(color, &image.rgb[3 * i]);
    }
    draw_legend(image, plane.height, fmt::format("{}: {}", info(map).name, info(map).unit), scale);
    return image;
}

} // namespace ffgpu::tools
