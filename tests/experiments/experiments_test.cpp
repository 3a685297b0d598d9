// The experiments meet their tolerances, docs/experiments.md has their figures, and a figure that
// does not meet one is seen.

#include "tests/experiments/figures/all.h"
#include "tests/experiments/page/page.h"

#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

namespace ffgpu::experiments {
namespace {

std::string committed_page() {
    std::ifstream file(std::string(FFGPU_SOURCE_DIR) + "/docs/experiments.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

unsigned failed_by_formula(const Experiment& experiment) {
    unsigned failed = 0;
    for (const Table& table : experiment.tables)
        for (const Row& row : table.rows)
            for (const Line& line : row.lines)
                for (std::size_t i = 0; i < line.values.size(); ++i)
                    failed += line.how == "by formula" && verdict(line, i) == Verdict::Failed;
    return failed;
}

TEST_CASE("the page has the figures of the experiments that run without a clock", "[figures]") {
    const std::string text = committed_page();
    for (const Entry& entry : All) {
        if (entry.basis != Basis::Work) continue;
        DYNAMIC_SECTION(entry.id) {
            const Experiment experiment = entry.run();
            CHECK(experiment.id == entry.id);
            CHECK(score(experiment).met > 0);
            CHECK(failed_by_formula(experiment) == 0);
            const std::string own = section(experiment, "experiments");
            INFO(own);
            CHECK(text.find(own) != std::string::npos);
        }
    }
}

TEST_CASE("prefetching hides the latencies of the literature", "[figures]") {
    const Experiment experiment = latency_tolerance();
    INFO(section(experiment, "experiments"));
    CHECK(score(experiment).failed == 0);
}

TEST_CASE("the page tells of every experiment", "[figures]") {
    const std::string text = committed_page();
    for (const Entry& entry : All)
        CHECK(text.find("\n## " + std::string(entry.id) + ": ") != std::string::npos);
}

TEST_CASE("a figure is met up to its tolerance, and failed beyond it") {
    const Line points = within_points("", {1.0, 1.0, 1.0}, {1.05, 1.0501, 0.949}, 0.05 + 1e-9);
    CHECK(verdict(points, 0) == Verdict::Met);
    CHECK(verdict(points, 1) == Verdict::Failed);
    CHECK(verdict(points, 2) == Verdict::Failed);
    const Line part = within_part("", {2.0, 2.0}, {2.29, 2.31}, 0.15);
    CHECK(verdict(part, 0) == Verdict::Met);
    CHECK(verdict(part, 1) == Verdict::Failed);
}

TEST_CASE("the score counts figures and claims; what stands beside is not judged") {
    Row row{.name = "", .expected = {1, 2}, .lines = {}};
    row.lines.push_back(within_points("", row.expected, {1, 3}, 0.5));
    row.lines.push_back({.how = "beside", .values = {7, 8}});
    Experiment experiment;
    experiment.tables.push_back({.title = "", .columns = {"a", "b", "c"}, .rows = {row}});
    experiment.claims = {{"", "", true}, {"", "", false}};
    const Score own = score(experiment);
    CHECK(own.met == 2);
    CHECK(own.failed == 2);
    CHECK(section(experiment, "").find("**3.00 FAILED**") != std::string::npos);
}

} // namespace
} // namespace ffgpu::experiments
