// What the options of `ffgpu cache` mean together.

#include "model/base/input_error.h"
#include "tools/cache/cache_arguments.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {

TEST_CASE("A curve that is asked for twice is told once") {
    CacheArguments arguments;
    arguments.clients = {"texel", "depth", "texel"};
    arguments.layouts = {"linear", "blocked", "linear"};
    arguments.orders = {"tiled:8", "scanline", "tiled:16", "tiled:8"};
    arguments.line_bytes = {64, 32, 64, 64};
    const CacheStudyOptions options = resolve(arguments);
    CHECK(options.clients == std::vector{work::LookupClient::Texel, work::LookupClient::Depth});
    CHECK(options.layouts == std::vector{work::Layout::Linear, work::Layout::Blocked});
    REQUIRE(options.orders.size() == 3);
    CHECK(options.orders[2] == RasterChoice{work::Traversal::Tiled, 16});
    CHECK(options.line_bytes == std::vector<std::uint32_t>{64, 32});
}

TEST_CASE("Without lines those that the first level allows are looked at") {
    const auto lines = [](const std::string& first_level) {
        CacheArguments arguments;
        arguments.first_level = first_level;
        return resolve(arguments).line_bytes;
    };
    CHECK(lines("") == std::vector<std::uint32_t>{32, 64, 128});
    CHECK(lines("64x4x64") == std::vector<std::uint32_t>{64, 128});
    CHECK(lines("64x4x256") == std::vector<std::uint32_t>{256});
}

TEST_CASE("An order without tiles takes no width") {
    for (const std::string order : {"scanline:16", "column:8"}) {
        CacheArguments arguments;
        arguments.orders = {order};
        CHECK_THROWS_AS(resolve(arguments), InputError);
    }
}

} // namespace ffgpu::tools
