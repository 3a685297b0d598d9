// The fragment pipe in RTL against the model where the primitives of one draw differ in what it
// makes of them: divisors and values that one has and the next one has not.

#include "tests/gpu/scene.h"
#include "tools/rtl/pipe_comparison.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

// As slow as the targets are, all queues before them are full.
constexpr rtl::PipeOptions Memory{
    .latency = 90, .stall_percent = 30, .seed = 5, .quiet_cycles = 1 << 14};

// Those that have 1 for it make no divisor, though their draw carries q.
TEST_CASE("Some primitives of a draw divide by q, and some do not") {
    PipeComparison comparison(Memory);
    test::Scene scene(16, 16);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.texture(4, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    scene.registers.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0)] = {4, 6};
    scene.clear(0xffffffff);
    const float last_w = GENERATE(1.0f, 1.5f); // without perspective, and with it
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < 12; ++i) {
        const float at = static_cast<float>(i) / 12 - 1, q = i % 3 == 1 ? 1.0f : 0.25f;
        for (const auto& [x, y, w] : {std::array{at, at, 1.0f},
                                      std::array{at + 1, at, 1.0f},
                                      std::array{at, at + 1, last_w}})
            vertices.push_back(
                {x * w, y * w, 0, w, 0, 0, x + 1, y + 1, 0, q == 1 ? q : q * (2 + x - y)});
    }
    scene.draw(PrimitiveType::Triangles, vertices);
    INFO(comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments().at("") > 12 * 16);
    CHECK(scene.colors() > 10);
}

// A quad without values and one with some wait in one queue, the values in another.
TEST_CASE("Some primitives of a draw have one colour, and some have many") {
    PipeComparison comparison(Memory);
    test::Scene scene(32, 32);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.registers.blend.enable = true;
    scene.registers.blend.rgb_source = BlendFactor::SourceAlpha;
    scene.registers.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
    scene.clear(0xffffffff);
    const float last_w = GENERATE(1.0f, 1.5f);
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < 12; ++i) {
        const float side = i % 4 < 2 ? 1.0f : -1.0f, shade = static_cast<float>(i) / 12;
        for (const auto& [x, y, w] : {std::array{-side, -side, 1.0f},
                                      std::array{side, -side, 1.0f},
                                      std::array{-side, side, last_w}}) {
            const float varies = i % 2 == 0 ? 0.0f : 0.5f;
            vertices.push_back({x * w,
                                y * w,
                                0,
                                w,
                                shade,
                                0.5f + varies * x,
                                0.5f - varies * y,
                                0.7f + varies * x / 2,
                                0,
                                0});
        }
    }
    scene.draw(PrimitiveType::Triangles, vertices);
    INFO(comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments().at("") > 12 * 400);
    CHECK(scene.colors() > 250);
}

} // namespace
} // namespace ffgpu::tools
