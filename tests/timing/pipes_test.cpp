// Fragment pipes side by side: what is bound by filling takes a pipe's share of the quads, what is
// bound by geometry is not changed.

#include "model/timing/fragment_pipes.h"
#include "tests/timing/textured_draws.h"

#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// With texture environments of `environments` units.
WorkBin filling(unsigned environments = 0) {
    WorkBin bin = textured_draw(1);
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    for (unsigned unit = 0; unit < environments; ++unit)
        state->combiners[unit].enable = true;
    bin.draws[0].state = state;
    return bin;
}

// `at_end`: cycles in which some pipes have quads left and others none.
void check_share(std::uint64_t cycles,
                 const TimingConfig& config,
                 std::uint64_t quad_cycles,
                 std::uint64_t at_end = 0) {
    const std::uint64_t share = quad_cycles / config.raster.quads_per_cycle;
    INFO("pipes " << config.raster.quads_per_cycle);
    CHECK(cycles >= share);
    CHECK(static_cast<double>(cycles - fill_and_drain(config) - at_end) <=
          1.05 * static_cast<double>(share));
}

TEST_CASE("1 to 16 pipes share the quads of a textured draw, distributed by tiles or scan lines") {
    const WorkBin bin = filling();
    for (const std::uint32_t pipes : {1u, 2u, 4u, 8u, 16u}) {
        TimingConfig config = wide_machine(pipes);
        check_share(run(config, bin).at("total_cycles"), config, FillQuads);
        config.fragment.distribution = Distribution::Scanlines;
        config.fragment.distribution_width = 2;
        config.raster.traversal = Traversal::Column; // Rows of quads in turn.
        check_share(run(config, bin).at("total_cycles"), config, FillQuads);
    }
}

TEST_CASE("Each aligned block of as many squares as pipes has one of each pipe's") {
    for (const std::uint32_t pipes : {2u, 4u, 8u, 16u}) {
        for (std::uint32_t width = 1; width <= pipes; width *= 2) {
            const std::uint32_t height = pipes / width, x = 6 * width, y = 9 * height;
            std::set<std::uint32_t> seen;
            for (std::uint32_t row = y; row < y + height; ++row)
                for (std::uint32_t column = x; column < x + width; ++column)
                    seen.insert(pipe_of_square(column, row, pipes));
            INFO(pipes << " pipes, " << width << " squares wide");
            CHECK(seen.size() == pipes);
        }
    }
}

TEST_CASE("1 to 16 pipes share the quads of a half of the window, in each order of its tiles") {
    const bool falls = GENERATE(false, true);
    const auto order =
        GENERATE(Traversal::Tiled, Traversal::Nested, Traversal::Morton, Traversal::Hilbert);
    const double size = FillSize;
    WorkBin bin = make_bin({FillSize, FillSize, 32, [&](double x, double y, SceneSample& s) {
                                s = {.u = x, .v = y};
                                return (falls ? size - x : x) < y;
                            }});
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    state->blend.write_mask = 0;
    bin.draws[0].state = state;
    constexpr std::uint64_t Side = FillSize / 2, HalfQuads = Side * (Side + 1) / 2;
    for (const std::uint32_t pipes : {1u, 2u, 4u, 8u, 16u}) {
        TimingConfig config = wide_machine(pipes);
        config.raster.traversal = order;
        INFO("falls " << falls << ", order " << static_cast<int>(order));
        const std::uint64_t cycles = run(config, bin).at("total_cycles");
        check_share(cycles, config, HalfQuads, config.fragment.pipe_queue);
    }
}

TEST_CASE("1 to 16 pipes share three cycles a quad of texture environments") {
    const WorkBin bin = filling(3);
    for (const std::uint32_t pipes : {1u, 2u, 4u, 8u, 16u}) {
        const TimingConfig config = wide_machine(pipes);
        check_share(run(config, bin).at("total_cycles"), config, 3 * FillQuads);
    }
}

TEST_CASE("Scan lines that all fall to one pipe are not faster on many") {
    const Scene scene{FillSize, FillSize, FillSize, [](double x, double y, SceneSample& s) {
                          s = {.u = x, .v = y};
                          return static_cast<unsigned>(y) / 2 % 16 == 0;
                      }};
    TimingConfig config = wide_machine(16);
    config.fragment.distribution = Distribution::Scanlines;
    config.fragment.distribution_width = 2;
    CHECK(run(config, make_bin(scene)).at("total_cycles") >= FillQuads / 16);
}

TEST_CASE("A draw that is bound by geometry takes the same cycles on 1 and on 16 pipes") {
    WorkBin bin = make_bin(planar_scene(8));
    GeometryWork& geometry = bin.draws[0].geometry;
    geometry.vertex_bytes = 16;
    for (std::uint32_t i = 0; i < 3000; ++i)
        geometry.vertices.push_back(i);
    for (std::uint32_t i = 0; i < 1000; ++i)
        geometry.primitives.push_back(
            {.key = i,
             .last_vertex = 3 * i + 2,
             .pieces = i == 0 ? 1u : 0u,
             .fate = i == 0 ? PrimitiveFate::Drawn : PrimitiveFate::Culled});
    geometry.pieces = {{0, 0, 8, 8}};
    const auto cycles = [&](std::uint32_t pipes) {
        return static_cast<double>(run(wide_machine(pipes), bin).at("total_cycles"));
    };
    CHECK(cycles(1) > 3000 * 4);
    CHECK(cycles(16) == Approx(cycles(1)).epsilon(0.01));
}

} // namespace
} // namespace ffgpu::timing
