// The gain without a unit is reckoned right where that unit alone limits a draw: stages before and
// behind it then take in one cycle and give in another.

#include "model/timing/without_limit.h"
#include "tests/timing/analytic_scenes.h"
#include "tests/timing/machine_figures.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// With textures the quads wait in the texture unit's own queue, too, and its misses for the memory.
WorkBin fill(bool textured) {
    WorkBin bin = make_bin(uniform_level_scene(128, 0));
    for (WorkTile& tile : bin.tiles)
        for (WorkBatch& batch : tile.batches)
            if (!textured) batch.textures.clear();
    return bin;
}

// `unlimited`: cycles of the machine without the limit, whose gain is to be within a tenth.
void check_gain(const Figures& figures, const char* reckoned_as, std::uint64_t unlimited) {
    const std::uint64_t gain = figures.at("total_cycles") - unlimited;
    const std::uint64_t reckoned = figures.at(reckoned_as);
    REQUIRE(gain > unlimited / 4);
    CHECK(10 * reckoned >= 9 * gain);
    CHECK(10 * reckoned <= 11 * gain);
}

// Beside the draw the host writes so many bytes.
Figures run_beside_host(const TimingConfig& config, const WorkBin& bin, std::uint64_t bytes) {
    GpuTiming timing(config);
    work::CommandAssembler assembler(timing);
    assembler.bin(std::make_shared<const WorkBin>(bin));
    timing.host_transfer({.before_draw = 1, .is_write = true, .at = 1 << 26, .bytes = bytes});
    assembler.end_frame(0);
    return figures_of(timing);
}

} // namespace

TEST_CASE("a draw bound by the fragment pipe gains what it takes less without its limit") {
    const WorkBin bin = fill(GENERATE(false, true));
    TimingConfig config;
    config.memory.bytes_per_cycle = 256;
    const std::uint64_t unlimited = run(config, bin).at("total_cycles");
    config.fragment.quad_cycles = GENERATE(2u, 3u, 4u, 6u);
    CAPTURE(config.fragment.quad_cycles);
    check_gain(run(config, bin), "gain_fragment_cycles", unlimited);
}

// Quads that share a pipe, in squares, or as their primitives take turns and so leave in order.
TEST_CASE("a draw bound by its combiners gains what it takes less without them") {
    WorkBin bin = fill(true);
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    state->combiners[0].enable = true;
    bin.draws[0].state = state;
    TimingConfig config;
    config.memory.bytes_per_cycle = 256;
    config.fragment.distribution = GENERATE(Distribution::Tiles, Distribution::Triangles);
    const std::uint64_t unlimited = run(config, bin).at("total_cycles");
    config.fragment.combiner_cycles = GENERATE(2u, 3u, 6u);
    CAPTURE(config.fragment.distribution, config.fragment.combiner_cycles);
    check_gain(run(config, bin), "gain_fragment_cycles", unlimited);
}

// The wait goes on when the texels have come, and for those that were there.
TEST_CASE("a draw bound by the expansion of its texels gains what it takes less without it") {
    WorkBin bin = fill(true);
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    state->images[0].shape.format = Format::Dxt1Rgb;
    bin.draws[0].state = state;
    TimingConfig config;
    config.memory.bytes_per_cycle = 256;
    config.texel_cache.fragment_fifo = GENERATE(1u, 2u);
    const std::uint64_t unlimited = run(config, bin).at("total_cycles");
    config.texel_cache.decompress_cycles = GENERATE(5u, 20u);
    CAPTURE(config.texel_cache.fragment_fifo, config.texel_cache.decompress_cycles);
    check_gain(run(config, bin), "gain_texture_cycles", unlimited);
}

// What the unit takes for a miss is taken from the answer, too, whoever gives it.
TEST_CASE("a draw bound by the cycles of its misses gains what it takes less without them") {
    const WorkBin bin = fill(true);
    TimingConfig config;
    config.memory.bytes_per_cycle = 256;
    config.texel_l2.enable = GENERATE(false, true);
    const std::uint64_t unlimited = run(config, bin).at("total_cycles");
    config.texture.miss_cycles = GENERATE(8u, 20u);
    CAPTURE(config.texel_l2.enable, config.texture.miss_cycles);
    check_gain(run(config, bin), "gain_texture_cycles", unlimited);
}

// A textured draw of one piece, of which three attributes vary.
WorkBin interpolated_fill() {
    WorkBin bin = fill(true);
    PieceBox box{0, 0, 128, 128};
    box.values = 3;
    bin.draws[0].geometry.vertices = {0};
    bin.draws[0].geometry.pieces = {box};
    bin.draws[0].geometry.primitives = {{.pieces = 1}};
    return bin;
}

// Whatever slows a unit is lifted with its limits, and is what the draw is found to wait for.
TEST_CASE("a draw bound by any parameter of a unit gains what it takes less without the unit's") {
    using Slow = void (*)(TimingConfig&);
    const auto [slow, resource] = GENERATE(table<Slow, Resource>({
        {[](TimingConfig& config) { config.interpolator.value_cycles = 4; },
         Resource::Interpolator},
        {[](TimingConfig& config) { config.fragment.entry_cycles = 6; }, Resource::Fragment},
        {[](TimingConfig& config) { config.texture.rate = TexelRate::Texels; }, Resource::Texture},
        {[](TimingConfig& config) { // Its places, and each is taken for so long.
             config.texture.rate = TexelRate::Texels;
             config.texture.latency = 100;
             config.fragment.pipe_queue = 4;
         },
         Resource::Texture},
        {[](TimingConfig& config) {
             config.raster.quads_per_cycle = 4;
             config.texel_cache.ports = 1;
         },
         Resource::Texture},
        {[](TimingConfig& config) {
             config.raster.quads_per_cycle = 8;
             config.color_cache.ports = 1;
         },
         Resource::Color},
        {[](TimingConfig& config) {
             config.color_cache.enable = false;
             config.color_cache.fragment_fifo = 2;
             config.color_cache.store_cycles = 40;
         },
         Resource::Color},
    }));
    const WorkBin bin = interpolated_fill();
    TimingConfig config;
    config.memory.kind = MemoryKind::Fixed;
    config.memory.channels = 16;
    config.memory.latency = 4;
    config.raster.tile_cycles = 0;
    slow(config);
    const std::uint64_t unlimited = run(without_limit(config, resource), bin).at("total_cycles");
    const auto name = std::string(ResourceNames[static_cast<std::size_t>(resource)]);
    CAPTURE(name, unlimited);
    check_gain(run(config, bin), ("gain_" + name + "_cycles").c_str(), unlimited);
}

// Depths of some draws are tested early, of others late: what one stage of the unit looks up is not
// what the other asks the memory for.
TEST_CASE("an interpolator gains what it takes beside depths that miss, early or late") {
    WorkBin bin = interpolated_fill();
    auto state = std::make_shared<Registers>(*bin.draws[0].state);
    state->depth.test_enable = state->depth.write_enable = true;
    state->targets.depth = state->targets.color[0];
    state->targets.depth.address += 1 << 24;
    state->targets.depth.format = Format::Depth24Stencil8;
    bin.draws[0].state = state;
    bin.draws[0].early_depth = GENERATE(true, false);
    TimingConfig config;
    config.memory.kind = MemoryKind::Fixed;
    config.memory.channels = 16;
    config.interpolator.value_cycles = GENERATE(3u, 4u, 5u);
    config.fragment.latency = GENERATE(1u, 12u, 40u);
    CAPTURE(bin.draws[0].early_depth, config.interpolator.value_cycles, config.fragment.latency);
    const TimingConfig without = without_limit(config, Resource::Interpolator);
    check_gain(run(config, bin), "gain_interpolator_cycles", run(without, bin).at("total_cycles"));
}

// Stores go the way of the reads, whose requests stand behind them.
TEST_CASE("a draw past the colour cache gains what it takes less without the memory's latency") {
    WorkBin bin = fill(false);
    // All quads of one place: each waits for the store of the one before.
    const bool one_place = GENERATE(false, true);
    for (WorkTile& tile : bin.tiles)
        for (WorkBatch& batch : tile.batches)
            for (WorkQuad& quad : batch.quads)
                if (one_place) quad.x = quad.y = 0;
    TimingConfig config;
    config.memory.kind = MemoryKind::Fixed;
    config.memory.channels = 16;
    config.memory.latency = GENERATE(50u, 200u);
    config.color_cache.enable = false;
    config.color_cache.fragment_fifo = GENERATE(2u, 8u);
    config.color_cache.store_cycles = GENERATE(0u, 10u);
    CAPTURE(one_place, config.memory.latency, config.color_cache.fragment_fifo);
    const TimingConfig without = without_limit(config, Resource::MemoryLatency);
    check_gain(
        run(config, bin), "gain_memory_latency_cycles", run(without, bin).at("total_cycles"));
}

// A wider or shorter way from geometry would hold more, or fewer, primitives, which is no limit of
// the resource: a draw bound by memory would gain by it.
TEST_CASE("a machine without a limit keeps the places of its ways") {
    TimingConfig config;
    config.vertex.latency = GENERATE(1u, 40u, 400u);
    config.setup.units = GENERATE(1u, 4u);
    const std::uint32_t places =
        config.clip.queue + (config.vertex.latency - 1) * config.setup.units;
    CHECK(config.primitive_places() == places);
    for (std::size_t i = 0; i < Resources; ++i)
        CHECK(without_limit(config, static_cast<Resource>(i)).primitive_places() == places);
}

// Without the bus all of the host's bytes come while the draw's are still to be moved: the memory
// moves both, and the frame takes no less.
TEST_CASE("a frame bound by the host's bus gains what the memory leaves it") {
    const WorkBin bin = fill(true);
    TimingConfig config;
    config.memory.channels = GENERATE(1u, 2u);
    const std::uint64_t bus = GENERATE(1u, 2u);
    config.memory.bytes_per_cycle = 8 / config.memory.channels;
    config.host.bytes_per_cycle = 0;
    const std::uint64_t bytes = 2 * bus * run_beside_host(config, bin, 0).at("total_cycles");
    const std::uint64_t unlimited = run_beside_host(config, bin, bytes).at("total_cycles");
    config.host.bytes_per_cycle = static_cast<std::uint32_t>(bus);
    const Figures figures = run_beside_host(config, bin, bytes);
    CAPTURE(bytes, figures.at("total_cycles"), unlimited);
    check_gain(figures, "gain_host_cycles", unlimited);
    const std::uint64_t moving = figures.at("memory_data_cycles") / config.memory.channels;
    CHECK(figures.at("gain_host_cycles") <= figures.at("total_cycles") - moving);
}

} // namespace ffgpu::timing
