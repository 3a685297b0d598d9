// P7: a second-level texture cache over the frames of a walk.

#include "model/work/first_level.h"
#include "model/work/lookup_walk.h"
#include "tests/experiments/figures/all.h"
#include "tests/experiments/figures/miss_machine.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

constexpr unsigned Frames = 8, Size = 1024;
constexpr double Step = 0.05; // of the camera a frame, in repeats of the small texture
constexpr std::uint32_t LineBytes = 64, FirstSets = 128, FirstWays = 2; // 16 KB
constexpr std::uint32_t SecondSets = 4096, SecondWays = 8;              // 2 MB

struct FrameCounts {
    std::uint64_t first_misses = 0, second_misses = 0;

    double hit_percent() const {
        return 100 - 100 * static_cast<double>(second_misses) / static_cast<double>(first_misses);
    }
    double host_megabytes() const { return 1e-6 * LineBytes * static_cast<double>(second_misses); }
};

// Behind the first level: what comes here missed there.
class SecondLevel final : public work::LookupSink {
public:
    void lookups(work::LookupClient client,
                 const work::LookupPlace&,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t) override {
        if (client != work::LookupClient::Texel) return;
        for (const work::LineLookup& lookup : lines) {
            ++now_.first_misses;
            if (const work::TagArray::Line* const line = tags_.find(lookup.line)) {
                tags_.use(*line);
                continue;
            }
            work::TagArray::Evicted evicted;
            tags_.replace(lookup.line, evicted);
            ++now_.second_misses;
        }
    }
    void flush(work::LookupClient) override {}
    void overwritten(work::LookupClient, std::span<const work::OverwrittenLine>) override {}
    void end_frame(std::uint32_t) override {
        frames.push_back(now_);
        now_ = {};
    }

    std::vector<FrameCounts> frames;

private:
    work::TagArray tags_{SecondSets, SecondWays};
    FrameCounts now_;
};

std::vector<FrameCounts> walk() {
    SecondLevel second;
    work::FirstLevel first(FirstSets, FirstWays, LineBytes, second);
    const work::WorkConfig config =
        MissMachine{Tiles8, Blocks4, work::Granularity::Quad, LineBytes}.config();
    work::LookupWalk lookups(config, {}, first);
    work::MachineOrder order(config, lookups);
    for (unsigned frame = 0; frame < Frames; ++frame) {
        for (const auto& command : rasterized(floor_plane(Size, Step * frame)))
            order.command(command);
        order.end_frame(frame);
    }
    return second.frames;
}

} // namespace

Experiment second_level() {
    const std::vector<FrameCounts> frames = walk();
    Table table{"", {"frame"}, {{"", {}, {}}}};
    Line hits{.how = "hits of the second level, %", .values = {}},
        host{.how = "MB from the host with it", .values = {}},
        pull{.how = "MB from the host without (pull)", .values = {}};
    tools::Plot plot{
        "A walk over the floor of 1024 texels", "frame", "hits of the second level, %"};
    plot.counts = true;
    tools::PlotSeries& series = plot.series.emplace_back(tools::PlotSeries{"2 MB, 8 ways", {}});
    double least_later = 100, most_host_later = 0;
    bool below_pull = true;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        table.columns.push_back(fmt::format("{}", i));
        hits.values.push_back(frames[i].hit_percent());
        host.values.push_back(frames[i].host_megabytes());
        pull.values.push_back(1e-6 * LineBytes * static_cast<double>(frames[i].first_misses));
        series.points.emplace_back(i + 1, hits.values[i]);
        below_pull = below_pull && host.values[i] < pull.values[i];
        if (i == 0) continue;
        least_later = std::min(least_later, hits.values[i]);
        most_host_later = std::max(most_host_later, host.values[i]);
    }
    table.rows[0].lines = {hits, host, pull};
    constexpr double Push = 1e-6 * 4 * Size * Size * 4 / 3; // all levels, whole, on the card
    return {
        .id = "P7",
        .title = "A second-level texture cache over the frames of a walk",
        .source = "M. Cox, N. Bhandari, M. Shantz, Multi-Level Texture Caching for 3D Graphics "
                  "Hardware, ISCA 1998: reuse between frames; far less memory than push, far "
                  "less from the host than pull. No figures are claimed: the shape is expected",
        .method = "The camera goes forward over the floor of 1024 texels, rasterized; 16 KB of "
                  "2 ways, behind it 2 MB of 8 ways.",
        .tables = {table},
        .claims =
            {{"the second level hits more in every later frame than in the first",
              fmt::format("{:.1f} % at least, {:.1f} % in the first", least_later, hits.values[0]),
              least_later > hits.values[0]},
             {"the host sends less in every later frame than in the first",
              fmt::format(
                  "{:.2f} MB at most, {:.2f} MB in the first", most_host_later, host.values[0]),
              most_host_later < host.values[0]},
             {"it sends less than without the second level", "", below_pull},
             {"the second level is smaller than the texture that push would hold",
              fmt::format("2.10 MB of {:.2f} MB", Push),
              1e-6 * LineBytes * SecondSets * SecondWays < Push}},
        .plots = {{"p7_second_level", svg(plot)}}};
}

} // namespace ffgpu::experiments
