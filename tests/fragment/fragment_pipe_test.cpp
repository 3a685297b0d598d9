#include "model/fragment/fragment_pipe.h"
#include "tests/fragment/one_by_one.h"
#include "tests/fragment/random_fragments.h"

#include <catch2/catch.hpp>
#include <hwy/targets.h>

using namespace ffgpu;
using ffgpu::test::Draws;
using ffgpu::test::Scene;

namespace {

bool same_lanes(const ColorPlanes& a, const ColorPlanes& b, unsigned lanes) {
    const auto same = [&](const auto& x, const auto& y) {
        return std::equal(x.begin(), x.begin() + lanes, y.begin());
    };
    return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b) && same(a.a, b.a);
}

// One side runs a scene, its own memory and batch.
struct Run {
    Scene scene;
    FragmentBatch batch;
    FragmentFates fates;
};

bool is_touched(const Surface& surface,
                const FragmentMask& live,
                const FragmentBatch& batch,
                std::size_t byte) {
    if (surface.format == Format::None || byte < surface.address) return false;
    if (byte >= surface.address + surface.bytes()) return false;
    const std::size_t bytes = format_info(surface.format).block_bytes;
    const std::size_t y = (byte - surface.address) / surface.stride;
    const std::size_t x = (byte - surface.address) % surface.stride / bytes;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        if (live.test(lane) && batch.x[lane / 4] + (lane & 1u) == x &&
            batch.y[lane / 4] + (lane >> 1 & 1u) == y)
            return true;
    return false;
}

} // namespace

namespace {

// Runs `test` with the vectors of each instruction set that this processor has.
template <class Test>
void with_each_target(Test&& test) {
#if defined(__x86_64__)
    hwy::SetSupportedTargetsForTest(HWY_SSE4);
    test();
    hwy::SetSupportedTargetsForTest(0);
#endif
    test();
}

// What became of the fragments, and what the targets hold.
void require_same_end(const Run& one, const Run& other) {
    REQUIRE(one.fates.after_coverage == other.fates.after_coverage);
    REQUIRE(one.fates.after_alpha == other.fates.after_alpha);
    REQUIRE(one.fates.after_stencil == other.fates.after_stencil);
    REQUIRE(one.fates.after_depth == other.fates.after_depth);
    REQUIRE(one.batch.live == other.batch.live);
    REQUIRE((one.scene.memory == other.scene.memory));
}

void require_equal_forms(const FragmentStages& stages) {
    auto batched = std::make_unique<Run>();
    auto single = std::make_unique<Run>();
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Draws draws(seed);
        batched->scene = {};
        test::randomize(draws, batched->scene);
        test::randomize(draws, batched->scene, batched->batch);
        single->scene = batched->scene;
        single->batch = batched->batch;

        const FragmentPipe batched_pipe = batched->scene.compile(stages);
        early_depth_test(batched_pipe, batched->batch);
        const FragmentPipe single_pipe = single->scene.compile();
        test::early_depth_test_one_by_one(single_pipe, single->batch);
        REQUIRE(batched->batch.live == single->batch.live);
        REQUIRE(batched->batch.samples == single->batch.samples);

        shade(batched_pipe, batched->batch);
        test::shade_one_by_one(single_pipe, single->batch);
        REQUIRE(same_lanes(batched->batch.color, single->batch.color, single->batch.lanes()));

        write(batched_pipe, batched->batch, batched->fates);
        test::write_one_by_one(single_pipe, single->batch, single->fates);
        require_same_end(*batched, *single);
        REQUIRE(batched->batch.samples == single->batch.samples);
    }
}

} // namespace

TEST_CASE("The batch stages yield the bits of single fragments for random states and batches") {
    with_each_target([] { require_equal_forms(FastFragmentStages); });
}

TEST_CASE("The stages' scalar forms yield the bits of single fragments") {
    require_equal_forms(ReferenceFragmentStages);
}

namespace {

// Registers by which nothing touches colours on their way to the targets.
void keep_colors(Scene& scene) {
    Registers& r = *scene.registers;
    r.combiners = {};
    r.fog.mode = FogMode::Off;
    r.fragment.color_sum = r.fragment.alpha_test = false;
    r.blend.enable = r.blend.logic_op_enable = false;
    r.blend.write_mask = 0xf;
    scene.state.antialias = false;
    for (Surface& color : r.targets.color)
        if (color.format != Format::Rgba8) color = {};
}

void touch_colors(unsigned how, Scene& scene) {
    Registers& r = *scene.registers;
    switch (how) {
    case 0:
        r.combiners[0].enable = true;
        scene.state.units = 1;
        return;
    case 1:
        r.fog.mode = FogMode::Linear;
        return;
    case 2:
        r.fragment.color_sum = true;
        return;
    case 3:
        r.fragment.alpha_test = true;
        return;
    case 4:
        r.blend = {.enable = true, .rgb_source = BlendFactor::SourceAlpha};
        return;
    case 5:
        r.blend.logic_op_enable = true;
        r.blend.logic_op = LogicOp::Xor;
        return;
    case 6:
        r.blend.write_mask = 7;
        return;
    case 7:
        r.targets.color[0].format = Format::Rgb565;
        return;
    case 8:
        r.fragment.srgb_targets = 3;
        return;
    case 9:
        scene.state.antialias = true;
        return;
    }
}

} // namespace

TEST_CASE("Colours that nothing touches are written as the pipe's stages write them") {
    auto kept = std::make_unique<Run>();
    auto staged = std::make_unique<Run>();
    for (std::uint32_t seed = 0, tried = 0; tried < 500; ++seed) {
        INFO("seed " << seed);
        Draws draws(seed);
        kept->scene = {};
        test::randomize(draws, kept->scene);
        if (kept->scene.state.samples > 1) continue;
        ++tried;
        keep_colors(kept->scene);
        test::randomize(draws, kept->scene, kept->batch);
        staged->scene = kept->scene;
        staged->batch = kept->batch;
        LaneWords colors;
        for (unsigned lane = 0; lane < BatchFragments; ++lane) {
            const ColorPlanes& from = kept->batch.primary;
            colors.words[lane] = from.r[lane] | static_cast<unsigned>(from.g[lane]) << 8 |
                                 static_cast<unsigned>(from.b[lane]) << 16 |
                                 static_cast<unsigned>(from.a[lane]) << 24;
        }
        const FragmentPipe kept_pipe = kept->scene.compile();
        REQUIRE(kept_pipe.keeps_colors);
        early_depth_test(kept_pipe, kept->batch);
        write_kept(kept_pipe, colors, kept->batch, kept->fates);
        const FragmentPipe staged_pipe = staged->scene.compile(ReferenceFragmentStages);
        early_depth_test(staged_pipe, staged->batch);
        shade(staged_pipe, staged->batch);
        write(staged_pipe, staged->batch, staged->fates);
        require_same_end(*kept, *staged);
    }
}

TEST_CASE("Whatever touches colours is seen when the pipe is compiled") {
    for (unsigned how = 0; how < 10; ++how) {
        INFO("how " << how);
        Scene scene;
        scene.memory.resize(64 * 64 * 4);
        scene.registers->targets.color[0] = {
            .address = 0, .format = Format::Rgba8, .width = 64, .height = 64, .stride = 256};
        keep_colors(scene);
        REQUIRE(scene.compile().keeps_colors);
        touch_colors(how, scene);
        CHECK_FALSE(scene.compile().keeps_colors);
    }
}

TEST_CASE("No byte changes but those of live fragments' pixels") {
    auto run = std::make_unique<Run>();
    for (std::uint32_t seed = 5000; seed < 5200; ++seed) {
        INFO("seed " << seed);
        Draws draws(seed);
        run->scene = {};
        test::randomize(draws, run->scene);
        test::randomize(draws, run->scene, run->batch);
        const std::vector<std::byte> before = run->scene.memory;
        const FragmentMask live = run->batch.live;
        const SampleMasks samples = run->batch.samples;

        const FragmentPipe pipe = run->scene.compile();
        early_depth_test(pipe, run->batch);
        shade(pipe, run->batch);
        write(pipe, run->batch, run->fates);

        const Targets& targets = run->scene.registers->targets;
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i] == run->scene.memory[i]) continue;
            bool touched = false;
            Targets::for_each(targets, [&](const Surface& target) {
                for (unsigned s = 0; s < target.samples; ++s)
                    touched = touched || is_touched(target.plane(s),
                                                    target.samples > 1 ? samples[s] : live,
                                                    run->batch,
                                                    i);
            });
            REQUIRE(touched);
        }
    }
}

TEST_CASE("A target that leaves memory is left out") {
    Scene scene;
    scene.memory.resize(64 * 64 * 4);
    Surface surface{
        .address = 0, .format = Format::Rgba8, .width = 64, .height = 64, .stride = 256};
    scene.registers->targets.color[0] = surface;
    scene.registers->scissor = {.x = 0, .y = 0, .width = 64, .height = 64};
    REQUIRE(scene.compile().color_targets[0].write_mask == 0xf);

    SECTION("one byte beyond memory") {
        scene.registers->targets.color[0].address = 1;
        REQUIRE(scene.compile().color_targets[0].write_mask == 0);
    }
    SECTION("rows that overlap") {
        scene.registers->targets.color[0].stride = 255;
        REQUIRE(scene.compile().color_targets[0].write_mask == 0);
    }
    SECTION("a format beyond the list") {
        scene.registers->targets.color[0].format = static_cast<Format>(31);
        scene.registers->targets.depth = surface;
        scene.registers->targets.depth.format = static_cast<Format>(30);
        REQUIRE(scene.compile().color_targets[0].write_mask == 0);
        REQUIRE(scene.compile().depth_target.format == Format::None);
    }
}

TEST_CASE("Register values beyond their lists draw the same pixels in all forms") {
    const FragmentStages& stages = *GENERATE(&FastFragmentStages, &ReferenceFragmentStages);
    auto batched = std::make_unique<Run>();
    auto single = std::make_unique<Run>();
    for (std::uint32_t seed = 9000; seed < 9300; ++seed) {
        INFO("seed " << seed);
        Draws draws(seed);
        batched->scene = {};
        test::randomize(draws, batched->scene);
        Registers& r = *batched->scene.registers;
        Combiner& combiner = r.combiners[seed % TextureUnits];
        combiner.enable = true;
        combiner.rgb.op = draws.value_below<CombineOp>(16);
        combiner.rgb.scale_shift = static_cast<std::uint8_t>(draws.below(4));
        combiner.rgb.arguments[0].source = draws.value_below<CombineSource>(16);
        combiner.alpha.op = draws.value_below<CombineOp>(16);
        combiner.alpha.arguments[0].operand = draws.value_below<CombineOperand>(4);
        r.blend.enable = true;
        r.blend.rgb_source = draws.value_below<BlendFactor>(16);
        r.blend.rgb_equation = draws.value_below<BlendEquation>(8);
        test::randomize(draws, batched->scene, batched->batch);
        single->scene = batched->scene;
        single->batch = batched->batch;

        const FragmentPipe batched_pipe = batched->scene.compile(stages);
        shade(batched_pipe, batched->batch);
        const FragmentPipe single_pipe = single->scene.compile();
        test::shade_one_by_one(single_pipe, single->batch);
        REQUIRE(same_lanes(batched->batch.color, single->batch.color, single->batch.lanes()));
        write(batched_pipe, batched->batch, batched->fates);
        test::write_one_by_one(single_pipe, single->batch, single->fates);
        REQUIRE((batched->scene.memory == single->scene.memory));
    }
}
