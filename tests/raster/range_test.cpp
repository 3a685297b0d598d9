// The range rule: from attributes that are 0 or within its powers of two, however extreme, nothing
// subnormal, infinite or NaN comes up between the planes and the level of detail. Set
// FFGPU_RANGE_PRIMITIVES for another number of primitives.

#include "model/arith/range.h"
#include "model/fragment/fog.h"
#include "model/raster/interpolator.h"
#include "model/texture/level_of_detail.h"
#include "tests/raster/raster_helpers.h"

#include <bit>
#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// Colour, fog, four coordinates of unit 0, three of unit 1, a cube map.
InterpolantLayout layout() {
    InterpolantLayout result;
    result.color = 0;
    result.fog = 4;
    result.tex_coord[0] = 5;
    result.tex_components[0] = 4;
    result.tex_coord[1] = 9;
    result.tex_components[1] = 3;
    result.count = 12;
    return result;
}

float extreme_attribute(Random& random) {
    if (random.below(8) == 0) return 0;
    const float mantissa = (1 + random.unit() * 0.999f) * (random.below(2) ? 1.0f : -1.0f);
    return in_range(std::ldexp(mantissa, random.between(-60, 59)));
}

WindowVertex extreme_vertex(Random& random, int size) {
    WindowVertex v = vertex(random.between(0, size), random.between(0, size));
    v.inverse_w = std::ldexp(1 + random.unit() * 0.999f, random.between(-60, 59));
    for (float& attribute : v.attributes)
        attribute = extreme_attribute(random);
    for (unsigned i = 0; i < 4; ++i)
        v.attributes[i] = random.unit();
    return v;
}

struct Checked {
    unsigned long long numbers = 0, special = 0;

    void add(float x) {
        ++numbers;
        special += !is_ordinary(x);
    }
    void add(const TexCoord& c) { add(c.s), add(c.t), add(c.r); }
};

// Level of detail, and the coordinates of every number of probes.
void check_quad(const std::array<TexCoord, 4>& lanes, Checked& checked) {
    TextureUnit unit;
    unit.dimensions = 3;
    unit.density = {4096, 4096, 512};
    unit.max_probes = 16;
    const QuadSampling quad = sample_quad(unit, lanes, true);
    checked.add(quad.major_step);
    CoordinateSteps steps;
    for (unsigned i = 0; i < 3; ++i) {
        const auto of = [i](const TexCoord& c) { return i == 0 ? c.s : i == 1 ? c.t : c.r; };
        steps.x[i] = of(lanes[1]) - of(lanes[0]);
        steps.y[i] = of(lanes[2]) - of(lanes[0]);
        checked.add(steps.x[i]);
        checked.add(steps.x[i] * unit.density[i]);
        checked.add(steps.y[i] * unit.density[i]);
    }
    const PixelFootprint footprint = pixel_footprint(unit, steps);
    checked.add(std::bit_cast<float>(footprint.x));
    checked.add(std::bit_cast<float>(footprint.y));
    for (const TexCoord& lane : lanes)
        for (const float position : {probe_position(1, 2), probe_position(1, 16)}) {
            checked.add(quad.major_step.s * position);
            checked.add(move_to_probe(lane.s, quad.major_step.s, position));
        }
}

void check_faces(const std::array<TexCoord, 4>& lanes, Checked& checked) {
    for (const TexCoord& of_face : lanes) {
        std::array<TexCoord, 4> projected;
        for (unsigned i = 0; i < 4; ++i) {
            projected[i] = project_to_face(cube_face(of_face), lanes[i]);
            checked.add(projected[i]);
        }
        check_quad(projected, checked);
    }
}

// A quad that the record touches: that of its first covered pixel.
bool first_quad(const SetupRecord& record, FragmentBatch& batch) {
    TileCoverage coverage;
    for (int y = 0; y < 256; y += 128)
        for (int x = 0; x < 256; x += 128) {
            cover_tile(edge_set(record), {x, y, x + 128, y + 128}, coverage);
            bool found = false;
            for_each_pixel(coverage, [&](int px, int py) {
                if (found) return;
                found = true;
                batch.tile_x = static_cast<std::uint16_t>(x);
                batch.tile_y = static_cast<std::uint16_t>(y);
                batch.x[0] = static_cast<std::uint16_t>(px & ~1);
                batch.y[0] = static_cast<std::uint16_t>(py & ~1);
            });
            if (found) return true;
        }
    return false;
}

unsigned primitive_count() {
    const char* const asked = std::getenv("FFGPU_RANGE_PRIMITIVES");
    return asked ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 20000;
}

std::array<TexCoord, 4> quad_of(const TexCoordPlanes& planes) {
    return {coordinates_of(planes, 0),
            coordinates_of(planes, 1),
            coordinates_of(planes, 2),
            coordinates_of(planes, 3)};
}

} // namespace

TEST_CASE("no subnormal, infinity or NaN comes up in the fragment path") {
    Random random(41);
    SetupContext setup = context();
    setup.layout = layout();
    RecordBuffer buffer;
    auto batch = std::make_unique<FragmentBatch>();
    auto planes = std::make_unique<PerspectivePlanes>();
    auto coords = std::make_unique<TexCoordPlanes>();
    batch->quad_count = 1;
    Checked checked;
    unsigned drawn = 0;
    for (unsigned n = 0; n < primitive_count(); ++n) {
        const int size = 256 << random.below(9);
        const WindowVertex a = extreme_vertex(random, size);
        const WindowVertex b = extreme_vertex(random, size), c = extreme_vertex(random, size);
        if (!buffer.triangle(setup, a, b, c) || !first_quad(buffer.record(), *batch)) continue;
        ++drawn;
        const BatchRun run{&buffer.record(), 0};
        interpolate_perspective_scalar({&run, 1}, *batch, *planes);
        interpolate_colors_scalar(setup.layout, {&run, 1}, *planes, *batch);
        for (unsigned lane = 0; lane < 4; ++lane) {
            checked.add(planes->w[lane]);
            const float fog = batch->fog_coordinate[lane];
            checked.add(fog);
            checked.add((fog * LargestFog) * (fog * LargestFog) * Log2E);
            checked.add((fog * LeastFog) * (fog * LeastFog) * Log2E);
        }
        for (const unsigned unit : {0u, 1u}) {
            interpolate_tex_coords_scalar(setup.layout, unit, {&run, 1}, *planes, *batch, *coords);
            for (const TexCoord& lane : quad_of(*coords))
                checked.add(lane);
            check_quad(quad_of(*coords), checked);
            interpolate_directions_scalar(setup.layout, unit, {&run, 1}, *planes, *batch, *coords);
            check_faces(quad_of(*coords), checked);
        }
    }
    INFO(checked.numbers << " numbers of " << drawn << " primitives");
    CHECK(checked.special == 0);
    CHECK(drawn > primitive_count() / 4);
}

TEST_CASE("the range rule keeps what lies within its powers of two, and nothing else") {
    CHECK(in_range(LeastValue) == LeastValue);
    CHECK(in_range(std::nextafter(LeastValue, 0.0f)) == 0);
    CHECK(in_range(-0x1.fffffep59f) == -0x1.fffffep59f);
    CHECK(in_range(LargestValue) == 0);
    CHECK(in_range(NAN) == 0);
    CHECK(in_range(1e-40f) == 0);
    CHECK(in_fog_range(-INFINITY) == -LargestFog);
    CHECK(in_fog_range(NAN) == 0);
    CHECK(in_fog_range(0x1p-31f) == 0);
    CHECK_FALSE(is_ordinary(1e-40f));
    CHECK_FALSE(is_ordinary(INFINITY));
    CHECK(is_ordinary(-0.0f));
}
