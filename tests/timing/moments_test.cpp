#include "model/timing/moments.h"

#include <map>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// Items come in bursts; those before `first` are of no use any more.
TEST_CASE("a link's moments are kept while they are of use, however many they are") {
    Moments moments(8);
    std::map<std::uint64_t, Cycle> expected;
    std::uint64_t first = 0, item = 0;
    for (const std::uint64_t under_way : {1u, 8u, 9u, 3u, 64u, 200u, 2u, 500u}) {
        for (std::uint64_t i = 0; i < 300; ++i, ++item) {
            if (item - first >= under_way) first = item - under_way + 1;
            moments.make_room(first, item);
            moments[item].at = 7 * item + 1;
            expected[item] = 7 * item + 1;
            for (std::uint64_t kept = first; kept <= item; ++kept)
                REQUIRE(moments[kept].at == expected[kept]);
        }
    }
}

} // namespace
} // namespace ffgpu::timing
