// The fragment pipe's texture unit against the model: texels of every format, samples of every
// unit, and the banks of registers that units take in turn.

#include "tests/rtl_pipe/close_draws.h"

#include <map>
#include <set>
#include <utility>

namespace ffgpu::tools {
namespace {

// Many blocks wide and high, a texel a pixel: none lies where another one does.
TEST_CASE("The pipe finds each texel of images of every format") {
    constexpr std::uint32_t Width = 64, Height = 32;
    PipeComparison comparison(Memories[0]);
    test::Scene scene(Width, Height);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    prepare(scene);
    scene.texture(1, {0}); // its sampler
    const auto corner = [](float x, float y) {
        return test::Vertex{x, y, 0, 1, 1, 1, 1, 1, 0.5f + x / 2, 0.5f + y / 2};
    };
    for (auto format = static_cast<unsigned>(Format::Rgba8);
         format <= static_cast<unsigned>(Format::Depth24Stencil8);
         ++format) {
        INFO(format_info(static_cast<Format>(format)).name);
        scene.clear(0);
        scene.registers.images[0].shape = {
            TextureKind::TwoD, static_cast<Format>(format), Width, Height, 1, 1, 0};
        scene.draw(PrimitiveType::TriangleFan,
                   {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
        INFO(comparison.summary());
        REQUIRE(comparison.equal());
        const std::vector<std::uint32_t> picture = scene.picture();
        CHECK(std::set(picture.begin(), picture.end()).size() > 8);
    }
    CHECK(comparison.fragments() ==
          std::map<std::string, std::uint64_t>{{"", 17 * Width * Height}});
}

// A triangle over all of the target, at whose corners coordinates are these times x and y, from a
// middle on.
std::vector<test::Vertex> whole(float s, float t, float middle = 0) {
    std::vector<test::Vertex> corners;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {3.0f, -1.0f}, {-1.0f, 3.0f}})
        corners.push_back({x, y, 0, 1, 1, 1, 1, 1, middle + s * x, middle + t * y});
    return corners;
}

void show_sample(Combiner& combiner, unsigned unit) {
    for (CombineHalf* half : {&combiner.rgb, &combiner.alpha}) {
        half->op = CombineOp::Replace;
        half->arguments[0].source =
            static_cast<CombineSource>(static_cast<unsigned>(CombineSource::Texture0) + unit);
    }
}

// Of a draw many samples are on their way, sixteen texels each, when the next one's second and
// third unit want the bank that those are under.
TEST_CASE("A bank of the texture unit is another unit's when its last sample has come") {
    for (const rtl::PipeOptions& options : Memories) {
        CloseDraws draws(options);
        for (int turn = 0; turn < 8; ++turn) {
            Registers& registers = draws.vary(1);
            registers.images[0].shape = {TextureKind::ThreeD, Format::Rgba8, 16, 16, 8, 3, 0};
            registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear = true;
            registers.samplers[0].mip_filter = MipFilter::Linear;
            draws.draw_as_set(whole(6, 5));
            draws.draw_textured(3);
        }
        const TargetDifference difference = draws.difference();
        INFO(target_text(difference));
        CHECK(difference.target.empty());
    }
}

// The same with a texel a sample, all of a line that has not come: sixty-four samples, of as many
// quads as may wait for theirs.
TEST_CASE("A bank of the texture unit waits for all samples that may be on their way") {
    for (const rtl::PipeOptions& options : {memory(250, 0, 4), memory(250, 30, 5)}) {
        CloseDraws draws(options);
        const auto draw_sixteen_quads = [&](unsigned units, float at) {
            Registers& registers = draws.vary(units);
            const Scissor all = std::exchange(registers.scissor, {8, 8, 8, 8});
            registers.depth.test_enable = registers.stencil.enable = false;
            registers.fragment.alpha_test = false;
            registers.blend.write_mask = 0xf;
            if (units == 1) {
                registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 64, 64, 1, 1, 0};
                registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear = false;
                registers.samplers[0].mip_filter = MipFilter::None;
            }
            draws.draw_as_set(whole(0, 0, at));
            registers.scissor = all;
        };
        for (int turn = 0; turn < 24; ++turn) {
            for (const unsigned units : {1u, 3u})
                draw_sixteen_quads(units, (static_cast<float>(turn) + 0.5f) / 24);
            // Without a quad: the next but one has its registers at once.
            for (int empty = 0; empty < 2; ++empty) {
                draws.vary(0);
                draws.draw_as_set({});
            }
        }
        const TargetDifference difference = draws.difference();
        INFO(target_text(difference));
        CHECK(difference.target.empty());
    }
}

// An image, a sampler and a combiner that all units may have.
void prepare_textured(test::Scene& scene) {
    prepare(scene);
    scene.texture(1, {0});
    scene.registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 1, 0};
}

struct TexturedPipe {
    PipeComparison comparison{Memories[0]};
    test::Scene scene{32, 24};

    TexturedPipe() {
        comparison.attach(scene.gpu, scene.gpu);
        scene.into = &comparison;
        prepare_textured(scene);
    }
};

// A draw's combiner names a unit that the draw does not sample: black, whatever the one before it,
// under the other registers, has sampled there.
TEST_CASE("The pipe has no sample of a unit that only the other draw samples") {
    const unsigned first = GENERATE(0u, 1u); // Each kind of draw is under either tag.
    TexturedPipe pipe;
    auto& [comparison, scene] = pipe;
    Registers& registers = scene.registers;
    registers.images[1] = registers.images[0];
    registers.samplers[1] = registers.samplers[0];
    registers.combiners[1] = registers.combiners[0];
    show_sample(registers.combiners[1], 1);
    test::RandomStates random(3);
    for (unsigned draw = first; draw < 6; ++draw) {
        registers.images[1].shape.kind = draw % 2 == 0 ? TextureKind::TwoD : TextureKind::None;
        scene.clear(0x40302010);
        scene.draw(PrimitiveType::Triangles, triangles(random, 4));
        INFO(told(comparison, draw));
        CHECK(comparison.equal());
    }
    CHECK(comparison.fragments().at("") > 500);
}

// Of eight units that are sampled each is shown once, alone: no bit of its samples may be lost.
TEST_CASE("The pipe shades with the sample of each unit at each lane") {
    TexturedPipe pipe;
    auto& [comparison, scene] = pipe;
    Registers& registers = scene.registers;
    registers.images.fill(registers.images[0]);
    registers.samplers.fill(registers.samplers[0]);
    registers.combiners.fill(registers.combiners[0]);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        registers.images[unit].address += 0x4000 * unit;
    test::RandomStates random(4);
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        show_sample(registers.combiners[TextureUnits - 1], unit);
        scene.clear(0);
        scene.draw(PrimitiveType::Triangles, triangles(random, 12));
        INFO(told(comparison, unit));
        CHECK(comparison.equal());
        CHECK(scene.colors() > 16);
    }
}

} // namespace
} // namespace ffgpu::tools
