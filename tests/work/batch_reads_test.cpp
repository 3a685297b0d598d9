// A batch's reads of texels, of which most are passed over, against each of them.

#include "model/work/batch_reads.h"

#include <array>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr std::uint32_t Size = 64, LineBytes = 64;

// One small level lies across lines: it has no rectangles.
TextureLines texture_of(Layout layout) {
    TextureLines texture;
    std::uint64_t at = 4096;
    for (std::uint32_t size = Size; size > 0; size /= 2) {
        const PlacedLevel level{.layout = ImageLayout::make(layout, 4, 32, size, size, 4),
                                .base = at + (size == 4 ? LineBytes / 2 : 0),
                                .layer_bytes = std::uint64_t{Size} * Size * 4};
        texture.add(level, LineBytes);
        at += 4 * level.layer_bytes;
    }
    return texture;
}

// Near each other, mostly squares; the level may be one that the texture lacks.
TexelAccess any_access(std::mt19937& random, unsigned lane, unsigned plane) {
    const auto less = [&](unsigned end) { return static_cast<std::uint16_t>(random() % end); };
    TexelAccess access{};
    access.lane = static_cast<std::uint16_t>(lane);
    access.level = static_cast<std::uint8_t>(less(100) == 0 ? less(9) : plane % 3);
    access.linear = static_cast<std::uint8_t>(less(100) == 0 ? less(8) : 3);
    const unsigned size = std::max(1u, Size >> access.level);
    access.x0 = static_cast<std::uint16_t>((lane / 8 + less(lane / 64 + 2)) % size);
    access.y0 = static_cast<std::uint16_t>((lane / 16 + less(3)) % size);
    access.x1 = static_cast<std::uint16_t>((access.x0 + 1u) % size);
    access.y1 = static_cast<std::uint16_t>((access.y0 + 1u) % size);
    if (less(150) == 0) access.x1 = TexelAccess::BorderTexel;
    if (less(150) == 0) access.y0 = TexelAccess::BorderTexel;
    if (less(100) == 0) access.layer0 = access.layer1 = less(2);
    return access;
}

std::vector<TexelAccess> any_quad(std::mt19937& random, unsigned quad, unsigned planes) {
    std::vector<TexelAccess> accesses;
    for (unsigned lane = 0; lane < 4; ++lane)
        for (unsigned plane = random() % 4 == 0 ? planes : 0u; plane < planes; ++plane) {
            accesses.push_back(any_access(random, 4 * quad + lane, plane));
            accesses.back().lane = static_cast<std::uint16_t>(lane);
        }
    return accesses;
}

// The next rectangle, level or layer.
void move_on(std::mt19937& random, std::vector<TexelAccess>& accesses) {
    const auto further = [](const TexelAccess& access, std::uint16_t& at) {
        at = static_cast<std::uint16_t>((at + 4u) % std::max(1u, Size >> access.level));
    };
    const unsigned what = random() % 4;
    for (TexelAccess& access : accesses) {
        if (what == 0) further(access, access.x0), further(access, access.x1);
        if (what == 1) further(access, access.y0), further(access, access.y1);
        if (what == 2) access.level ^= 1;
        if (what == 3) access.layer0 ^= 1, access.layer1 ^= 1;
    }
}

// Some quads read what the quad before does, or nearly so.
WorkBatch any_batch(std::mt19937& random, unsigned planes) {
    WorkBatch batch;
    batch.quads.resize(1 + random() % BatchQuads);
    for (std::uint8_t unit = 0; unit < 2; ++unit) {
        TexelFootprints& footprints = batch.textures.emplace_back();
        footprints.unit = unit;
        std::vector<TexelAccess> of_quad;
        for (unsigned quad = 0; quad < batch.quads.size(); ++quad) {
            if (quad % 4 == 0) of_quad = any_quad(random, quad, planes);
            if (quad % 4 == 2) move_on(random, of_quad);
            for (TexelAccess access : of_quad) {
                access.lane = static_cast<std::uint16_t>(access.lane + 4 * quad);
                footprints.add(access);
            }
        }
    }
    return batch;
}

bool has_others(const PlaneRectangles& rectangles, unsigned quad) {
    unsigned bits = 0;
    for (unsigned lane = 0; lane < 4; ++lane)
        bits |= rectangles.first[4 * quad + lane];
    return (bits & PlaneRectangles::Others) != 0;
}

} // namespace

TEST_CASE("vectors find the rectangles that quads read", "[scan]") {
    std::mt19937 random(3);
    std::size_t told = 0, others = 0;
    PlaneRectangles found, expected;
    for (unsigned i = 0; i < 300; ++i) {
        const WorkBatch batch = any_batch(random, 1 + i % 3);
        const RectangleBits bits{static_cast<std::uint16_t>(random() % 2 ? 0xfffc : 0xffff),
                                 static_cast<std::uint16_t>(random() % 2 ? 0xfff8 : 0x8000)};
        for (const AccessPlane& plane : batch.textures[0].planes) {
            FragmentMask live = plane.lanes;
            for (std::uint64_t& word : live.words)
                word &= std::uint64_t{random()} << 32 | random() | random();
            find_rectangles(plane, live, bits, found);
            find_rectangles_plainly(plane, live, bits, expected);
            for (unsigned quad = 0; quad < BatchQuads; ++quad) {
                if (live.quad(quad) == 0) continue;
                const bool is_other = has_others(expected, quad);
                REQUIRE(has_others(found, quad) == is_other);
                ++(is_other ? others : told);
                for (unsigned lane = 4 * quad; lane < 4 * quad + 4 && !is_other; ++lane) {
                    REQUIRE(found.first[lane] == expected.first[lane]);
                    REQUIRE(found.x[lane] == expected.x[lane]);
                    REQUIRE(found.y[lane] == expected.y[lane]);
                }
            }
        }
    }
    CHECK(told > 1000);
    CHECK(others > 1000);
}

TEST_CASE("a batch's quads read the lines that each of their reads tells", "[scan]") {
    for (const Layout layout : {Layout::Linear, Layout::Blocked, Layout::Blocked6d}) {
        std::mt19937 random(7);
        const TextureLines texture = texture_of(layout);
        const std::array<const TextureLines*, 2> textures{&texture, &texture};
        BatchReads reads;
        QuadLines found(LineBytes, true), expected(LineBytes, true);
        int repeated = 0;
        for (const unsigned planes : {1u, 2u, 4u, 5u})
            for (int i = 0; i < 60; ++i) {
                const WorkBatch batch = any_batch(random, planes);
                FragmentMask lanes;
                for (std::uint64_t& word : lanes.words)
                    word = ~(std::uint64_t{random()} & random() & random());
                reads.set(batch, lanes, textures);
                for (unsigned quad = 0; quad < batch.quads.size(); ++quad) {
                    const bool again = reads.repeats(quad);
                    repeated += again;
                    if (!again) {
                        found.begin_quad();
                        reads.add_quad(quad, found);
                    }
                    expected.begin_quad();
                    for (const TexelFootprints& unit : batch.textures)
                        for (const TexelAccess& access : unit.of_quad(quad))
                            if (lanes.quad(quad) >> access.lane & 1) expected.add(texture, access);
                    const auto lines = expected.lines();
                    REQUIRE(std::vector(found.lines().begin(), found.lines().end()) ==
                            std::vector(lines.begin(), lines.end()));
                    REQUIRE((again ? reads.reads(quad) : found.reads()) == expected.reads());
                    REQUIRE((again ? 0 : found.border_reads()) == expected.border_reads());
                }
            }
        CHECK(repeated > 0);
    }
}

} // namespace ffgpu::work
