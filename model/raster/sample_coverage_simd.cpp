// Each sample's traversal by vectors, the four then put together.

#include "model/raster/sample_coverage.h"

#include <algorithm>

namespace ffgpu {
namespace {

// The blocks of four traversals as one list.
void merge(const std::array<TileCoverage, MaxSamples>& samples, TileSampleCoverage& coverage) {
    constexpr std::uint32_t Nowhere = ~std::uint32_t{0};
    std::array<unsigned, MaxSamples> next{};
    const auto place = [&](unsigned i) {
        if (next[i] == samples[i].count) return Nowhere;
        const BlockCoverage& block = samples[i].blocks[next[i]];
        return std::uint32_t{block.y} << 16 | block.x;
    };
    while (true) {
        const std::uint32_t lowest = std::min({place(0), place(1), place(2), place(3)});
        if (lowest == Nowhere) return;
        SampleBlock& block = coverage.blocks[coverage.count++];
        block.x = static_cast<std::uint16_t>(lowest);
        block.y = static_cast<std::uint16_t>(lowest >> 16);
        for (unsigned i = 0; i < MaxSamples; ++i)
            block.masks[i] = place(i) == lowest ? samples[i].blocks[next[i]++].mask : 0;
    }
}

} // namespace

void cover_tile_samples(const SetupRecord& record,
                        const Rectangle& tile,
                        TileSampleCoverage& coverage) {
    if (record.coverage == CoverageKind::SamplePoint)
        return cover_tile_samples_scalar(record, tile, coverage);
    coverage.count = 0;
    std::array<TileCoverage, MaxSamples> samples;
    for (unsigned i = 0; i < MaxSamples; ++i) {
        std::array<Edge, MaxEdges> edges;
        for (unsigned e = 0; e < record.edge_count; ++e)
            edges[e] = record.exact_edge(e).moved(SamplePositions[i]);
        cover_tile({record.box, {edges.data(), record.edge_count}}, tile, samples[i]);
    }
    merge(samples, coverage);
}

} // namespace ffgpu
