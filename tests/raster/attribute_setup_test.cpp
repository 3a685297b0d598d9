// Block floating point set-up: quotients against wide division, the fast form against the
// specification, and that every lane which a primitive can touch fits.

#include "model/raster/attribute_setup.h"
#include "model/raster/exact_quotient.h"
#include "model/raster/plane_setup.h"
#include "tests/raster/raster_helpers.h"

#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

__extension__ using Wide = __int128;

std::int64_t wide_quotient(std::int64_t numerator, std::int64_t divisor) {
    const Wide doubled = (Wide{numerator} << (ExactQuotient::Shift + 1)) + divisor;
    Wide quotient = doubled / (2 * Wide{divisor});
    if (quotient * 2 * divisor > doubled) --quotient; // floor
    return static_cast<std::int64_t>(quotient);
}

ExactQuotient quotient_by(std::int64_t divisor) {
    const auto exact = static_cast<double>(divisor);
    return {exact, 256 / exact};
}

std::int64_t random_bits(Random& random, int bits) {
    std::int64_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = value << 16 | random.below(1 << 16);
    return value & ((std::int64_t{1} << bits) - 1);
}

AttributeFrame random_frame(Random& random) {
    WindowVertex v[3];
    const int size = 1 << random.between(1, 21);
    for (WindowVertex& each : v)
        each = vertex(random.between(-size, size), random.between(-size, size));
    const PlaneGeometry geometry = random.below(4) == 0
                                       ? line_geometry(v[0], v[1], 1.0f + 64 * random.unit())
                                       : triangle_geometry({&v[0], &v[1], &v[2]});
    return geometry.attributes;
}

double random_value(Random& random) {
    if (random.below(8) == 0) return 0;
    return std::ldexp(static_cast<double>(random.unit()) * 2 - 1,
                      random.below(3) ? random.between(-2, 4) : random.between(-100, 61));
}

std::array<double, 3> random_values(Random& random) {
    const double one = random_value(random);
    switch (random.below(4)) {
    case 0:
        return {one, one, one};
    case 1: // Steps that are short binary fractions: ties.
        return {one, one + 0.25, one + 0.5};
    default:
        return {one, random_value(random), random_value(random)};
    }
}

InterpolantLayout random_layout(Random& random) {
    InterpolantLayout layout;
    layout.count = static_cast<std::uint8_t>(random.between(1, MaxInterpolants));
    if (layout.count >= 4 && random.below(2)) layout.color = 0;
    if (layout.count >= 7 && random.below(2)) layout.secondary = 4;
    return layout;
}

std::array<WindowVertex, 3> random_attributes(Random& random) {
    std::array<WindowVertex, 3> v;
    for (unsigned i = 0; i < MaxInterpolants; ++i) {
        const std::array<double, 3> at = random_values(random);
        for (unsigned j = 0; j < 3; ++j)
            v[j].attributes[i] = static_cast<float>(at[j]);
    }
    return v;
}

bool same_plane(const StoredPlane& a, const StoredPlane& b) {
    return std::memcmp(&a, &b, sizeof(StoredPlane)) == 0;
}

void compare_forms(unsigned seed, unsigned frames) {
    Random random(seed);
    unsigned raised = 0;
    for (unsigned n = 0; n < frames; ++n) {
        const AttributeFrame frame = random_frame(random);
        const std::array<WindowVertex, 3> v = random_attributes(random);
        const InterpolantLayout layout = random_layout(random);
        AttributeValues values{
            .of = {v[0].attributes.data(), v[1].attributes.data(), v[2].attributes.data()},
            .layout = layout,
            .perspective = random.below(2) == 0};
        if (values.perspective)
            values.k = {1 + static_cast<double>(random.unit()),
                        static_cast<double>(random.unit()),
                        std::ldexp(1, -random.below(40))};
        std::array<StoredPlane, PlaneRoom> scalar, vector;
        const int exponent = set_up_attributes_scalar(values, frame, scalar.data());
        REQUIRE(set_up_attributes(values, frame, vector.data()) == exponent);
        raised += values.perspective && exponent > 1;
        for (unsigned i = 0; i < values.count(); ++i)
            REQUIRE(same_plane(scalar[i], vector[i]));
    }
    CHECK(raised > 10);
}

} // namespace

TEST_CASE("quotients are those of 128-bit division, halves up") {
    Random random(21);
    for (int i = 0; i < 2000000; ++i) {
        const std::int64_t divisor = 1 + random_bits(random, random.between(1, 45));
        // A quotient below 2^46, as gradients are.
        const int bits = std::min(53, 46 - 22 + static_cast<int>(std::log2(divisor)));
        std::int64_t numerator = random_bits(random, random.between(1, bits));
        if (random.below(3) == 0) numerator &= -(1 << random.below(20)); // Ties.
        if (random.below(2) == 0) numerator = -numerator;
        REQUIRE(quotient_by(divisor)(numerator) == wide_quotient(numerator, divisor));
    }
    for (const std::int64_t divisor : {std::int64_t{1} << 23, (std::int64_t{1} << 23) * 3})
        for (std::int64_t numerator = -50; numerator <= 50; ++numerator)
            CHECK(quotient_by(divisor)(numerator) == wide_quotient(numerator, divisor));
}

TEST_CASE("the fast form of attribute set-up gives the specification's planes everywhere") {
    const std::int64_t supported = hwy::SupportedTargets();
    for (const std::int64_t target :
         {std::int64_t{HWY_SSE4}, std::int64_t{HWY_AVX2}, std::int64_t{HWY_AVX3}}) {
        if ((supported & target) == 0) continue;
        INFO("target " << hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        compare_forms(22, 4000);
    }
    hwy::SetSupportedTargetsForTest(0);
    compare_forms(23, 4000);
}

// In exact 128-bit arithmetic over triangles down to one unit of area: a lane up to two pixels
// beside any vertex stays within 32 bits, so no evaluation wraps.
TEST_CASE("every lane that a triangle can touch fits 32 bits") {
    Random random(24);
    unsigned slivers = 0;
    for (int i = 0; i < 200000; ++i) {
        WindowVertex v[3];
        const int size = 1 << random.between(3, 21);
        for (WindowVertex& each : v)
            each = vertex(random.between(-size, size), random.between(-size, size));
        if (i % 2) { // Third vertex next to the edge.
            v[2].x = v[0].x + (v[1].x - v[0].x) / 3 + random.between(-1, 1);
            v[2].y = v[0].y + (v[1].y - v[0].y) / 3 + random.between(-1, 1);
        }
        if (double_area({v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}) == 0) continue;
        const PlaneGeometry geometry = triangle_geometry({&v[0], &v[1], &v[2]});
        slivers += geometry.attributes.basis.x2 == 0 && geometry.attributes.basis.y2 == 0;
        const WindowVertex& first = *geometry.vertices[0];
        const BlockPlane plane = set_up_block_plane(random_values(random), geometry.attributes);
        REQUIRE(plane.exponent <= 61 + 13);
        for (const WindowVertex& at : v)
            for (const int dx : {-2, 2})
                for (const int dy : {-2, 2}) {
                    const int x = (at.x >> 8) - (first.x >> 8) + dx;
                    const int y = (at.y >> 8) - (first.y >> 8) + dy;
                    // Beside the longest edge a sliver's third vertex is not what values are from.
                    const Wide lane =
                        (Wide{plane.c} + Wide{plane.dx} * x + Wide{plane.dy} * y) >> 14;
                    REQUIRE(lane < (Wide{1} << 31) + (Wide{1} << 29));
                    REQUIRE(lane >= -(Wide{1} << 31) - (Wide{1} << 29));
                }
    }
    CHECK(slivers > 1000);
}

TEST_CASE("a stored plane is the plane itself") {
    Random random(25);
    for (int i = 0; i < 100000; ++i) {
        const auto within = [&](int bits) {
            return random_bits(random, random.between(1, bits)) * (random.below(2) ? 1 : -1);
        };
        const AttributePlane plane{
            within(44), within(43), within(43), std::ldexp(1.0f, random.between(-59, 78))};
        const StoredPlane stored(plane);
        REQUIRE(stored.plane().c == plane.c);
        REQUIRE(stored.plane().dx == plane.dx);
        REQUIRE(stored.plane().dy == plane.dy);
        REQUIRE(stored.plane().scale == plane.scale);
        REQUIRE(stored.right == plane.lane_offsets()[1]);
        REQUIRE(stored.up == plane.lane_offsets()[2]);
        REQUIRE(stored.diagonal == plane.lane_offsets()[3]);
    }
}
