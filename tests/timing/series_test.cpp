// The series: what the accounts counted, interval after interval, is all that they counted.

#include "model/timing/series.h"
#include "model/timing/without_limit.h"
#include "tests/timing/machine_figures.h"
#include "tests/timing/random_work.h"

#include <numeric>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

struct Collected : SeriesSink {
    struct Row {
        Cycle begin = 0, cycles = 0;
        std::vector<std::uint64_t> counts;
        std::uint32_t frame = 0;
        bool operator==(const Row&) const = default;
    };

    void columns(std::span<const SeriesColumn> columns) override {
        for (const SeriesColumn& column : columns)
            names.emplace_back(column.name);
    }
    void sample(const SeriesSample& sample) override {
        rows.push_back(
            {sample.begin, sample.cycles, {sample.counts.begin(), sample.counts.end()}, 0});
    }
    void end_frame(std::uint32_t frame) override {
        for (; in_frames < rows.size(); ++in_frames)
            rows[in_frames].frame = frame;
    }
    std::uint64_t at(const Row& row, const std::string& name) const {
        return row.counts.at(
            static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
    }

    std::vector<std::string> names;
    std::vector<Row> rows;
    std::size_t in_frames = 0;
};

struct Outcome {
    Figures figures;
    std::vector<Cycle> frames; // their cycles
    std::vector<std::string> units;
};

Outcome run_frames(TimingConfig config,
                   std::uint64_t seed,
                   std::uint32_t interval,
                   SeriesSink& sink,
                   const Evaluation& evaluation = {}) {
    config.series.interval_cycles = interval;
    GpuTiming timing(config, evaluation);
    timing.set_series_sink(&sink);
    Outcome outcome;
    timing.set_on_frame([&](const FrameTiming& frame) { outcome.frames.push_back(frame.cycles); });
    RandomWork work(seed);
    for (const std::uint32_t frame : {3u, 4u}) {
        for (const auto& command : work.frame(4))
            timing.command(command);
        timing.end_frame(frame);
    }
    outcome.figures = figures_of(timing);
    outcome.units = timing.unit_names();
    return outcome;
}

TEST_CASE("the samples of a series sum to the counters, and change none of them") {
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        const TimingConfig config = RandomWork(~seed).machine();
        Collected nobody;
        const Figures without = run_frames(config, seed, 0, nobody).figures;
        CHECK(nobody.rows.empty());
        for (const std::uint32_t interval : {37u, 1000u, 100'000'000u}) {
            CAPTURE(seed, interval);
            Collected series;
            const Outcome outcome = run_frames(config, seed, interval, series);
            REQUIRE(outcome.figures == without);
            Figures sums;
            for (const Collected::Row& row : series.rows)
                for (std::size_t i = 0; i < series.names.size(); ++i)
                    sums[series.names[i]] += row.counts[i];
            for (const auto& [name, sum] : sums)
                if (sum != without.at(name)) FAIL_CHECK(name << ": " << sum);
            CHECK(series.in_frames == series.rows.size());
        }
    }
}

TEST_CASE("a sample covers its interval, or the rest of its frame, and all cycles of each unit") {
    const TimingConfig config = RandomWork(~std::uint64_t{5}).machine();
    constexpr Cycle Interval = 500;
    Collected series;
    const Outcome outcome = run_frames(config, 5, Interval, series);
    Cycle begin = 0;
    std::map<std::uint32_t, Cycle> left{{3, outcome.frames[0]}, {4, outcome.frames[1]}};
    for (const Collected::Row& row : series.rows) {
        CHECK(row.begin == begin);
        CHECK(row.cycles == std::min(Interval, left.at(row.frame)));
        CHECK(series.at(row, "total_cycles") == row.cycles);
        left.at(row.frame) -= row.cycles;
        begin += row.cycles;
        // What the frame waited for is known when it is over: its last row has all.
        Cycle waited = 0;
        for (std::size_t i = 0; i < Resources; ++i)
            if (has_limit(config, static_cast<Resource>(i)))
                waited += series.at(row, "bottleneck_" + std::string(ResourceNames[i]) + "_cycles");
        CHECK(waited == (left.at(row.frame) == 0 ? outcome.frames[row.frame - 3] : 0));
        for (const std::string& unit : outcome.units) {
            Cycle cycles = 0;
            for (const std::string_view activity : ActivityNames)
                cycles += series.at(row, unit + '_' + std::string(activity) + "_cycles");
            CHECK(cycles == row.cycles);
        }
    }
    CHECK(left.at(3) == 0);
    CHECK(left.at(4) == 0);
}

TEST_CASE("a series is the same at every pace of the clock") {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const TimingConfig config = RandomWork(~seed).machine();
        Collected every, decoupled;
        run_frames(config, seed, 64, every, {0, Pace::EveryCycle});
        run_frames(config, seed, 64, decoupled, {3, Pace::Decoupled});
        CAPTURE(seed);
        // What the memory's buses lost is counted when the next data are on them, or a frame ends.
        CHECK(every.rows.size() == decoupled.rows.size());
        for (std::size_t i = 0; i < every.rows.size(); ++i)
            for (std::size_t column = 0; column < every.names.size(); ++column)
                if (every.names[column].rfind("memory_", 0) != 0 &&
                    every.rows[i].counts[column] != decoupled.rows[i].counts[column])
                    FAIL_CHECK(every.names[column] << " in row " << i);
    }
}

TEST_CASE("what a unit does at first stands in the first samples") {
    TimingConfig config; // A draw takes 1000 cycles to decode: all behind it is idle.
    config.command_processor.draw_cycles = 1000;
    config.host.bytes_per_cycle = 0;
    config.series.interval_cycles = 100;
    GpuTiming timing(config);
    Collected series;
    timing.set_series_sink(&series);
    RandomWork work(1);
    timing.command(std::make_shared<work::WholeCommand>(work.draw(0, 30, 100)));
    timing.end_frame(0);
    for (std::size_t i = 1; i < 9; ++i) {
        CHECK(series.at(series.rows[i], "command_processor_busy_cycles") == 100);
        CHECK(series.at(series.rows[i], "color_idle_cycles") == 100);
        CHECK(series.at(series.rows[i], "queue_commands_item_cycles") >= 100); // the draw itself
        CHECK(series.at(series.rows[i], "queue_draws_item_cycles") == 0);
    }
}

} // namespace
} // namespace ffgpu::timing
