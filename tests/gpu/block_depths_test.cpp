// The farthest depth of a block: the vector form against the scalar one, on each instruction set.

#include "model/gpu/block_depths.h"
#include "model/memory/pixel_format.h"
#include "tests/raster/raster_helpers.h"

#include <random>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

TEST_CASE("The farthest depth of a block is one of its pixels'") {
    for (const Format format : {Format::Depth16, Format::Depth24Stencil8}) {
        const std::uint32_t pixel_bytes = format_info(format).block_bytes;
        const Surface target{
            .address = 40, .format = format, .width = 24, .height = 16, .stride = 27 * pixel_bytes};
        std::mt19937 random(3);
        for_each_target([&] {
            const FarthestInRows form = choose_farthest_in_rows();
            for (int i = 0; i < 300; ++i) {
                // All bits, so that the greatest may have its highest set; few, so that many are 0.
                std::vector<std::byte> memory(4096);
                for (std::byte& byte : memory)
                    byte = static_cast<std::byte>(i % 2 == 0 ? random() : random() & random() & 1);
                const auto x = static_cast<unsigned>(random() % 3 * 8),
                           y = static_cast<unsigned>(random() % 2 * 8);
                const std::uint32_t expected = farthest_depth_scalar(target, x, y, memory);
                const std::byte* const first = memory.data() + pixel_place(target, x, y);
                REQUIRE(form(first, target.stride, format) == expected);
                REQUIRE(farthest_depth(target, x, y, memory) == expected);
            }
        });
    }
}
