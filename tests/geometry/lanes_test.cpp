// The vector form of the vertex stages gives the bits of the scalar form, whatever the state.

#include "tests/geometry/scene.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

namespace ffgpu {
namespace {

template <class Values>
void randomize(Random& random, Values& values, float low, float high) {
    for (float& value : values)
        value = random.between(low, high);
}

void randomize_lighting(Random& random, Registers& registers) {
    Lighting& lighting = registers.lighting;
    lighting.enable = random.below(3) != 0;
    lighting.two_sided = random.below(2);
    lighting.local_viewer = random.below(2);
    lighting.separate_specular = random.below(2);
    lighting.color_material_front = static_cast<std::uint8_t>(random.below(16));
    lighting.color_material_back = static_cast<std::uint8_t>(random.below(16));
    for (Light& light : registers.lights) {
        light.enable = random.below(3) == 0;
        randomize(random, light.ambient, 0, 0.3f);
        randomize(random, light.diffuse, 0, 1);
        randomize(random, light.specular, 0, 1);
        randomize(random, light.position, -3, 3);
        if (random.below(2)) light.position[3] = 0;
        randomize(random, light.spot_direction, -0.6f, 0.6f);
        if (random.below(2)) light.spot_cutoff_cosine = random.between(0, 0.9f);
        light.spot_exponent = random.below(2) ? random.between(0, 10) : 0;
        if (random.below(2)) randomize(random, light.attenuation, 0, 1);
    }
    for (Material& material : registers.materials) {
        randomize(random, material.ambient, 0, 1);
        randomize(random, material.diffuse, 0, 1);
        if (random.below(4)) randomize(random, material.specular, 0, 1);
        randomize(random, material.emission, 0, 0.2f);
        material.shininess = random.below(4) ? random.between(0, 128) : 0;
    }
}

void randomize_tex_coords(Random& random, Registers& registers, InterpolantLayout& layout) {
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        TexCoordSetup& setup = registers.tex_coords[unit];
        for (TexGenMode& mode : setup.mode)
            mode = static_cast<TexGenMode>(random.below(6));
        for (Vec4& plane : setup.plane)
            randomize(random, plane, -2, 2);
        setup.matrix_enable = random.below(2);
        randomize(random, setup.matrix, -2, 2);
        if (random.below(3) == 0) continue;
        const unsigned components = 2 + random.below(3);
        layout.tex_coord[unit] = static_cast<std::int8_t>(layout.count);
        layout.tex_components[unit] = static_cast<std::uint8_t>(components);
        layout.count = static_cast<std::uint8_t>(layout.count + components);
    }
}

Registers random_registers(Random& random, InterpolantLayout& layout) {
    Registers registers;
    randomize(random, registers.transform.model_view, -2, 2);
    if (random.below(2))
        registers.transform.model_view[3] = registers.transform.model_view[7] =
            registers.transform.model_view[11] = 0;
    randomize(random, registers.transform.projection, -2, 2);
    randomize(random, registers.transform.normal_matrix, -2, 2);
    registers.transform.rescale = random.between(0.5f, 2);
    registers.transform.normal_mode = static_cast<NormalMode>(random.below(3));
    randomize_lighting(random, registers);
    layout = {};
    if (random.below(8)) layout.color = 0, layout.count = 4;
    if (random.below(2)) {
        layout.secondary = static_cast<std::int8_t>(layout.count);
        layout.count = static_cast<std::uint8_t>(layout.count + 3);
    }
    if (random.below(2)) layout.fog = static_cast<std::int8_t>(layout.count++);
    randomize_tex_coords(random, registers, layout);
    registers.fog.source = static_cast<FogCoordinateSource>(random.below(4));
    registers.clip_planes.enable = static_cast<std::uint8_t>(random.below(64));
    for (Vec4& plane : registers.clip_planes.planes)
        randomize(random, plane, -1, 1);
    registers.viewport = {.x = random.between(-100, 100),
                          .y = random.between(-100, 100),
                          .width = random.between(1, 4096),
                          .height = random.between(1, 4096)};
    randomize(random, registers.primitive.point_attenuation, 0, 1);
    registers.primitive.point_size = random.between(0, 60);
    return registers;
}

// Now and then one of the numbers that break things.
float awkward(Random& random) {
    constexpr std::array<float, 8> Values{0,
                                          -0.0f,
                                          1e30f,
                                          -1e30f,
                                          1e-40f,
                                          std::numeric_limits<float>::infinity(),
                                          -std::numeric_limits<float>::infinity(),
                                          std::numeric_limits<float>::quiet_NaN()};
    return random.below(50) != 0 ? random.between(-3, 3) : Values[random.below(8)];
}

struct Shaded {
    std::array<WindowVertex, BatchVertices> window{};
    std::array<Vec4, BatchVertices> clip, eye;
    std::array<ClipCode, BatchVertices> codes;

    VertexRecords records() { return {window.data(), clip.data(), eye.data(), codes.data()}; }
};

bool same_bits(float a, float b) {
    return std::bit_cast<int>(a) == std::bit_cast<int>(b);
}
bool same_value(float a, float b) {
    return same_bits(a, b) || (std::isnan(a) && std::isnan(b));
}

// Of vertices that no primitive may use, only what is defined is compared.
void require_same(const Shaded& a, const Shaded& b, unsigned vertex, unsigned interpolants) {
    REQUIRE(a.codes[vertex] == b.codes[vertex]);
    const WindowVertex &x = a.window[vertex], &y = b.window[vertex];
    REQUIRE(x.x == y.x);
    REQUIRE(x.y == y.y);
    REQUIRE(same_bits(x.depth, y.depth));
    REQUIRE(same_value(x.inverse_w, y.inverse_w));
    for (unsigned i = 0; i < 4; ++i)
        REQUIRE(same_value(a.clip[vertex][i], b.clip[vertex][i]));
    for (unsigned i = 0; i < interpolants; ++i) {
        INFO("interpolant " << i);
        REQUIRE(same_bits(x.attributes[i], y.attributes[i]));
    }
}

struct Comparison {
    VertexBatch scalar_batch, vector_batch;
    Shaded scalar, vector;

    void round(Random& random) {
        InterpolantLayout layout;
        const Registers registers = random_registers(random, layout);
        const VertexSetup setup = make_vertex_setup(registers, layout, {.point_size = true});
        scalar_batch.count = 1 + random.below(BatchVertices);
        for (Planes4& planes : scalar_batch.in)
            for (Plane& plane : planes)
                for (float& value : plane.lanes)
                    value = awkward(random);
        vector_batch.in = scalar_batch.in;
        vector_batch.count = scalar_batch.count;
        shade_vertices_scalar(setup, scalar_batch, scalar.records());
        shade_vertices_simd(setup, vector_batch, vector.records());
        for (unsigned vertex = 0; vertex < scalar_batch.count; ++vertex) {
            require_same(scalar, vector, vertex, layout.count);
            require_same_planes(setup, vertex);
        }
    }

    void require_same_planes(const VertexSetup& setup, unsigned vertex) const {
        const auto same = [&](const Plane& a, const Plane& b) {
            REQUIRE(same_bits(a.lanes[vertex], b.lanes[vertex]));
        };
        same(scalar_batch.point_size, vector_batch.point_size);
        if (!setup.needs_two_sides) return;
        for (unsigned c = 0; c < 4; ++c)
            same(scalar_batch.color[1][c], vector_batch.color[1][c]);
        for (unsigned c = 0; c < 3; ++c)
            same(scalar_batch.secondary[1][c], vector_batch.secondary[1][c]);
    }
};

TEST_CASE("vectors of each instruction set give the scalar lanes' bits in every state") {
    const std::int64_t supported = hwy::SupportedTargets();
    for (std::int64_t targets = supported; targets != 0; targets &= targets - 1) {
        const std::int64_t target = targets & -targets;
        INFO("target " << hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        Random random(7);
        auto comparison = std::make_unique<Comparison>();
        for (int round = 0; round < 200; ++round)
            comparison->round(random);
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST_CASE("vertices that leave nothing to draw are not lit, unless others share their primitives") {
    Registers registers;
    registers.viewport = {.width = 64, .height = 64};
    InterpolantLayout layout;
    layout.color = 0;
    layout.count = 4;
    const VertexSetup setup = make_vertex_setup(registers, layout, {});
    auto batch = std::make_unique<VertexBatch>();
    batch->count = 3;
    for (unsigned vertex = 0; vertex < 3; ++vertex) {
        batch->in[0][0].lanes[vertex] = -2; // left of the view
        batch->in[0][3].lanes[vertex] = 1;
        for (Plane& plane : batch->in[static_cast<unsigned>(Attribute::Color)])
            plane.lanes[vertex] = 0.5f;
    }
    const auto color_of_last = [&](ShadeVertices shade) {
        auto shaded = std::make_unique<Shaded>();
        shaded->window[2].attributes[0] = -1;
        shade(setup, *batch, shaded->records());
        CHECK((shaded->codes[0] & clip_code::Left) != 0);
        return shaded->window[2].attributes[0];
    };
    for (const ShadeVertices shade : {shade_vertices_scalar, shade_vertices_simd}) {
        batch->in[0][0].lanes[2] = -2;
        batch->whole_chunk = true;
        CHECK(color_of_last(shade) == -1);
        batch->whole_chunk = false;
        CHECK(color_of_last(shade) == 0.5f);
        batch->whole_chunk = true;
        batch->in[0][0].lanes[2] = 0;
        CHECK(color_of_last(shade) == 0.5f);
    }
}

TEST_CASE("interpolants are finite, whatever goes in") {
    Random random(8);
    auto batch = std::make_unique<VertexBatch>();
    auto shaded = std::make_unique<Shaded>();
    for (int round = 0; round < 200; ++round) {
        InterpolantLayout layout;
        const Registers registers = random_registers(random, layout);
        const VertexSetup setup = make_vertex_setup(registers, layout, {});
        batch->count = BatchVertices;
        for (Planes4& planes : batch->in)
            for (Plane& plane : planes)
                for (float& value : plane.lanes)
                    value = awkward(random);
        shade_vertices_simd(setup, *batch, shaded->records());
        for (const WindowVertex& vertex : shaded->window)
            for (unsigned i = 0; i < layout.count; ++i)
                REQUIRE(std::fabs(vertex.attributes[i]) < LargestMagnitude);
    }
}

} // namespace
} // namespace ffgpu
