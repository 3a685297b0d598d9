// Ring against the standard library's queue.

#include "model/base/ring.h"

#include <deque>
#include <memory>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

TEST_CASE("a ring holds what a queue holds, however often it has wrapped and grown") {
    std::mt19937 random(3);
    Ring<int> ring;
    std::deque<int> expected;
    for (int i = 0; i < 5000; ++i) {
        // It fills and empties by turns.
        if (random() % 100 < (i / 500 % 2 == 0 ? 60u : 40u)) {
            ring.push_back(i);
            expected.push_back(i);
        } else if (!expected.empty()) {
            ring.pop_front();
            expected.pop_front();
        }
        REQUIRE(ring.size() == expected.size());
        REQUIRE(ring.empty() == expected.empty());
        if (expected.empty()) continue;
        REQUIRE(ring.front() == expected.front());
        REQUIRE(ring.back() == expected.back());
        const std::size_t at = random() % expected.size();
        REQUIRE(ring[at] == expected[at]);
    }
    ring.clear();
    CHECK(ring.empty());
}

TEST_CASE("a ring lets go of what was taken out") {
    Ring<std::shared_ptr<int>> ring;
    const auto item = std::make_shared<int>(1);
    for (int i = 0; i < 3; ++i)
        ring.push_back(item);
    CHECK(item.use_count() == 4);
    ring.pop_front();
    CHECK(item.use_count() == 3);
    ring.clear();
    CHECK(item.use_count() == 1);
}

} // namespace
} // namespace ffgpu
