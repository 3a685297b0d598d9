// States of blocks, coarse depths, and where depth is tested, over random work: nothing that is
// written changes, and bytes add up.

#include "model/base/input_error.h"
#include "model/device/compare.h"
#include "tests/gpu/depth_scene.h"
#include "tests/timing/values_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

using test::DepthScene;
using test::DepthSceneKind;
using work::DepthTest;

struct Result {
    Figures figures;
    std::uint64_t written = 0;
    std::uint64_t drawn = 0; // by the functional GPU
    int differing_lines = 0;
};

Result run_scene(std::uint32_t seed,
                 const DepthSceneKind& kind,
                 const TimingConfig& config,
                 const Evaluation& evaluation = {}) {
    ValuesBench bench(config, evaluation);
    work::CommandAssembler assembler(bench);
    DepthScene random(seed, kind);
    random.scene.gpu.set_work_sink(&assembler, WorkDetail::Values);
    for (int frame = 0; frame < 2; ++frame)
        random.frame(30, seed % 3 != 0);
    random.scene.gpu.set_work_sink(nullptr);
    auto counted = test::counters(random.scene.gpu);
    return {
        bench.figures(), bench.written, counted.at("fragments_written"), bench.differing_lines()};
}

const std::vector<DepthSceneKind> Kinds{
    {},
    {Format::Depth16, Format::Rgb565, 1},
    {Format::Depth24Stencil8, Format::Rgba8, MaxSamples},
    {Format::Depth16, Format::Luminance8, 1},
};

// Features and shapes by seed: every pair of features comes up.
TimingConfig config_of(std::uint32_t seed) {
    TimingConfig config;
    config.depth_cache.line_bytes = 32u << seed % 4;
    config.depth_cache.sets = 2;
    config.depth_cache.layout = seed % 5 == 0 ? work::Layout::Linear : work::Layout::Blocked;
    config.depth_cache.transfer_bytes = config.color_cache.transfer_bytes = 1;
    config.color_cache.sets = 2;
    config.depth_blocks.fast_clear = config.color_blocks.compression = seed % 2 == 0;
    config.depth_blocks.compression = config.color_blocks.fast_clear = seed % 4 < 2;
    config.hierarchical_depth.keeps = seed % 7 == 0 ? CoarseDepth::Max : CoarseDepth::MinMax;
    config.hierarchical_depth.accepts = seed % 3 == 0 && seed % 7 != 0;
    config.hierarchical_depth.block_lines = 1u << seed % 3;
    config.hierarchical_depth.depth_bits = seed % 2 == 0 ? 24 : 10;
    config.depth.test = static_cast<DepthTest>(seed % 3);
    return config;
}

void check_bytes(const Figures& figures, const std::string& target, std::uint32_t line) {
    const auto cache = [&](const char* name) { return figures.at(target + "_cache_" + name); };
    const auto blocks = [&](const char* name) {
        const auto found = figures.find(target + "_blocks_" + name);
        return found == figures.end() ? 0 : found->second;
    };
    CHECK(cache("read_bytes") + blocks("cleared_read_bytes") + blocks("compressed_read_bytes") ==
          line * (cache("misses") - cache("misses_without_fetch") + cache("partial_fetches")));
    if (line <= 64)
        CHECK(cache("dirtied_bytes") + blocks("completed_write_bytes") ==
              cache("written_bytes") + cache("dropped_bytes") + blocks("saved_write_bytes"));
}

TEST_CASE("No feature changes what is written, and bytes add up, over seeded random work") {
    std::uint64_t culled = 0, accepted = 0, compressed = 0, cleared = 0, merged = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        INFO("seed " << seed);
        const TimingConfig config = config_of(seed);
        // Its own checks: what is culled fails, codes decode, cleared blocks hold the clear value.
        const Result result = run_scene(seed, Kinds[seed % Kinds.size()], config);
        CHECK(result.written == result.drawn);
        CHECK(result.differing_lines == 0);
        check_bytes(result.figures, "depth", config.depth_cache.line_bytes);
        check_bytes(result.figures, "color", config.color_cache.line_bytes);
        culled += result.figures.at("hierarchical_depth_culled_quads");
        accepted += result.figures.at("hierarchical_depth_accepted_quads");
        for (const char* target : {"depth_blocks_", "color_blocks_"}) {
            const std::string name(target);
            if (result.figures.count(name + "cleared") == 0) continue;
            compressed += result.figures.at(name + "compressed_writes");
            cleared += result.figures.at(name + "cleared_reads");
            merged += result.figures.at(name + "merge_read_bytes");
        }
    }
    CHECK(culled > 1000);
    CHECK(accepted > 1000);
    CHECK(compressed > 1000);
    CHECK(cleared > 1000);
    CHECK(merged > 0);
}

TEST_CASE("The order of evaluation and the pace cannot be seen, with all features on") {
    for (std::uint32_t seed : {4u, 9u, 12u, 14u}) {
        const TimingConfig config = config_of(seed);
        const auto figures = [&](const Evaluation& evaluation) {
            return run_scene(seed, Kinds[seed % Kinds.size()], config, evaluation).figures;
        };
        const Figures expected = figures({0, Pace::EveryCycle});
        CAPTURE(seed);
        CHECK(figures({0, Pace::Lockstep}) == expected);
        CHECK(figures({0, Pace::Decoupled}) == expected);
        CHECK(figures({77, Pace::Decoupled}) == expected);
    }
}

// Quads of which the alpha test leaves nothing end where others wait for a place.
TEST_CASE("The order of evaluation and the pace cannot be seen where targets have no caches") {
    for (std::uint32_t seed = 0; seed < 16; ++seed) {
        TimingConfig config;
        config.depth.test = DepthTest::Late;
        config.depth_cache.enable = false;
        config.color_cache.enable = seed % 2 == 0;
        config.depth_cache.fragment_fifo = 1 + seed % 5;
        const auto figures = [&](const Evaluation& evaluation) {
            return run_scene(seed, Kinds[seed % Kinds.size()], config, evaluation).figures;
        };
        const Figures expected = figures({0, Pace::EveryCycle});
        CAPTURE(seed);
        CHECK(figures({0, Pace::Decoupled}) == expected);
        CHECK(figures({77, Pace::Decoupled}) == expected);
    }
}

// Tells the contents of a command's targets before the command.
struct ToldContents final : work::CommandSink {
    explicit ToldContents(GpuTiming& to)
        : timing(to) {}

    void command(std::shared_ptr<const work::WholeCommand> command) override {
        if (command->draw.state)
            Targets::for_each(command->draw.state->targets, [&](const Surface& surface) {
                if (surface.format == Format::None) return;
                auto content = std::make_shared<SurfaceContent>();
                content->surface = surface;
                content->bytes.resize(surface.bytes());
                timing.content(content);
            });
        timing.command(std::move(command));
    }
    void host_transfer(const HostTransfer& transfer) override { timing.host_transfer(transfer); }
    void end_frame(std::uint32_t frame) override { timing.end_frame(frame); }

    GpuTiming& timing;
};

TEST_CASE("Values alone change no figure of a machine that does not follow them") {
    TimingConfig config;
    config.raster.architecture = GENERATE(Architecture::Immediate, Architecture::TileBased);
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const auto figures = [&](WorkDetail detail, bool tells) {
            GpuTiming timing(config);
            ToldContents told(timing);
            work::CommandAssembler assembler(tells ? static_cast<work::CommandSink&>(told)
                                                   : timing);
            DepthScene random(seed, Kinds[seed % Kinds.size()]);
            random.scene.gpu.set_work_sink(&assembler, detail);
            random.frame(30, seed % 2 == 0);
            random.scene.gpu.set_work_sink(nullptr);
            return figures_of(timing);
        };
        const auto without = figures(WorkDetail::Masks, false);
        CHECK(figures(WorkDetail::Values, false) == without);
        CHECK(figures(WorkDetail::Values, true) == without);
    }
}

TEST_CASE("What fails and what passes for certain is what every depth of the range says") {
    using Verdict = HierarchicalDepth::Verdict;
    for (unsigned function = 0; function < 8; ++function)
        for (std::uint32_t least = 0; least < 6; ++least)
            for (std::uint32_t greatest = least; greatest < 6; ++greatest)
                for (std::uint32_t depth = 0; depth < 6; ++depth) {
                    unsigned passes = 0;
                    for (std::uint32_t stored = least; stored <= greatest; ++stored)
                        passes += compare(static_cast<Compare>(function), depth, stored);
                    const Verdict verdict =
                        compare_range(static_cast<Compare>(function), depth, {least, greatest});
                    if (passes == 0)
                        CHECK(verdict == Verdict::Fails);
                    else if (passes == greatest - least + 1)
                        CHECK(verdict == Verdict::Passes);
                    else
                        CHECK(verdict == Verdict::Unknown);
                }
}

TEST_CASE("A tile-based machine has no blocks, but tests depth where it is told to") {
    const auto refused = [](auto&& change, const std::string& message) {
        TimingConfig config;
        config.raster.architecture = Architecture::TileBased;
        change(config);
        CHECK_THROWS_WITH(GpuTiming(config), Catch::Matchers::Contains(message));
        config.raster.architecture = Architecture::Immediate;
        CHECK_NOTHROW(GpuTiming(config));
    };
    refused([](TimingConfig& config) { config.hierarchical_depth.keeps = CoarseDepth::Max; },
            "hierarchical_depth: ");
    refused([](TimingConfig& config) { config.depth_blocks.fast_clear = true; }, "depth_blocks: ");
    refused([](TimingConfig& config) { config.color_blocks.compression = true; }, "color_blocks: ");
    TimingConfig config;
    config.raster.architecture = Architecture::TileBased;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        const auto figures = [&](DepthTest test) {
            config.depth.test = test;
            const Result result = run_scene(seed, Kinds[seed % Kinds.size()], config);
            CHECK(result.written == result.drawn);
            return result.figures;
        };
        const Figures usual = figures(DepthTest::AsGlAllows), late = figures(DepthTest::Late);
        for (const char* const name : {"tile_depth_loaded_bytes", "tile_color_stored_bytes"})
            CHECK(late.at(name) == usual.at(name));
        CHECK(late.at("texel_cache_accesses") >= usual.at("texel_cache_accesses"));
        CHECK(figures(DepthTest::EarlyWhereExact).at("texel_cache_accesses") <=
              usual.at("texel_cache_accesses"));
    }
}

TEST_CASE("What passes for certain is known of the least depth alone") {
    TimingConfig config;
    config.hierarchical_depth.keeps = CoarseDepth::Max;
    config.hierarchical_depth.accepts = true;
    CHECK_THROWS_WITH(GpuTiming(config),
                      Catch::Matchers::Contains("hierarchical_depth.accepts: ") &&
                          Catch::Matchers::Contains("min_max"));
}

TEST_CASE("A configuration that needs values says so where there are none") {
    const bool clears_alone = GENERATE(false, true);
    TimingConfig config;
    config.depth_blocks.compression = !clears_alone;
    config.depth_blocks.fast_clear = clears_alone;
    GpuTiming timing(config);
    work::CommandAssembler assembler(timing);
    test::Scene scene(64, 64);
    scene.gpu.set_work_sink(&assembler);
    scene.clear(0);
    if (!clears_alone)
        scene.draw(PrimitiveType::Triangles,
                   {{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                    {1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                    {1, 1, 0, 1, 1, 1, 1, 1, 0, 0}});
    CHECK_THROWS_WITH(scene.gpu.finish(),
                      Catch::Matchers::Contains("depth_blocks: needs the values") &&
                          Catch::Matchers::Contains("--work-values"));
}

} // namespace
} // namespace ffgpu::timing
