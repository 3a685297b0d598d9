#include "tests/experiments/page/page.h"

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

std::string cells(const std::vector<std::string>& texts) {
    std::string row = "|";
    for (const std::string& text : texts)
        row += fmt::format("{}{} |", text.empty() ? "" : " ", text);
    return row + "\n";
}

// Figures that round to 0 have no sign.
std::string signed_figure(double value, int digits, const char* unit) {
    std::string text = fmt::format("{:+.{}f}", value, digits);
    if (text.find_first_of("123456789") == std::string::npos) text = text.substr(1);
    return text + unit;
}

std::string difference(const Row& row, const Line& line, std::size_t value, const Table& table) {
    const double expected = row.expected[value], obtained = line.values[value];
    if (line.difference == Difference::Percent)
        return signed_figure(expected == 0 ? 0 : 100 * (obtained / expected - 1), 1, " %");
    return signed_figure(obtained - expected, table.digits, "");
}

std::string obtained(const Line& line, std::size_t value, int digits) {
    const std::string figure = fmt::format("{:.{}f}", line.values[value], digits);
    return verdict(line, value) == Verdict::Failed ? fmt::format("**{} FAILED**", figure) : figure;
}

std::string text_of(const Row& row, const Table& table) {
    std::string text;
    std::vector<std::string> line_cells{row.name, "expected"};
    for (const double value : row.expected)
        line_cells.push_back(fmt::format("{:.{}f}", value, table.digits));
    if (!row.expected.empty()) text += cells(line_cells);
    for (const Line& line : row.lines) {
        const bool is_first = text.empty();
        line_cells = {is_first ? row.name : "", line.how};
        for (std::size_t i = 0; i < line.values.size(); ++i)
            line_cells.push_back(obtained(line, i, table.digits));
        text += cells(line_cells);
        if (line.difference == Difference::None) continue;
        line_cells = {"", "difference"};
        for (std::size_t i = 0; i < line.values.size(); ++i)
            line_cells.push_back(difference(row, line, i, table));
        text += cells(line_cells);
    }
    return text;
}

std::string text_of(const Table& table) {
    std::string text = table.title.empty() ? "\n" : fmt::format("\n{}:\n\n", table.title);
    std::vector<std::string> head{table.columns.front(), ""};
    head.insert(head.end(), table.columns.begin() + 1, table.columns.end());
    text += cells(head) + "|";
    for (std::size_t i = 0; i < head.size(); ++i)
        text += i < 2 ? "---|" : "---:|";
    text += "\n";
    for (const Row& row : table.rows)
        text += text_of(row, table);
    return text;
}

std::string text_of(const Claim& claim) {
    return fmt::format("- {}{}: {}\n",
                       claim.text,
                       claim.obtained.empty() ? "" : " (obtained: " + claim.obtained + ")",
                       claim.holds ? "holds" : "**FAILED**");
}

constexpr const char* Head =
    R"(# Published figures, and ffgpu's

Written by `./dev experiments`, which exits with status 1 where a figure lies outside its tolerance: here it stands as FAILED. Scenes are taken two ways: by formula,
without a rasterizer, and drawn by the functional GPU.
The tables of the literature look texels up a fragment at a time; ffgpu's machine works in quads, and merges a quad's reads of one line: its figures stand beside.
An expectation is never scaled. Tolerances: by formula 0.05 points (speeds 0.1), rasterized 15 % (P8: 10 %; speeds a point), counts exact, or as the row says.

)";

} // namespace

std::string section(const Experiment& experiment, const std::string& plots) {
    std::string text = fmt::format("## {}: {}\n\n{} Source: {}.\n",
                                   experiment.id,
                                   experiment.title,
                                   experiment.method,
                                   experiment.source);
    for (const Table& table : experiment.tables)
        text += text_of(table);
    if (!experiment.claims.empty()) text += "\n";
    for (const Claim& claim : experiment.claims)
        text += text_of(claim);
    for (const Plot& plot : experiment.plots)
        text += fmt::format("\n![{}]({}/{}.{})\n",
                            experiment.title,
                            plots,
                            plot.name,
                            plot.svg.empty() ? "png" : "svg");
    return text;
}

std::string page(const std::vector<Experiment>& experiments, const std::string& plots) {
    std::string text = Head;
    Score sum;
    text += "| | | met | failed |\n|---|---|---:|---:|\n";
    for (const Experiment& experiment : experiments) {
        const Score own = score(experiment);
        sum += own;
        text += fmt::format(
            "| {} | {} | {} | {} |\n", experiment.id, experiment.title, own.met, own.failed);
    }
    text += fmt::format("| | all | {} | {} |\n", sum.met, sum.failed);
    for (const Experiment& experiment : experiments)
        text.append("\n").append(section(experiment, plots));
    return text;
}

std::string score_line(const std::string& name, const Score& score) {
    return fmt::format("{}: {} met, {} failed", name, score.met, score.failed);
}

} // namespace ffgpu::experiments
