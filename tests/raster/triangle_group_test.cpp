// Triangles set up in groups against set_up(), one by one, bit for bit.

#include "model/raster/triangle_group.h"
#include "tests/raster/raster_helpers.h"

#include <cmath>
#include <cstring>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

InterpolantLayout random_layout(Random& random) {
    InterpolantLayout layout;
    unsigned count = 0;
    const auto take = [&](unsigned floats) {
        count += floats;
        return static_cast<std::int8_t>(count - floats);
    };
    if (random.below(4) != 0) layout.color = take(4);
    if (random.below(2) != 0) layout.secondary = take(3);
    if (random.below(2) != 0) layout.fog = take(1);
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (random.below(3) != 0) continue;
        const auto components = static_cast<unsigned>(random.between(2, 4));
        layout.tex_components[unit] = static_cast<std::uint8_t>(components);
        layout.tex_coord[unit] = take(components);
    }
    layout.count = static_cast<std::uint8_t>(count);
    return layout;
}

// What groups have seen, so that the test tells of each kind.
struct Seen {
    unsigned alone = 0, empty = 0, nothing = 0, plain = 0, constant = 0, perspective = 0;
};

struct Triangles {
    SetupContext setup = context();
    std::array<WindowVertex, 3 * TriangleGroup::Size> vertices;
    std::array<Primitive, TriangleGroup::Size> primitives;

    explicit Triangles(Random& random) {
        setup.layout = random_layout(random);
        if (random.below(3) == 0) setup.clip = {20, 30, 100, 90};
        if (random.below(4) == 0) setup.depth_scale = 0xffff;
        const bool flat = random.below(2) != 0, affine = random.below(2) != 0;
        for (unsigned i = 0; i < TriangleGroup::Size; ++i) {
            WindowVertex* const v = vertices.data() + 3 * i;
            place(random, v);
            const float change = random.below(4) == 0 ? 2.0f : 0.01f; // Steep planes go alone.
            attributes(random, v[0]);
            for (unsigned j = 0; j < 3; ++j) {
                for (unsigned k = 0; j > 0 && k < MaxInterpolants; ++k)
                    v[j].attributes[k] = v[0].attributes[k] * (1 + change * random.unit());
                const int e = random.below(64) == 0 ? random.between(-60, 60) : 0;
                v[j].inverse_w = std::ldexp(0.3f + random.unit(), e);
            }
            if (affine) v[1].inverse_w = v[2].inverse_w = v[0].inverse_w;
            if (flat || random.below(3) == 0)
                for (unsigned j = 1; j < 3; ++j)
                    std::copy_n(v[0].attributes.begin(), 7, v[j].attributes.begin());
            primitives[i] = {
                .front_facing = random.below(2) != 0, .key = i, .vertices = {&v[0], &v[1], &v[2]}};
        }
    }

    // From below a pixel to the whole guard band, some without area, some thin.
    static void place(Random& random, WindowVertex* v) {
        const int size = 1 << random.between(5, random.below(8) == 0 ? 20 : 12);
        const int x = random.between(0, 128 * 256), y = random.between(0, 128 * 256);
        for (unsigned j = 0; j < 3; ++j) {
            v[j] = vertex(x + random.between(-size, size), y + random.between(-size, size));
            const int kind = random.below(32);
            v[j].depth = 0.5f + 0.02f * random.unit();
            if (kind < 4) v[j].depth = kind == 0 ? -0.5f : kind == 1 ? 2.0f : random.unit();
            if (kind == 4) v[j].depth = std::nanf("");
        }
        if (random.below(8) == 0)
            for (unsigned j = 0; j < 3; ++j) // Flat in depth.
                v[j].depth = 0.25f;
        if (random.below(8) == 0) { // A sliver, or no area at all.
            v[2].x = v[0].x + (v[1].x - v[0].x) / 2 + random.between(-1, 1);
            v[2].y = v[0].y + (v[1].y - v[0].y) / 2;
        }
    }

    static void attributes(Random& random, WindowVertex& v) {
        for (float& value : v.attributes) {
            value = random.unit() * 2 - 0.5f;
            if (random.below(16) == 0) value = std::ldexp(value, random.between(-60, 60));
            if (random.below(16) == 0) value = 0.25f * static_cast<float>(random.between(-4, 4));
        }
    }
};

// The members that set_up() fills, planes of constant colours left out.
void compare_records(const SetupRecord& a, const SetupRecord& b, const SetupContext& setup) {
    REQUIRE(a.box == b.box);
    REQUIRE(std::memcmp(a.edges.data(), b.edges.data(), 3 * sizeof(Edge)) == 0);
    REQUIRE(std::memcmp(a.edge_fractions.data(), b.edge_fractions.data(), 3) == 0);
    REQUIRE(a.edge_count == b.edge_count);
    REQUIRE(a.coverage == b.coverage);
    REQUIRE(a.stipple == b.stipple);
    REQUIRE(a.front_facing == b.front_facing);
    REQUIRE(a.covers_nothing == b.covers_nothing);
    REQUIRE(a.perspective == b.perspective);
    REQUIRE(a.constant_color == b.constant_color);
    REQUIRE(a.constant_secondary == b.constant_secondary);
    REQUIRE(a.plane_count == b.plane_count);
    REQUIRE(a.divided_units == b.divided_units);
    REQUIRE(a.key == b.key);
    REQUIRE(a.x_reference == b.x_reference);
    REQUIRE(a.y_reference == b.y_reference);
    REQUIRE(std::memcmp(&a.depth, &b.depth, sizeof a.depth) == 0);
    REQUIRE(a.depth_min == b.depth_min);
    REQUIRE(a.depth_max == b.depth_max);
    if (a.constant_color) REQUIRE(a.color == b.color);
    if (a.constant_secondary) REQUIRE(std::memcmp(a.secondary.data(), b.secondary.data(), 3) == 0);
    if (a.perspective) REQUIRE(a.inverse_w_floor == b.inverse_w_floor);
    const InterpolantLayout& layout = setup.layout;
    for (int i = 0; i < a.plane_count + int{a.perspective}; ++i) {
        if (a.constant_color && i >= layout.color && i < layout.color + 4) continue;
        if (a.constant_secondary && i >= layout.secondary && i < layout.secondary + 3) continue;
        REQUIRE(std::memcmp(a.planes() + i, b.planes() + i, sizeof(StoredPlane)) == 0);
    }
}

void compare_group(const Triangles& scene, unsigned count, TriangleGroup& group, Seen& seen) {
    set_up_triangles(scene.setup, std::span(scene.primitives).first(count), group);
    RecordBuffer one, lane;
    for (unsigned i = 0; i < count; ++i) {
        const Primitive& primitive = scene.primitives[i];
        if ((group.alone >> i & 1) != 0) {
            ++seen.alone;
            continue;
        }
        const bool covers = set_up(scene.setup, primitive, one.record());
        REQUIRE(covers == ((group.empty >> i & 1) == 0));
        if (!covers) {
            ++seen.empty;
            continue;
        }
        const bool nothing = (group.nothing >> i & 1) != 0;
        REQUIRE(one.record().covers_nothing == nothing);
        REQUIRE(one.record().box == group.box[i]);
        const auto& v = primitive.vertices;
        REQUIRE(group.double_area[i] ==
                std::fabs(static_cast<double>(
                    double_area({v[0]->x, v[0]->y}, {v[1]->x, v[1]->y}, {v[2]->x, v[2]->y}))));
        if (nothing) {
            ++seen.nothing;
            continue;
        }
        write_record(scene.setup, group, i, primitive, lane.record());
        compare_records(one.record(), lane.record(), scene.setup);
        ++seen.plain;
        seen.constant += one.record().constant_color;
        seen.perspective += one.record().perspective;
    }
}

} // namespace

TEST_CASE("triangles in groups are set up as one by one, with each instruction set") {
    for_each_target([] {
        Random random(71);
        Seen seen;
        const auto group = std::make_unique<TriangleGroup>();
        for (unsigned n = 0; n < 6000; ++n) {
            const Triangles scene(random);
            REQUIRE(goes_in_groups(scene.setup));
            compare_group(scene, static_cast<unsigned>(random.between(1, 8)), *group, seen);
        }
        CHECK(seen.plain > 5000);
        CHECK(seen.alone < seen.plain);
        for (const unsigned kind :
             {seen.alone, seen.empty, seen.nothing, seen.constant, seen.perspective})
            CHECK(kind > 100);
    });
}

TEST_CASE("triangles go in groups only where nothing but centres and planes is asked of them") {
    CHECK(goes_in_groups(context()));
    CHECK_FALSE(goes_in_groups(context({10, 10, 10, 20})));
    const auto with = [](auto&& change) {
        SetupContext setup = context();
        change(setup);
        return goes_in_groups(setup);
    };
    CHECK_FALSE(with([](SetupContext& setup) { setup.multisample = true; }));
    CHECK_FALSE(with([](SetupContext& setup) { setup.primitive.polygon_smooth = true; }));
    CHECK_FALSE(with([](SetupContext& setup) { setup.primitive.polygon_stipple = true; }));
    CHECK_FALSE(with([](SetupContext& setup) { setup.primitive.offset_fill = true; }));
    CHECK_FALSE(with([](SetupContext& setup) { setup.layout.count = MaxInterpolants; }));
}

TEST_CASE("the specification of groups leaves every triangle to set-up") {
    TriangleGroup group;
    set_up_triangles_scalar(context(), {}, group);
    CHECK(group.alone == 0xff);
}
