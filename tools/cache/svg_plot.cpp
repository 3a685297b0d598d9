#include "tools/cache/svg_plot.h"

#include "tools/cache/size_name.h"
#include "tools/page/page.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr double Width = 720, Height = 420;
constexpr double Left = 64, Right = 590, Top = 44, Bottom = 366; // of the axes

// Colours that are told apart without red and green (M. Okabe, K. Ito, 2002), and dashes, so that
// colour is not needed.
constexpr std::array<const char*, 6> Colors{
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array<const char*, 3> Dashes{"", "6 3", "2 2"};

// The next of 1, 2, 5, 10, 20 ... thousandths, in five steps.
double nice_most(double value) {
    double step = 1e-3;
    for (unsigned i = 0; 5 * step < value; ++i)
        step *= i % 3 == 1 ? 2.5 : 2;
    return 5 * step;
}

class Drawing {
public:
    explicit Drawing(const Plot& plot)
        : plot_(plot) {
        for (const PlotSeries& series : plot.series)
            for (const auto& [size, value] : series.points) {
                least_ = std::min(least_, log2_of(size));
                most_ = std::max(most_, log2_of(size));
                highest_ = std::max(highest_, value);
            }
        highest_ = nice_most(highest_);
    }

    std::string text() {
        head();
        axes();
        for (std::size_t i = 0; i < plot_.series.size(); ++i)
            curve(i);
        return text_ + "</svg>\n";
    }

private:
    static double log2_of(std::uint64_t size) { return std::log2(static_cast<double>(size)); }
    std::string name_of(std::uint64_t size) const {
        return plot_.counts ? std::to_string(size) : size_name(size);
    }
    double x(double log2) const {
        const double range = std::max(most_ - least_, 1.0);
        return Left + (log2 - least_) / range * (Right - Left);
    }
    double y(double value) const { return Bottom - value / highest_ * (Bottom - Top); }

    template <class... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        text_ += fmt::format(format, std::forward<Values>(values)...);
    }

    void head() {
        add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" "
            "aria-label=\"{}\" font-family=\"sans-serif\" font-size=\"12\">\n",
            Width,
            Height,
            escaped(plot_.title));
        text_ += "<style>:root{color-scheme:light dark}svg{background:#fff}text{fill:#222}"
                 ".grid{stroke:#ddd}.curve{fill:none;stroke-width:2}"
                 "@media(prefers-color-scheme:dark){svg{background:#16181c}text{fill:#ddd}"
                 ".grid{stroke:#3a3f47}}</style>\n";
        add("<text x=\"{}\" y=\"24\" font-size=\"15\">{}</text>\n", Left, escaped(plot_.title));
    }

    void axes() {
        for (unsigned i = 0; i <= 5; ++i) {
            const double value = highest_ * i / 5, at = y(value);
            add("<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
                "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n",
                Left,
                Right,
                at,
                at,
                Left - 8,
                at + 4,
                value);
        }
        for (double log2 = std::ceil(least_); log2 <= most_; ++log2) {
            const double at = x(log2);
            add("<line class=\"grid\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\"/>"
                "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\" font-size=\"11\">{}</text>\n",
                at,
                at,
                Top,
                Bottom,
                at,
                Bottom + 18,
                name_of(std::uint64_t{1} << static_cast<unsigned>(log2)));
        }
        add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
            (Left + Right) / 2,
            Height - 10,
            escaped(plot_.sizes));
        add("<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
            (Top + Bottom) / 2,
            escaped(plot_.values));
    }

    void curve(std::size_t number) {
        const PlotSeries& series = plot_.series[number];
        const std::string style = fmt::format(R"(stroke="{}" stroke-dasharray="{}")",
                                              Colors[number % Colors.size()],
                                              Dashes[number / Colors.size() % Dashes.size()]);
        add(R"(<polyline class="curve" {} points=")", style);
        for (const auto& [size, value] : series.points)
            add("{:.1f},{:.1f} ", x(log2_of(size)), y(value));
        text_ += "\"/>\n";
        for (const auto& [size, value] : series.points)
            add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"><title>{}, {}: {:.4g}"
                "</title></circle>\n",
                x(log2_of(size)),
                y(value),
                Colors[number % Colors.size()],
                escaped(series.name),
                name_of(size),
                value);
        const double at = Top + 8 + 18 * static_cast<double>(number);
        add("<line class=\"curve\" {} x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\"/>"
            "<text x=\"{}\" y=\"{}\">{}</text>\n",
            style,
            Right + 12,
            Right + 36,
            at,
            at,
            Right + 42,
            at + 4,
            escaped(series.name));
    }

    const Plot& plot_;
    std::string text_;
    double least_ = 64, most_ = 0, highest_ = 0;
};

} // namespace

std::string svg(const Plot& plot) {
    return Drawing(plot).text();
}

} // namespace ffgpu::tools
