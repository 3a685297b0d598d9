// P10: how many texels, and lines, a fragment reads that nobody read before it.

#include "tests/experiments/figures/all.h"
#include "tests/experiments/figures/miss_machine.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

// A line of one texel is a texel.
work::WorkConfig machine(std::uint32_t texels_a_side) {
    MissMachine machine{Tiles8, {work::Layout::Blocked, texels_a_side}};
    machine.line_bytes = 4 * texels_a_side * texels_a_side;
    return machine.config();
}

double unique_lines(const Work& work, std::uint32_t texels_a_side) {
    const TexelStream stream = texel_stream(work, machine(texels_a_side));
    return static_cast<double>(std::set(stream.lines.begin(), stream.lines.end()).size()) /
           static_cast<double>(stream.fragments);
}

// The tolerance of texels; lines of 4x4 texels that the picture's edges cut are a part of 4/size on
// two sides.
constexpr double Part = 0.01, LinesPart = 0.025;

Line law_line(const std::string& how, const std::vector<double>& expected, const Work& work) {
    Line line =
        within_part(how, expected, {4 * unique_lines(work, 2), unique_lines(work, 4)}, Part);
    line.accepted[1] = {expected[1] * (1 - LinesPart), expected[1] * (1 + LinesPart)};
    return line;
}

Row law_row(const std::string& name, double level, const Work& formula, const Work& drawn) {
    const double texels = 1.25 * std::pow(4, level);
    const std::vector<double> expected{texels, texels / 16};
    return {name,
            expected,
            {law_line("by formula", expected, formula), law_line("rasterized", expected, drawn)}};
}

} // namespace

Experiment compulsory_law() {
    constexpr unsigned Size = 512;
    Table table{
        "", {"level of detail", "texels a fragment", "lines of 64 bytes a fragment"}, {}, 4};
    tools::Plot plot{"A trilinear picture", "level of detail, 1/256", "texels a fragment"};
    plot.counts = true;
    tools::PlotSeries law{"1.25 x 4^level", {}}, drawn{"rasterized", {}};
    for (const unsigned step : {16u, 32u, 64u, 128u, 192u, 248u}) {
        const double level = step / 256.0;
        table.rows.push_back(law_row(fmt::format("{:.4f}", level),
                                     level,
                                     analytic(timing::uniform_level_scene(Size, level)),
                                     rasterized(uniform_level_plane(Size, level))));
        law.points.emplace_back(step, table.rows.back().expected[0]);
        drawn.points.emplace_back(step, table.rows.back().lines[1].values[0]);
    }
    plot.series = {law, drawn};
    const std::vector<double> once{1, 1.0 / 16};
    table.rows.push_back({"bilinear, one to one",
                          once,
                          {law_line("by formula", once, flat_scene().formula),
                           law_line("rasterized", once, flat_scene().drawn)}});
    return {.id = "P10",
            .title = "What a texture that never repeats costs at least",
            .source = "Closed form: a fragment at level f covers 4^f texels of the finer level and "
                      "a quarter of that of the coarser, 1.25 x 4^f in all",
            .method = "Pictures of 512 x 512 pixels at one level of detail everywhere; lines of "
                      "2x2 and of 4x4 texels, none counted twice.",
            .tables = {table},
            .plots = {{"p10_compulsory", svg(plot)}}};
}

} // namespace ffgpu::experiments
