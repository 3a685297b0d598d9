// Blocks that are passed over: each of their fragments fails the depth test, by the test's own
// words, and no picture, depth or count tells that they were.

#include "model/fragment/depth_target.h"
#include "model/gpu/hidden_blocks.h"
#include "model/memory/pixel_format.h"
#include "model/raster/interpolator.h"
#include "tests/gpu/depth_scene.h"

#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

constexpr std::uint16_t Width = 60, Height = 44; // no whole blocks
constexpr DeviceAddress TargetAt = 256;

// A depth target that holds whatever a test wants, and a plane over it.
struct BlockBench {
    std::mt19937 random;
    std::vector<std::byte> memory = std::vector<std::byte>(64 << 10);
    FragmentPipe pipe;
    SetupRecord record;

    BlockBench(std::uint32_t seed, Format format, Compare compare)
        : random(seed) {
        const std::uint32_t pixel_bytes = format_info(format).block_bytes;
        pipe.depth_target = {TargetAt, format, Width, Height, (Width + 3) * pixel_bytes};
        pipe.stencil_depth = compile_stencil_depth(
            {}, {.test_enable = true, .write_enable = true, .compare = compare}, format);
        pipe.early_depth = true;
    }

    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random()) % n; }
    std::uint32_t most() const {
        return pipe.depth_target.format == Format::Depth16 ? 0xffffu : 0xffffffu;
    }
    std::byte* pixel(unsigned x, unsigned y) {
        return pixel_address(pipe.depth_target, std::span(memory), x, y);
    }
    std::uint32_t stored(unsigned x, unsigned y) {
        return load_stencil_depth(pipe.depth_target.format, pixel(x, y)).depth;
    }
    void store(unsigned x, unsigned y, std::uint32_t depth) {
        store_stencil_depth(pipe.depth_target.format,
                            {.depth = depth, .stencil = static_cast<std::uint8_t>(random())},
                            pixel(x, y));
    }

    // Depths about `level`, with steps of up to `steepest` a pixel.
    void plane(std::uint32_t level, std::uint32_t spread, std::int64_t steepest) {
        const auto step = [&] {
            return static_cast<std::int64_t>(random()) % (2 * steepest + 1) - steepest;
        };
        record.x_reference = static_cast<int>(below(Width));
        record.y_reference = static_cast<int>(below(Height));
        record.depth = {std::int64_t{level} << DepthPlane::FractionBits, step(), step()};
        record.depth_min = level - std::min(level, below(spread));
        record.depth_max = std::min(level + below(spread), most());
    }

    // Of the pixels in the block that are in its mask.
    bool any_passes(const BlockCoverage& block) {
        FragmentBatch batch{};
        batch.quad_count = 16;
        for (unsigned q = 0; q < 16; ++q) {
            batch.x[q] = static_cast<std::uint16_t>(block.x + q % 4 * 2);
            batch.y[q] = static_cast<std::uint16_t>(block.y + q / 4 * 2);
        }
        const BatchRun run{&record, 0};
        interpolate_depth_scalar({&run, 1}, batch);
        for (unsigned lane = 0; lane < 64; ++lane) {
            if ((block.mask >> lane & 1) == 0) continue;
            const unsigned x = batch.x[lane / 4] + lane % 2, y = batch.y[lane / 4] + lane / 2 % 2;
            const StencilDepthPixel held{stored(x, y), 0};
            if (test_stencil_depth(pipe.stencil_depth, true, batch.depth[lane], held).passes_depth)
                return true;
        }
        return false;
    }

    // Whole but for what lies beyond the target, or with holes.
    BlockCoverage block(bool whole) {
        const auto x = static_cast<std::uint16_t>(below(Width / 8 + 1) * 8);
        const auto y = static_cast<std::uint16_t>(below(Height / 8 + 1) * 8);
        const BlockMask inside = rectangle_mask({0, 0, Width, Height}, x, y);
        const BlockMask some = std::uint64_t{random()} << 32 | random();
        return {x, y, whole ? inside : some & inside};
    }
};

} // namespace

TEST_CASE("Of a block that is passed over no fragment passes the depth test") {
    unsigned hidden = 0, visible = 0;
    for (const Format format : {Format::Depth24Stencil8, Format::Depth16})
        for (const Compare compare : {Compare::Less, Compare::Lequal})
            for (std::uint32_t seed = 0; seed < 60; ++seed) {
                BlockBench bench(seed, format, compare);
                const std::uint32_t level = bench.most() / 2, spread = 1 + bench.below(40);
                for (unsigned y = 0; y < Height; ++y)
                    for (unsigned x = 0; x < Width; ++x)
                        bench.store(x, y, level + bench.below(spread));
                HiddenBlocks blocks(bench.memory);
                blocks.begin_tile({0, 0, 64, 64});
                blocks.begin_draws(bench.pipe);
                REQUIRE(blocks.tells());
                for (unsigned i = 0; i < 400; ++i) {
                    bench.plane(level + bench.below(2 * spread),
                                spread,
                                seed % 6 == 0 ? std::int64_t{1} << 61 : std::int64_t{spread} << 21);
                    const BlockCoverage block = bench.block(i % 3 != 0);
                    if (blocks.hides(bench.record, block)) {
                        ++hidden;
                        REQUIRE_FALSE(bench.any_passes(block));
                    } else {
                        ++visible;
                    }
                    // What is drawn comes nearer, and nobody tells.
                    const unsigned x = bench.below(Width), y = bench.below(Height);
                    bench.store(x, y, bench.stored(x, y) - 1);
                }
            }
    CHECK(hidden > 10000);
    CHECK(visible > 10000);
}

TEST_CASE("A block is hidden from the depth on that Less and Lequal refuse at its farthest pixel") {
    for (const Compare compare : {Compare::Less, Compare::Lequal}) {
        BlockBench bench(1, Format::Depth24Stencil8, compare);
        for (unsigned y = 0; y < 8; ++y)
            for (unsigned x = 0; x < 8; ++x)
                bench.store(x, y, x == 5 && y == 6 ? 1000u : 10u);
        const auto hides = [&](std::uint32_t depth) {
            HiddenBlocks blocks(bench.memory);
            blocks.begin_tile({0, 0, 64, 64});
            blocks.begin_draws(bench.pipe);
            bench.record.depth = {std::int64_t{depth} << DepthPlane::FractionBits, 0, 0};
            bench.record.depth_min = bench.record.depth_max = depth;
            blocks.hides(bench.record, {0, 0, FullBlock}); // Nothing is looked at for the first.
            return blocks.hides(bench.record, {0, 0, FullBlock});
        };
        const std::uint32_t first = compare == Compare::Less ? 1000 : 1001;
        CHECK(hides(first));
        CHECK_FALSE(hides(first - 1));
    }
}

TEST_CASE("Nothing is told of draws that are tested late, otherwise, or for each sample") {
    const auto tells = [](auto&& change) {
        BlockBench bench(1, Format::Depth24Stencil8, Compare::Less);
        change(bench.pipe);
        HiddenBlocks blocks(bench.memory);
        blocks.begin_tile({0, 0, 64, 64});
        blocks.begin_draws(bench.pipe);
        return blocks.tells();
    };
    CHECK(tells([](FragmentPipe&) {}));
    CHECK_FALSE(tells([](FragmentPipe& pipe) { pipe.early_depth = false; }));
    CHECK_FALSE(tells([](FragmentPipe& pipe) { pipe.samples = MaxSamples; }));
    CHECK_FALSE(tells([](FragmentPipe& pipe) {
        pipe.color_targets[0].surface = pipe.depth_target;
        pipe.color_targets[0].surface.address += 64;
    }));
    for (const Compare compare : {Compare::Never,
                                  Compare::Equal,
                                  Compare::Greater,
                                  Compare::Notequal,
                                  Compare::Gequal,
                                  Compare::Always})
        CHECK_FALSE(tells([&](FragmentPipe& pipe) { pipe.stencil_depth.depth.compare = compare; }));
}

TEST_CASE("Bounds are forgotten where depths may have become farther, and only there") {
    // Whether a block is hidden still, by a bound of before, behind draws of a changed pipe.
    const auto still_hidden = [](auto&& change) {
        BlockBench bench(1, Format::Depth24Stencil8, Compare::Less);
        for (unsigned y = 0; y < 8; ++y)
            for (unsigned x = 0; x < 8; ++x)
                bench.store(x, y, 10);
        bench.record.depth = {std::int64_t{500} << DepthPlane::FractionBits, 0, 0};
        bench.record.depth_min = bench.record.depth_max = 500;
        HiddenBlocks blocks(bench.memory);
        blocks.begin_tile({0, 0, 64, 64});
        blocks.begin_draws(bench.pipe);
        blocks.hides(bench.record, {0, 0, FullBlock});
        REQUIRE(blocks.hides(bench.record, {0, 0, FullBlock}));
        FragmentPipe between = bench.pipe;
        change(blocks, between);
        blocks.begin_draws(between);
        blocks.begin_draws(bench.pipe);
        return blocks.hides(bench.record, {0, 0, FullBlock >> 1}); // Does not look anew.
    };
    const auto control = [](FragmentPipe& pipe) -> DepthControl& {
        return pipe.stencil_depth.depth;
    };
    CHECK(still_hidden([](HiddenBlocks&, FragmentPipe&) {}));
    for (const Compare compare : {Compare::Never, Compare::Equal, Compare::Lequal})
        CHECK(still_hidden(
            [&](HiddenBlocks&, FragmentPipe& pipe) { control(pipe).compare = compare; }));
    for (const Compare compare :
         {Compare::Greater, Compare::Notequal, Compare::Gequal, Compare::Always}) {
        CHECK_FALSE(still_hidden(
            [&](HiddenBlocks&, FragmentPipe& pipe) { control(pipe).compare = compare; }));
        CHECK(still_hidden([&](HiddenBlocks&, FragmentPipe& pipe) {
            control(pipe) = {.test_enable = true, .write_enable = false, .compare = compare};
        }));
    }
    CHECK_FALSE(
        still_hidden([](HiddenBlocks&, FragmentPipe& pipe) { pipe.depth_target.address += 4096; }));
    CHECK_FALSE(still_hidden([](HiddenBlocks&, FragmentPipe& pipe) { pipe.samples = MaxSamples; }));
    CHECK_FALSE(still_hidden([](HiddenBlocks&, FragmentPipe& pipe) {
        pipe.color_targets[0].surface = pipe.depth_target;
    }));
    CHECK_FALSE(still_hidden([](HiddenBlocks& blocks, FragmentPipe&) { blocks.forget(); }));
    CHECK_FALSE(still_hidden([](HiddenBlocks& blocks, FragmentPipe&) {
        blocks.begin_tile({0, 0, 64, 64});
    }));
}

namespace {

// Large triangles, mostly from the front to the back, and what makes depths farther in between.
void draw_many_layers(Scene& scene, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random()) % n; };
    const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
    DepthControl& depth = scene.registers.depth;
    depth.test_enable = depth.write_enable = true;
    scene.clear(0);
    for (int layer = 0; layer < 80; ++layer) {
        depth.compare = below(8) == 0   ? static_cast<Compare>(below(8))
                        : below(2) == 0 ? Compare::Less
                                        : Compare::Lequal;
        depth.write_enable = below(4) != 0;
        scene.registers.fragment.alpha_test = below(6) == 0;
        scene.registers.stencil.enable = below(10) == 0;
        if (below(12) == 0) {
            ClearCommand clear{.depth = true, .depth_value = below(0x1000000)};
            scene.registers.scissor = {40, 30, 70, 50};
            scene.command(clear);
            scene.registers.scissor = {0, 0, 200, 150};
        }
        std::vector<Vertex> vertices;
        const float z = -0.9f + 0.02f * static_cast<float>(layer);
        for (int i = 0; i < 6; ++i)
            vertices.push_back(
                {1.5f * unit(), 1.5f * unit(), z + 0.03f * unit(), 1, 1, 1, 1, 1, 0, 0});
        scene.draw(PrimitiveType::Triangles, vertices);
    }
}

} // namespace

TEST_CASE("Pictures, depths and counts are the same where blocks are passed over") {
    std::uint64_t hidden = 0;
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const auto draw = [&](const FunctionalGpu::Config& config) {
            Scene layers(200, 150, config);
            draw_many_layers(layers, seed);
            DepthScene mixed(
                seed, {.depth = seed % 4 == 3 ? Format::Depth16 : Format::Depth24Stencil8}, config);
            mixed.frame(40);
            std::vector<std::vector<std::uint32_t>> pictures;
            std::vector<std::map<std::string, std::uint64_t>> counts;
            for (Scene* const scene : {&layers, &mixed.scene}) {
                scene->gpu.finish();
                pictures.push_back(scene->picture());
                pictures.push_back(scene->depth_buffer());
                counts.push_back(counters(scene->gpu));
                for (const Counter& counter : scene->gpu.host_statistics().counters())
                    if (counter.name() == "hidden_blocks") hidden += counter.value();
            }
            return std::pair(pictures, counts);
        };
        INFO("seed " << seed);
        const std::uint64_t before = hidden;
        const auto reference = draw({.stages = &ReferenceStages});
        CHECK(hidden == before);
        CHECK((draw({}) == reference));
        CHECK((draw({.threads = 2, .tile_size = 128}) == reference));
    }
    CHECK(hidden > 10000);
}
