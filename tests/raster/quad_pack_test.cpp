// The quads of blocks, side by side: the vector form against the scalar one, on each instruction
// set.

#include "model/raster/quad_pack.h"
#include "tests/raster/raster_helpers.h"

#include <algorithm>
#include <array>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

struct Places {
    std::array<std::uint16_t, BlockQuads> x{}, y{};
};

void check_block(PackQuads form, const BlockCoverage& block) {
    Places vector, scalar;
    const PackedQuads a = form(block, vector.x.data(), vector.y.data());
    const PackedQuads b = pack_quads_scalar(block, scalar.x.data(), scalar.y.data());
    REQUIRE(a.count == b.count);
    REQUIRE(a.lanes == b.lanes);
    REQUIRE(std::equal(scalar.x.begin(), scalar.x.begin() + b.count, vector.x.begin()));
    REQUIRE(std::equal(scalar.y.begin(), scalar.y.begin() + b.count, vector.y.begin()));
}

} // namespace

TEST_CASE("the quads of a block stand side by side, row by row") {
    Places at;
    const BlockMask mask =
        BlockMask{0x9} << (4 * 2) | BlockMask{0x6} << (4 * 5) | BlockMask{0xf} << (4 * 15);
    const PackedQuads packed = pack_quads_scalar({40, 24, mask}, at.x.data(), at.y.data());
    CHECK(packed.count == 3);
    CHECK(packed.lanes == 0xf69);
    CHECK(at.x[0] == 44);
    CHECK(at.y[0] == 24);
    CHECK(at.x[1] == 42);
    CHECK(at.y[1] == 26);
    CHECK(at.x[2] == 46);
    CHECK(at.y[2] == 30);
}

TEST_CASE("the vector form packs what the scalar form packs") {
    for_each_target([] {
        const PackQuads form = choose_pack_quads();
        Random random(9);
        const auto word = [&] {
            BlockMask bits = 0;
            for (int i = 0; i < 8; ++i)
                bits = bits << 8 | static_cast<unsigned>(random.below(256));
            return bits;
        };
        const auto block = [&](BlockMask mask) {
            const int x = 8 * random.below(1024), y = 8 * random.below(1024);
            return BlockCoverage{
                static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), mask};
        };
        check_block(form, block(FullBlock));
        for (unsigned quads = 1; quads < 1u << BlockQuads; quads += 7) { // Which quads there are.
            BlockMask mask = word();
            for (unsigned q = 0; q < BlockQuads; ++q) {
                const BlockMask lanes = BlockMask{0xf} << (4 * q);
                if ((quads >> q & 1) == 0) mask &= ~lanes;
            }
            check_block(form, block(mask));
        }
    });
}
