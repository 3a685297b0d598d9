// rtl/attribute_plane.sv against AttributePlane, by way of the parts that records keep.

#include "Vattribute_plane.h"
#include "model/raster/stored_plane.h"
#include "rtl/bundles/plane.h"
#include "tests/rtl/bench/random_offset.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct AttributePlaneUnit {
    static constexpr const char* Name = "attribute_plane";
    static constexpr std::string_view Latency = "AttributePlaneLatency";
    static constexpr std::uint64_t ShortItems = 1000000, LongItems = 10000000;

    using Dut = Vattribute_plane;
    using State = NoState;
    using Input = PlaneQuad;
    using Output = LaneValues;

    static void set_tag(PlaneQuad& quad, unsigned tag) { quad.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    // Steps of any size up to 44 bits and a sign.
    static std::int64_t random_step(Random& random) {
        const auto magnitude = static_cast<std::int64_t>(random.bits() >> (20 + random.below(44)));
        return random.one_in(2) ? -magnitude : magnitude;
    }
    static PlaneQuad random_input(Random& random, const State&) {
        PlaneQuad quad{.place = static_cast<std::uint16_t>(random.below(1024)),
                       .x = random_offset(random),
                       .y = random_offset(random),
                       .whole = static_cast<std::int32_t>(random.word()) >> random.below(32),
                       .fraction = random.below(1u << 14),
                       .dx = random_step(random),
                       .dy = random_step(random)};
        if (random.one_in(4)) { // The sum a hair from where it rounds to the next integer.
            const std::int64_t sum = quad.dx * quad.x + quad.dy * quad.y;
            quad.fraction =
                static_cast<std::uint32_t>(random.below(2) - 1 - sum) & ((1u << 14) - 1);
        }
        return quad;
    }

    static void declare(Bins& bins) {
        bins.declare("signs of x, y, dx, dy", 16);
        bins.declare("guard bits of the corner: 0, between, all ones", 3);
        bins.declare("bits of dx", 45);
    }
    static void cover(Bins& bins, const State&, const PlaneQuad& quad) {
        bins.hit("signs of x, y, dx, dy",
                 (quad.x < 0 ? 8u : 0u) + (quad.y < 0 ? 4u : 0u) + (quad.dx < 0 ? 2u : 0u) +
                     (quad.dy < 0 ? 1u : 0u));
        const auto guard =
            static_cast<unsigned>(quad.fraction + quad.dx * quad.x + quad.dy * quad.y) &
            ((1u << 14) - 1);
        bins.hit("guard bits of the corner: 0, between, all ones",
                 guard == 0                ? 0
                 : guard == (1u << 14) - 1 ? 2
                                           : 1);
        bins.hit("bits of dx",
                 static_cast<std::size_t>(
                     std::bit_width(static_cast<std::uint64_t>(quad.dx < 0 ? -quad.dx : quad.dx))));
    }

    static void expect(const State&, const PlaneQuad& quad, std::vector<LaneValues>& outputs) {
        const std::int64_t c = (std::int64_t{quad.whole} << AttributePlane::GuardBits) +
                               quad.fraction - AttributePlane::Half;
        const AttributePlane plane =
            StoredPlane(AttributePlane{.c = c, .dx = quad.dx, .dy = quad.dy}).plane();
        LaneValues lanes{.tag = quad.tag, .place = quad.place};
        const auto corner = static_cast<std::uint32_t>(plane.corner(quad.x, quad.y));
        for (unsigned lane = 0; lane < 4; ++lane)
            lanes.values[lane] = corner + static_cast<std::uint32_t>(plane.lane_offsets()[lane]);
        outputs.push_back(lanes);
    }
};
using Unit = AttributePlaneUnit;

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
