// P4: misses by kind, and where on the screen they are.

#include "model/work/lookup_walk.h"
#include "model/work/miss_curves.h"
#include "tests/experiments/figures/all.h"
#include "tests/experiments/figures/miss_machine.h"
#include "tests/work/plain_cache.h"
#include "tools/cache/miss_map.h"

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

using work::LookupClient;

// The look-ups of texels, for the curves and for a plain cache of each shape.
class Texels final : public work::LookupSink {
public:
    Texels(work::MissCurves& curves, std::vector<test::PlainCache>& plain)
        : curves_(curves)
        , plain_(plain) {}

    void lookups(LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t) override {
        if (client != LookupClient::Texel) return;
        curves_.lookups(place, lines);
        for (test::PlainCache& cache : plain_)
            for (const work::LineLookup& lookup : lines)
                cache.access(lookup.line, false);
    }
    void flush(LookupClient) override {}
    void overwritten(LookupClient, std::span<const work::OverwrittenLine>) override {}
    void end_frame(std::uint32_t) override {}

private:
    work::MissCurves& curves_;
    std::vector<test::PlainCache>& plain_;
};

template <class Sink>
void play(const Work& work, Sink& sink) {
    for (const auto& command : work)
        sink.command(command);
    sink.end_frame(0);
}

struct Shape {
    const char* name;
    std::uint32_t sets, ways;
};
constexpr std::uint32_t LineBytes = 128;
constexpr std::array<Shape, 4> Shapes{{{"128 KB, fully associative", 1, 1024},
                                       {"32 KB, fully associative", 1, 256},
                                       {"32 KB, 2 ways", 128, 2},
                                       {"32 KB, direct mapped", 256, 1}}};

Line kinds_line(const std::string& how, const std::array<std::uint64_t, 4>& counts) {
    Line line{.how = how, .values = {}};
    for (const std::uint64_t count : counts)
        line.values.push_back(static_cast<double>(count));
    return line;
}

Plot miss_map(const Work& work, const work::WorkConfig& config) {
    tools::MissMap map(config, {Shapes[2].sets, Shapes[2].ways, LineBytes});
    play(work, map.sink());
    return {"p4_miss_map", {}, map.picture(640, 480)};
}

} // namespace

Experiment kinds_of_misses() {
    const Work& work = floor_scene(1024).drawn;
    const work::WorkConfig config =
        MissMachine{Tiles8, Blocks4, work::Granularity::Quad, LineBytes}.config();
    std::vector<test::PlainCache> plain;
    for (const Shape& shape : Shapes)
        plain.emplace_back(shape.sets, shape.ways);
    work::MissCurves curves({.line_bytes = LineBytes, .lookup_bytes = LineBytes});
    Texels texels(curves, plain);
    work::LookupWalk walk(config, {}, texels);
    work::MachineOrder order(config, walk);
    play(work, order);

    Table table{"Misses",
                {"cache, lines of 128 bytes", "compulsory", "capacity", "conflict", "all"},
                {},
                0};
    Experiment experiment{
        .id = "P4",
        .title = "Misses by kind, and where they are",
        .source = "Hakura and Gupta 1997, and the pictures of their project's page: fully "
                  "associative 128 KB has next to none but cold misses, 32 KB capacity misses as "
                  "well, fewer ways conflict misses. Expected counts: a plain cache beside a plain "
                  "fully associative one, which share no code with ffgpu's one pass",
        .method = "The floor of 1024 texels, rasterized, in quads. In the picture (32 KB, 2 ways) "
                  "quads with one miss are blue, with two green, with more red.",
        .tables = {},
        .plots = {miss_map(work, config)}};
    for (std::size_t i = 0; i < Shapes.size(); ++i) {
        const work::CacheCounts counts = curves.sums().counts(Shapes[i].sets, Shapes[i].ways);
        const test::PlainCounts& direct = plain[i].counts;
        Line obtained = kinds_line(
            "rasterized", {counts.compulsory, counts.capacity, counts.conflict, counts.misses});
        const std::vector<double> expected =
            kinds_line("", {direct.compulsory, direct.capacity, direct.conflict, direct.misses})
                .values;
        obtained = within_points(obtained.how, expected, obtained.values, 0);
        table.rows.push_back({Shapes[i].name, expected, {obtained}});
        experiment.claims.push_back(
            {fmt::format("{}: the kinds add up to the misses", Shapes[i].name),
             fmt::format("{}", counts.compulsory + counts.capacity + counts.conflict),
             counts.compulsory + counts.capacity + counts.conflict == counts.misses});
    }
    experiment.tables = {table};
    return experiment;
}

} // namespace ffgpu::experiments
