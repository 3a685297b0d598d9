// P12: lines that several fragment pipes fetch, each into a cache of its own.

#include "tests/experiments/figures/all.h"
#include "tests/timing/picture_quads.h"

#include <set>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

using timing::Distribution;
using timing::PictureSize;

constexpr std::uint64_t Unique = PictureSize * PictureSize / 16; // lines of the texture

struct Share {
    const char* name;
    Distribution distribution;
    std::uint32_t width;
};
constexpr Share Tiles{"tiles of 8x8", Distribution::Tiles, 8},
    Scanlines{"scan lines by twos", Distribution::Scanlines, 2};

// Fetched a line of the texture, by caches that never lose one.
double fetched(const Share& share, unsigned pipes) {
    timing::TimingConfig config = timing::caches_machine(pipes, share.distribution, share.width);
    config.texel_cache.ways = Unique;
    const std::uint64_t misses = timing::run(config, timing::picture()).at("texel_cache_misses");
    return static_cast<double>(misses) / Unique;
}

double touched(const Share& share, unsigned pipes) {
    std::set<std::pair<unsigned, unsigned>> all; // pipe and line
    for (const timing::QuadLines& quad : timing::quads_in_order())
        for (const unsigned line : quad.lines)
            all.insert({timing::pipe_of(quad, share.distribution, share.width, pipes), line});
    return static_cast<double>(all.size()) / Unique;
}

} // namespace

Experiment parallel_caches() {
    Table table{"Lines fetched, of each that the texture has", {"share of a pipe"}, {}};
    tools::Plot plot{"A picture of one texel a pixel", "fragment pipes", "fetched a line"};
    plot.counts = true;
    for (const Share& share : {Tiles, Scanlines}) {
        std::vector<double> expected, obtained;
        tools::PlotSeries& series = plot.series.emplace_back(tools::PlotSeries{share.name, {}});
        for (const unsigned pipes : {1u, 2u, 4u, 8u, 16u}) {
            expected.push_back(touched(share, pipes));
            obtained.push_back(fetched(share, pipes));
            series.points.emplace_back(pipes, obtained.back());
        }
        table.rows.push_back(
            {share.name, expected, {within_points("machine in time", expected, obtained, 0)}});
    }
    for (const unsigned pipes : {1u, 2u, 4u, 8u, 16u})
        table.columns.push_back(fmt::format("{} pipe{}", pipes, pipes == 1 ? "" : "s"));
    const std::vector<double>&tiles = table.rows[0].lines[0].values,
          &scanlines = table.rows[1].lines[0].values;
    bool rises = tiles[0] == 1 && scanlines[0] == 1, more = true;
    for (std::size_t i = 1; i < tiles.size(); ++i) {
        rises =
            rises && tiles[i] > 1 && tiles[i] >= tiles[i - 1] && scanlines[i] >= scanlines[i - 1];
        more = more && scanlines[i] > tiles[i];
    }
    return {.id = "P12",
            .title = "Lines that parallel texture caches fetch more than once",
            .source = "H. Igehy, M. Eldridge, P. Hanrahan, Parallel Texture Caching, HWWS 1999: "
                      "redundant work rises with the units. Expected counts: the pairs of pipe and "
                      "line, from the coordinates alone",
            .method = "A picture of 256 x 256 pixels, a texel a pixel, through the machine in "
                      "time; each pipe has a cache that holds the whole texture.",
            .tables = {table},
            .claims = {{"1 with one pipe, and no less with more of them", "", rises},
                       {"more by scan lines than by tiles", "", more}},
            .plots = {{"p12_pipes", svg(plot)}}};
}

} // namespace ffgpu::experiments
