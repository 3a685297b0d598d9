// Helpers of the rasterizer's tests: vertices, records, coverage of a small window.

#pragma once

#include "model/raster/coverage.h"
#include "model/raster/quad_collector.h"
#include "model/raster/setup.h"
#include "model/raster/smooth_coverage.h"

#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

namespace ffgpu::test {

using Pixel = std::pair<int, int>;

// Calls body() with each instruction set that this processor has as Highway's choice.
template <class Body>
void for_each_target(Body&& body) {
    const std::int64_t supported = hwy::SupportedTargets();
    for (const std::int64_t target :
         {std::int64_t{HWY_SSE4}, std::int64_t{HWY_AVX2}, std::int64_t{HWY_AVX3}}) {
        if ((supported & target) == 0) continue;
        INFO("target " << hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        body();
    }
    hwy::SetSupportedTargetsForTest(0);
}

inline WindowVertex vertex(int x, int y, float depth = 0.5f, float inverse_w = 1) {
    WindowVertex v;
    v.x = x;
    v.y = y;
    v.depth = depth;
    v.inverse_w = inverse_w;
    v.attributes.fill(0);
    return v;
}

inline SetupContext context(Rectangle clip = {0, 0, 256, 256}) {
    SetupContext result;
    result.clip = clip;
    result.depth_scale = 0xffffff;
    return result;
}

// A record with room for its planes.
class RecordBuffer {
public:
    bool set_up(const SetupContext& context, const Primitive& primitive) {
        return ffgpu::set_up(context, primitive, record());
    }
    bool triangle(const SetupContext& context,
                  const WindowVertex& a,
                  const WindowVertex& b,
                  const WindowVertex& c,
                  std::uint32_t key = 0) {
        return set_up(context,
                      {.shape = PrimitiveShape::Triangle, .key = key, .vertices = {&a, &b, &c}});
    }
    SetupRecord& record() { return *reinterpret_cast<SetupRecord*>(bytes_.get()); }

private:
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    std::unique_ptr<Line[]> bytes_ = std::make_unique<Line[]>(MaxSetupRecordBytes / 64 + 1);
};

template <class Visit>
void for_each_pixel(const TileCoverage& coverage, Visit&& visit) {
    for (unsigned i = 0; i < coverage.count; ++i)
        for (int y = 0; y < BlockSize; ++y)
            for (int x = 0; x < BlockSize; ++x)
                if (coverage.blocks[i].mask >> block_bit(x, y) & 1)
                    visit(coverage.blocks[i].x + x, coverage.blocks[i].y + y);
}

// The pixels that a record covers within [0, 256)^2, taken tile by tile.
inline std::multiset<Pixel> covered_pixels(const SetupRecord& record, int tile_size = 64) {
    std::multiset<Pixel> pixels;
    TileCoverage coverage;
    for (int y = 0; y < 256; y += tile_size)
        for (int x = 0; x < 256; x += tile_size) {
            cover_tile(edge_set(record), {x, y, x + tile_size, y + tile_size}, coverage);
            for_each_pixel(coverage, [&](int px, int py) { pixels.emplace(px, py); });
        }
    return pixels;
}

// Raw draws of a seeded generator: the same everywhere.
class Random {
public:
    explicit Random(unsigned seed)
        : engine_(seed) {}

    int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
    int between(int low, int high) { return low + below(high - low + 1); }
    float unit() { return static_cast<float>(engine_() >> 8) / 16777216.0f; }

private:
    std::mt19937 engine_;
};

// The points of a grid of MeshCells x MeshCells cells of 20 pixels, row by row. Inner points are
// moved at will, but not so far that a triangle turns over, then down to multiples of `grid` / 256.
constexpr int MeshCells = 12;
inline std::vector<WindowVertex> random_mesh(Random& random, int grid) {
    constexpr int Step = 20 * 256;
    std::vector<WindowVertex> points;
    for (int j = 0; j <= MeshCells; ++j)
        for (int i = 0; i <= MeshCells; ++i) {
            const bool inner = i > 0 && j > 0 && i < MeshCells && j < MeshCells;
            const int range = inner ? Step / 4 : 0;
            const int x = i * Step + random.between(-range, range);
            const int y = j * Step + random.between(-range, range);
            points.push_back(vertex(x & -grid, y & -grid));
        }
    return points;
}

} // namespace ffgpu::test
