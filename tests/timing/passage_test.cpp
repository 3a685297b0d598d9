#include "model/timing/passage.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {

TEST_CASE("a passage that tells something new has moved") {
    Passage passage;
    const auto moves = [&](const auto& happens) {
        const Passage before = passage;
        happens();
        CHECK(before != passage);
        return before.moves() != passage.moves();
    };
    CHECK(moves([&] { ++passage.entered; }));
    CHECK(moves([&] { passage.enter_unit(7); }));
    CHECK(moves([&] { passage.leave(); }));
    CHECK(moves([&] { passage.leave(9); }));
    CHECK(moves([&] { passage.looked_up += 2; }));
    CHECK(moves([&] { ++passage.worked; }));
    CHECK(moves([&] { ++passage.waited; }));
    passage.worked = ~0u; // Counts begin anew.
    CHECK(moves([&] { ++passage.worked; }));
}

} // namespace ffgpu::timing
