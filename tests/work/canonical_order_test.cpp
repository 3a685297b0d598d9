// CanonicalOrder against a plain sort by the parts of the key.

#include "model/work/canonical_order.h"

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// Primitive, piece, row, column, batch, place in it.
using Key = std::tuple<std::uint32_t, std::uint32_t, unsigned, unsigned, std::size_t, std::size_t>;

struct Sizes {
    unsigned batches, primitives, pieces, columns, rows;
};

std::vector<WorkBatch> random_batches(const Sizes& sizes, std::mt19937& random) {
    const auto below = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
    std::vector<WorkBatch> batches(sizes.batches);
    for (WorkBatch& batch : batches) {
        batch.quads.resize(below(65));
        for (WorkQuad& quad : batch.quads) {
            quad.primitive = below(sizes.primitives);
            quad.piece = below(sizes.pieces);
            quad.x = static_cast<std::uint16_t>(2 * below(sizes.columns));
            quad.y = static_cast<std::uint16_t>(2 * below(sizes.rows));
        }
    }
    return batches;
}

TEST_CASE("Quads come by primitive, piece, row and column, and those of one place as they came") {
    std::mt19937 random(20);
    CanonicalOrder order; // One for all: nothing stays from the draw before.
    for (const Sizes& sizes : {Sizes{0, 1, 1, 1, 1},
                               Sizes{1, 1, 1, 300, 1},
                               Sizes{40, 1, 1, 40, 30},
                               Sizes{40, 500, 1, 40, 30},
                               Sizes{30, 7, 3, 1000, 1000},
                               Sizes{10, 2, 2, 2, 2}})
        for (unsigned run = 0; run < 10; ++run) {
            const std::vector<WorkBatch> batches = random_batches(sizes, random);
            std::vector<const WorkBatch*> pointers;
            std::vector<Key> expected;
            for (std::size_t batch = 0; batch < batches.size(); ++batch) {
                pointers.push_back(&batches[batch]);
                for (std::size_t q = 0; q < batches[batch].quads.size(); ++q) {
                    const WorkQuad& quad = batches[batch].quads[q];
                    expected.emplace_back(quad.primitive, quad.piece, quad.y, quad.x, batch, q);
                }
            }
            std::sort(expected.begin(), expected.end());
            const auto sources = order.of(pointers, false);
            REQUIRE(sources.size() == expected.size());
            bool equal = true;
            for (std::size_t i = 0; i < sources.size(); ++i)
                equal = equal && sources[i].piece() == std::get<1>(expected[i]) &&
                        sources[i].batch == std::get<4>(expected[i]) &&
                        sources[i].quad == std::get<5>(expected[i]);
            CHECK(equal);
        }
}

} // namespace
} // namespace ffgpu::work
