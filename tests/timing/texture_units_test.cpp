// Texture units side by side in a fragment pipe: cycles against the closed forms of
// docs/units/texel_cache.md.

#include "tests/timing/textured_draws.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

TimingConfig units_machine(std::uint32_t pipes, std::uint32_t units, UnitShare share) {
    TimingConfig config = wide_machine(pipes);
    config.texture.units = units;
    config.texture.share = share;
    return config;
}

// The fill-bound draw takes `each` cycles a quad of a pipe, and at most 5 percent more.
void check_cycles(const TimingConfig& config, const WorkBin& bin, std::uint64_t each) {
    const std::uint64_t share = each * FillQuads / config.raster.quads_per_cycle;
    const std::uint64_t cycles = run(config, bin).at("total_cycles");
    INFO(config.raster.quads_per_cycle << " pipes, " << config.texture.units << " units, " << each
                                       << " cycles a quad");
    CHECK(cycles >= share);
    CHECK(static_cast<double>(cycles - fill_and_drain(config)) <=
          1.05 * static_cast<double>(share));
}

TEST_CASE("A unit for each texture: two textures on two units cost what one costs on one") {
    for (const std::uint32_t pipes : {1u, 4u}) {
        const TimingConfig one = units_machine(pipes, 1, UnitShare::Textures),
                           two = units_machine(pipes, 2, UnitShare::Textures);
        const WorkBin single = textured_draw(1), twofold = textured_draw(2);
        check_cycles(one, single, 1);
        check_cycles(two, twofold, 1);
        check_cycles(one, twofold, 2);
        // A second unit is of no use to one texture.
        CHECK(run(two, single).at("total_cycles") == run(one, single).at("total_cycles"));
    }
}

TEST_CASE("Three textures on two units: the first unit has two of them") {
    check_cycles(units_machine(2, 2, UnitShare::Textures), textured_draw(3), 2);
    check_cycles(units_machine(2, 3, UnitShare::Textures), textured_draw(3), 1);
    check_cycles(units_machine(2, 2, UnitShare::Samples), textured_draw(4), 2);
}

TEST_CASE("A trilinear texture takes two samples: of one unit, or of two that share them") {
    const WorkBin trilinear = textured_draw(1, 0.5);
    check_cycles(units_machine(1, 1, UnitShare::Textures), trilinear, 2);
    check_cycles(units_machine(1, 2, UnitShare::Textures), trilinear, 2);
    check_cycles(units_machine(1, 2, UnitShare::Samples), trilinear, 1);
    TimingConfig wide = units_machine(1, 1, UnitShare::Textures);
    wide.texel_cache.bilinear_quads_per_cycle = 2;
    wide.texel_cache.lookups_per_cycle = 8; // Two levels of up to four lines.
    check_cycles(wide, trilinear, 1);
}

TEST_CASE("An anisotropic texture takes a sample for each probe, trilinear ones two") {
    for (const unsigned probes : {2u, 3u, 8u}) {
        for (const unsigned levels : {1u, 2u}) {
            WorkBin bin = textured_draw(1, levels == 1 ? 0 : 0.5);
            for (WorkBatch& batch : bin.tiles[0].batches) {
                TexelFootprints all;
                const std::vector<TexelAccess> once = batch.textures[0].accesses();
                for (std::size_t i = 0; i < once.size(); i += levels) {
                    for (unsigned probe = 0; probe < probes; ++probe)
                        for (unsigned level = 0; level < levels; ++level)
                            all.add(once[i + level]);
                }
                batch.textures[0] = all;
            }
            check_cycles(units_machine(1, 1, UnitShare::Textures), bin, probes * levels);
            check_cycles(units_machine(1, 4, UnitShare::Samples), bin, (probes * levels + 3) / 4);
        }
    }
}

TEST_CASE("A miss takes the tags for as many cycles as it is said to") {
    // A texture of 512 x 512 texels, each line missed once: 16 texels of 4 bytes a line.
    const auto misses_and_cycles = [](std::uint32_t miss_cycles) {
        WorkBin bin = make_bin(planar_scene(FillSize));
        auto state = std::make_shared<Registers>(*bin.draws[0].state);
        state->blend.write_mask = 0;
        bin.draws[0].state = state;
        TimingConfig config = wide_machine(1);
        config.texture.miss_cycles = miss_cycles;
        config.texel_cache.sets = 4096; // No line twice.
        const Figures figures = run(config, bin);
        CHECK(figures.at("texel_cache_misses") == FillSize * FillSize / 16);
        return figures.at("total_cycles");
    };
    const std::uint64_t free = misses_and_cycles(0);
    for (const std::uint32_t each : {1u, 3u, 10u})
        CHECK(static_cast<double>(misses_and_cycles(each) - free) ==
              Approx(each * FillSize * FillSize / 16.0).epsilon(0.005));
}

TEST_CASE("Primitives that take turns share the pipes, and quads leave in order") {
    for (const std::uint32_t pipes : {1u, 2u, 4u, 8u, 16u}) {
        TimingConfig config = wide_machine(pipes);
        config.fragment.distribution = Distribution::Triangles;
        config.setup.triangle_cycles = 1;
        config.raster.tile_cycles = 0; // A block holds four quads of each of four primitives.
        check_cycles(config, textured_draw(1, 0, 32), 1);
    }
    // One large primitive is one pipe's alone.
    TimingConfig config = wide_machine(16);
    config.fragment.distribution = Distribution::Triangles;
    CHECK(run(config, textured_draw(1)).at("total_cycles") >= FillQuads);
}

TEST_CASE("Texture units in any order of evaluation: the same figures") {
    TimingConfig config = units_machine(4, 2, UnitShare::Textures);
    config.fragment.distribution = Distribution::Triangles;
    config.texel_cache.outstanding_lines = 2;
    config.fragment.queue = config.fragment.pipe_queue = 2;
    const WorkBin bin = textured_draw(3, 0.5, 16);
    const Figures in_order = run(config, bin);
    for (const std::uint32_t seed : {1u, 2u, 3u})
        CHECK(run(config, bin, seed) == in_order);
}

} // namespace
} // namespace ffgpu::timing
