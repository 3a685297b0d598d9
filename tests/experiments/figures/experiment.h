// An experiment of the literature: the figures that it should give, those that ffgpu obtains, and
// what of them is met.

#pragma once

#include "tools/cache/svg_plot.h"
#include "tools/image/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::experiments {

struct Range {
    double least = 0, most = 0;

    bool holds(double value) const { return value >= least && value <= most; }
};

enum class Difference : std::uint8_t { None, Points, Percent };

// One way to obtain a row's figures.
struct Line {
    std::string how;
    std::vector<double> values;
    std::vector<Range> accepted = {}; // a range a value; empty: it stands beside, unjudged
    Difference difference = Difference::None;
};

struct Row {
    std::string name;
    std::vector<double> expected; // empty: of ranges alone
    std::vector<Line> lines;
};

struct Table {
    std::string title;
    std::vector<std::string> columns; // the first names the rows
    std::vector<Row> rows;
    int digits = 2;
};

// What has to hold besides single figures.
struct Claim {
    std::string text, obtained;
    bool holds = false;
};

// A file beside the page: a chart, or a picture.
struct Plot {
    std::string name; // of the file, without its extension
    std::string svg = {};
    tools::Image picture = {};
};

struct Experiment {
    std::string id, title;
    std::string source; // who published the figures, or how they were computed
    std::string method; // what is run
    std::vector<Table> tables = {};
    std::vector<Claim> claims = {};
    std::vector<Plot> plots = {};
};

enum class Verdict : std::uint8_t { Beside, Met, Failed };

// Of a value of a line.
Verdict verdict(const Line& line, std::size_t value);

struct Score {
    unsigned met = 0, failed = 0;

    Score& operator+=(const Score& other);
};
Score score(const Experiment& experiment);

// The line's figures may differ from the expected ones by so many points, or by this part of them.
Line within_points(std::string how,
                   const std::vector<double>& expected,
                   std::vector<double> values,
                   double points);
Line within_part(std::string how,
                 const std::vector<double>& expected,
                 std::vector<double> values,
                 double part);

} // namespace ffgpu::experiments
