#include "tests/experiments/figures/experiment.h"

#include <cmath>
#include <utility>

namespace ffgpu::experiments {

Verdict verdict(const Line& line, std::size_t value) {
    if (line.accepted.empty()) return Verdict::Beside;
    return line.accepted[value].holds(line.values[value]) ? Verdict::Met : Verdict::Failed;
}

Score& Score::operator+=(const Score& other) {
    met += other.met;
    failed += other.failed;
    return *this;
}

namespace {

Score score(const Line& line) {
    Score sum;
    for (std::size_t i = 0; i < line.values.size(); ++i) {
        const Verdict each = verdict(line, i);
        sum.met += each == Verdict::Met;
        sum.failed += each == Verdict::Failed;
    }
    return sum;
}

} // namespace

Score score(const Experiment& experiment) {
    Score sum;
    for (const Table& table : experiment.tables)
        for (const Row& row : table.rows)
            for (const Line& line : row.lines)
                sum += score(line);
    for (const Claim& claim : experiment.claims)
        ++(claim.holds ? sum.met : sum.failed);
    return sum;
}

Line within_points(std::string how,
                   const std::vector<double>& expected,
                   std::vector<double> values,
                   double points) {
    Line line{.how = std::move(how), .values = std::move(values), .difference = Difference::Points};
    for (const double each : expected)
        line.accepted.push_back({each - points, each + points});
    return line;
}

Line within_part(std::string how,
                 const std::vector<double>& expected,
                 std::vector<double> values,
                 double part) {
    Line line{
        .how = std::move(how), .values = std::move(values), .difference = Difference::Percent};
    for (const double each : expected)
        line.accepted.push_back({each - part * std::fabs(each), each + part * std::fabs(each)});
    return line;
}

} // namespace ffgpu::experiments
