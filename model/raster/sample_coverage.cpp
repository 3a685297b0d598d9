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

// Calls visit(block) for the blocks of the tile that the record's box touches, masks all 0.
template <class Visit>
void for_each_block(const SetupRecord& record, const Rectangle& tile, Visit&& visit) {
    const Rectangle area = intersect(record.box, tile);
    for (int y = area.y0 & -BlockSize; y < area.y1; y += BlockSize)
        for (int x = area.x0 & -BlockSize; x < area.x1; x += BlockSize)
            visit(SampleBlock{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), {}},
                  intersect(area, {x, y, x + BlockSize, y + BlockSize}));
}

// A sample on the circle is inside.
bool inside_circle(const SetupRecord& record, SubPixelPoint at) {
    const std::int64_t dx = at.x - record.corners[0].x, dy = at.y - record.corners[0].y;
    const std::int64_t radius = record.corners[1].x;
    return dx * dx + dy * dy <= radius * radius;
}

bool inside_edges(const SetupRecord& record, int x, int y, SubPixelPoint position) {
    for (unsigned i = 0; i < record.edge_count; ++i) {
        const Edge& edge = record.edges[i];
        const std::int64_t at_centre = (edge.at(x, y) << SubPixelBits) + record.edge_fractions[i];
        if (at_centre + std::int64_t{edge.a} * position.x + std::int64_t{edge.b} * position.y < 0)
            return false;
    }
    return true;
}

bool inside(const SetupRecord& record, int x, int y, SubPixelPoint position) {
    constexpr int One = 1 << SubPixelBits;
    return record.coverage == CoverageKind::SamplePoint
               ? inside_circle(record,
                               {x * One + One / 2 + position.x, y * One + One / 2 + position.y})
               : inside_edges(record, x, y, position);
}

} // namespace

void cover_tile_samples_scalar(const SetupRecord& record,
                               const Rectangle& tile,
                               TileSampleCoverage& coverage) {
    coverage.count = 0;
    for_each_block(record, tile, [&](SampleBlock block, const Rectangle& area) {
        for (int y = area.y0; y < area.y1; ++y)
            for (int x = area.x0; x < area.x1; ++x)
                for (unsigned i = 0; i < MaxSamples; ++i)
                    if (inside(record, x, y, SamplePositions[i]))
                        block.masks[i] |= BlockMask{1} << block_bit(x - block.x, y - block.y);
        if (block.any() != 0) coverage.blocks[coverage.count++] = block;
    });
}

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
