#include "tools/sweep/pareto_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr double Width = 720, Height = 460;
constexpr double Left = 90, Right = 690, Top = 44, Bottom = 400; // of the axes
constexpr int Ticks = 5;

// A part more than the values take, on either side.
struct Axis {
    double least = 0, most = 1;

    template <class Value>
    Axis(const std::vector<ParetoPoint>& points, const Value& value) {
        if (points.empty()) return;
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [&](const ParetoPoint& a, const ParetoPoint& b) {
                return value(a) < value(b);
            });
        const double margin = std::max(0.05 * (value(*high) - value(*low)), 0.01 * value(*high));
        least = value(*low) - margin;
        most = value(*high) + margin;
        if (most <= least) most = least + 1;
    }
    double part(double value) const { return (value - least) / (most - least); }
    double at(int tick) const { return least + (most - least) * tick / Ticks; }
};

// 1.23 M
std::string short_number(double value) {
    const double size = std::fabs(value);
    if (size >= 1e9) return fmt::format("{:.3g} G", value * 1e-9);
    if (size >= 1e6) return fmt::format("{:.3g} M", value * 1e-6);
    if (size >= 1e3) return fmt::format("{:.3g} k", value * 1e-3);
    return fmt::format("{:.3g}", value);
}

class Drawing {
public:
    explicit Drawing(const ParetoPlot& plot)
        : plot_(plot)
        , prices_(plot.points, [](const ParetoPoint& p) { return p.price; })
        , cycles_(plot.points, [](const ParetoPoint& p) { return p.cycles; }) {}

    std::string text() {
        head();
        axes();
        front();
        for (const bool best : {false, true})
            for (const ParetoPoint& point : plot_.points)
                if (point.is_best == best) dot(point);
        return text_ + "</svg>\n";
    }

private:
    double x(const ParetoPoint& point) const {
        return Left + prices_.part(point.price) * (Right - Left);
    }
    double y(const ParetoPoint& point) const {
        return Bottom - cycles_.part(point.cycles) * (Bottom - Top);
    }

    void head() {
        text_ += fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
            "aria-label=\"{2}\" font-family=\"sans-serif\" font-size=\"12\">\n"
            "<style>:root{{color-scheme:light dark}}svg{{background:#fff}}text{{fill:#222}}"
            ".grid{{stroke:#ddd}}.dot{{fill:#56b4e9}}.best{{fill:#d55e00}}"
            ".front{{fill:none;stroke:#d55e00;stroke-width:2}}"
            "@media(prefers-color-scheme:dark){{svg{{background:#16181c}}text{{fill:#ddd}}"
            ".grid{{stroke:#3a3f47}}}}</style>\n"
            "<text x=\"{3}\" y=\"24\" font-size=\"15\">{2}</text>\n",
            Width,
            Height,
            plot_.title,
            Left);
    }

    void axes() {
        for (int tick = 0; tick <= Ticks; ++tick) {
            const double part = static_cast<double>(tick) / Ticks;
            const double column = Left + part * (Right - Left),
                         row = Bottom - part * (Bottom - Top);
            text_ += fmt::format(
                "<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
                "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n"
                "<line class=\"grid\" x1=\"{6:.1f}\" x2=\"{6:.1f}\" y1=\"{7}\" y2=\"{8}\"/>"
                "<text x=\"{6:.1f}\" y=\"{9}\" text-anchor=\"middle\">{10}</text>\n",
                Left,
                Right,
                row,
                Left - 8,
                row + 4,
                short_number(cycles_.at(tick)),
                column,
                Top,
                Bottom,
                Bottom + 18,
                short_number(prices_.at(tick)));
        }
        text_ += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
                             "<text transform=\"translate(18 {}) rotate(-90)\" "
                             "text-anchor=\"middle\">cycles</text>\n",
                             (Left + Right) / 2,
                             Height - 16,
                             plot_.prices,
                             (Top + Bottom) / 2);
    }

    // In steps: what lies to the right of and above it is no better.
    void front() {
        std::vector<ParetoPoint> best;
        for (const ParetoPoint& point : plot_.points)
            if (point.is_best) best.push_back(point);
        std::sort(best.begin(), best.end(), [](const ParetoPoint& a, const ParetoPoint& b) {
            return a.price < b.price;
        });
        std::string path;
        for (const ParetoPoint& point : best)
            path += path.empty() ? fmt::format("M{:.1f} {:.1f}", x(point), y(point))
                                 : fmt::format("H{:.1f}V{:.1f}", x(point), y(point));
        text_ += fmt::format("<path class=\"front\" d=\"{}\"/>\n", path);
    }

    void dot(const ParetoPoint& point) {
        text_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\">"
                             "<title>{}: {:.0f} cycles, {:.0f}</title></circle>\n",
                             point.is_best ? "best" : "dot",
                             x(point),
                             y(point),
                             point.is_best ? 4 : 3,
                             point.name,
                             point.cycles,
                             point.price);
    }

    const ParetoPlot& plot_;
    const Axis prices_, cycles_;
    std::string text_;
};

} // namespace

std::string svg(const ParetoPlot& plot) {
    return Drawing(plot).text();
}

} // namespace ffgpu::tools
