// The fragment pipe in RTL against the model where its queues are full: what is behind them waits,
// and nothing of it is lost or taken twice.

#include "tests/gpu/scene.h"
#include "tools/rtl/pipe_comparison.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr rtl::PipeOptions Memory{
    .latency = 250, .stall_percent = 60, .seed = 7, .quiet_cycles = 1 << 14};

// Noise as the image of units 0 and up. Their coordinates are s, t and r.
void prepare(test::Scene& scene, unsigned units, const TextureShape& shape) {
    std::mt19937 random(5);
    std::vector<std::uint32_t> noise(0x4000);
    std::ranges::generate(noise, random);
    scene.texture(1, {0}); // its sampler and combiner
    scene.into->write_memory(test::TextureAt, std::as_bytes(std::span(noise)));
    Registers& registers = scene.registers;
    for (unsigned unit = 0; unit < units; ++unit) {
        registers.images[unit] = {.shape = shape, .address = test::TextureAt};
        registers.samplers[unit] = registers.samplers[0];
        Combiner& combiner = registers.combiners[unit];
        combiner = registers.combiners[0];
        const auto own =
            static_cast<CombineSource>(static_cast<unsigned>(CombineSource::Texture0) + unit);
        if (unit != 0) combiner.rgb.op = combiner.alpha.op = CombineOp::AddSigned;
        for (CombineHalf* half : {&combiner.rgb, &combiner.alpha}) {
            half->arguments[0].source = own;
            half->arguments[1].source = CombineSource::Previous;
        }
        const unsigned attribute = static_cast<unsigned>(Attribute::TexCoord0) + unit;
        registers.vertex_format.elements[attribute] = {3, 7};
    }
}

// Each quad of a place waits for the store of the one before it. Samples are there long before,
// also those of eight units, which take turns: they wait, and behind them the filter with all its
// texels.
TEST_CASE("Samples wait for quads that wait for their targets") {
    struct Kind {
        TextureShape shape;
        bool linear;
        unsigned units;
    };
    const Kind kind = GENERATE(Kind{{TextureKind::OneD, Format::Rgba8, 8, 1, 1, 1, 0}, true, 1},
                               Kind{{TextureKind::TwoD, Format::Rgba8, 8, 8, 1, 1, 0}, false, 1},
                               Kind{{TextureKind::TwoD, Format::Rgba8, 8, 8, 1, 1, 0}, true, 1},
                               Kind{{TextureKind::ThreeD, Format::Rgba8, 8, 8, 8, 1, 0}, true, 1},
                               Kind{{TextureKind::ThreeD, Format::Rgba8, 8, 8, 8, 1, 0}, true, 2},
                               Kind{{TextureKind::TwoD, Format::Rgba8, 8, 8, 1, 1, 0}, false, 8});
    PipeComparison comparison(Memory);
    test::Scene scene(16, 16);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    prepare(scene, kind.units, kind.shape);
    for (Sampler& sampler : scene.registers.samplers)
        sampler.magnify_linear = sampler.minify_linear = kind.linear;
    scene.registers.blend.enable = true;
    scene.registers.blend.rgb_source = BlendFactor::SourceAlpha;
    scene.registers.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
    scene.clear(0);
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < 80; ++i) {
        const float at = static_cast<float>(i) / 80;
        for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {-0.72f, -1.0f}, {-1.0f, -0.72f}})
            vertices.push_back({x, y, 0, 1, 1, 1, 1, at + x, at * y, at - x});
    }
    scene.draw(PrimitiveType::Triangles, vertices);
    INFO(fmt::format("{} units of kind {}, {}\n{}",
                     kind.units,
                     static_cast<unsigned>(kind.shape.kind),
                     kind.linear ? "linear" : "nearest",
                     comparison.summary()));
    CHECK(comparison.equal());
    CHECK(comparison.fragments().at("") == 80 * 3);
    CHECK(scene.colors() > 2);
}

// Squares with texels of their own, whose first one the memory is asked for, and between them
// such with the border's colour, which asks for nothing: two levels of sixteen quads.
TEST_CASE("Texels of the border wait behind one that memory has not given") {
    PipeComparison comparison(Memory);
    test::Scene scene(64, 64);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    prepare(scene, 1, {TextureKind::TwoD, Format::Rgba8, 64, 64, 1, 7, 0});
    Sampler& sampler = scene.registers.samplers[0];
    sampler.wrap.fill(Wrap::ClampToBorder);
    sampler.minify_linear = sampler.magnify_linear = GENERATE(false, true);
    sampler.mip_filter = MipFilter::Linear;
    sampler.bias = 128;
    sampler.border_color = 0xc0a0'6030;
    scene.clear(0);
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < 64; ++i) {
        const float x = -1 + static_cast<float>(i % 8) / 4, y = -1 + static_cast<float>(i / 8) / 4;
        const float s = i % 3 == 0 ? 0.5f + x / 2 : 3;
        const auto corner = [&](float dx, float dy) {
            return test::Vertex{x + dx, y + dy, 0, 1, 1, 1, 1, s + dx / 2, 0.5f + (y + dy) / 2, 0};
        };
        for (const test::Vertex& vertex : {corner(0, 0),
                                           corner(0.25f, 0),
                                           corner(0, 0.25f),
                                           corner(0.25f, 0),
                                           corner(0.25f, 0.25f),
                                           corner(0, 0.25f)})
            vertices.push_back(vertex);
    }
    scene.draw(PrimitiveType::Triangles, vertices);
    INFO(comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments() == std::map<std::string, std::uint64_t>{{"", 64 * 64}});
    CHECK(scene.colors() > 20);
}

} // namespace
} // namespace ffgpu::tools
