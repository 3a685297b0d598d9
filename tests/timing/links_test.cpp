// What a latency between two units costs the whole machine: the fill of its delay line, once.

#include "tests/timing/analytic_scenes.h"
#include "tests/timing/machine_figures.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// Triangles that are culled: work for vertex fetch, geometry and set-up alone.
WorkBin culled_triangles(std::uint32_t count) {
    WorkBin bin;
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = std::make_shared<Registers>();
    draw.geometry.vertex_bytes = 16;
    draw.geometry.vertex_address = 1 << 16;
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        draw.geometry.vertices.push_back(i);
    for (std::uint32_t i = 0; i < count; ++i)
        draw.geometry.primitives.push_back(
            {.key = i, .last_vertex = 3 * i + 2, .fate = PrimitiveFate::Culled});
    return bin;
}

// A picture without a texture, small enough to stay in the colour cache.
WorkBin flat_picture() {
    WorkBin bin = make_bin(planar_scene(64));
    for (WorkBatch& batch : bin.tiles[0].batches)
        batch.textures.clear();
    return bin;
}

TEST_CASE("the latency from geometry to set-up is paid once a drain, whatever the queue holds") {
    const WorkBin bin = culled_triangles(3000);
    for (const std::uint32_t queue : {2u, 16u, 256u}) {
        const auto cycles = [&](std::uint32_t latency, std::uint32_t order) {
            TimingConfig config;
            config.vertex.transform_cycles = 1;
            config.vertex.latency = latency;
            config.setup.queue = queue;
            return run(config, bin, order).at("total_cycles");
        };
        INFO("queue " << queue);
        CHECK(cycles(4000, 1) - cycles(40, 0) == 4000 - 40);
        CHECK(cycles(41, 2) - cycles(40, 3) == 1);
    }
}

// A link between units of the fragment pipes, by its latency.
struct FragmentLink {
    const char* name;
    std::uint32_t& (*latency)(TimingConfig& config);
};

TEST_CASE(
    "the latency of a link behind the fragments' look-ups is paid once a drain, at any width") {
    const WorkBin bin = flat_picture();
    const FragmentLink links[]{
        {"environments to late depth",
         [](TimingConfig& config) -> std::uint32_t& { return config.fragment.latency; }},
        {"late depth to colour",
         [](TimingConfig& config) -> std::uint32_t& { return config.depth_cache.latency; }}};
    for (const FragmentLink& link : links)
        for (const std::uint32_t width : {1u, 4u}) {
            const auto cycles = [&](std::uint32_t latency, std::uint32_t order) {
                TimingConfig config;
                config.memory.refresh_interval_cycles = 0; // A longer run would meet another one.
                config.raster.quads_per_cycle = width;
                config.fragment.queue = 2 * width;
                link.latency(config) = latency;
                return run(config, bin, order).at("total_cycles");
            };
            INFO(link.name << ", width " << width);
            CHECK(cycles(1000, 1) - cycles(12, 0) == 1000 - 12);
            CHECK(cycles(13, 2) - cycles(12, 3) == 1);
        }
}

TimingConfig one_entry_queues() {
    TimingConfig config;
    config.vertex.fetch_queue = config.setup.queue = config.raster.queue = 1;
    config.fragment.queue = config.memory.queue = 1;
    const auto shrink = [](auto& cache) {
        cache.fragment_fifo = cache.outstanding_lines = 1;
        cache.request_queue = cache.miss_queue = 1;
        cache.sets = cache.ways = 1;
        cache.banks = 2;
        cache.ports = 1;
    };
    shrink(config.texel_cache);
    shrink(config.depth_cache);
    shrink(config.color_cache);
    return config;
}

TEST_CASE("a machine whose queues hold one entry ends, in every order of evaluation alike") {
    const WorkBin bin = make_bin(planar_scene(64), MaxSamples);
    const Figures figures = run(one_entry_queues(), bin);
    CHECK(figures.at("texture_quads") == 32 * 32);
    for (const std::uint32_t order : {1u, 2u, 3u})
        CHECK(run(one_entry_queues(), bin, order) == figures);
}

TEST_CASE("replacement, hash, banks and queues of a cache change no figure with the order") {
    TimingConfig config;
    config.texel_cache.sets = config.color_cache.sets = 4;
    config.texel_cache.replacement = work::Replacement::Random;
    config.texel_cache.index_hash = work::IndexHash::Xor;
    config.texel_cache.banks = 2;
    config.texel_cache.ports = 1;
    config.texel_cache.miss_queue = 3;
    config.texel_cache.request_queue = 2;
    config.color_cache.replacement = work::Replacement::Fifo;
    config.color_cache.write_miss = WriteMiss::FetchOnWrite;
    const WorkBin bin = make_bin(floor_scene(256), MaxSamples);
    const Figures figures = run(config, bin);
    CHECK(figures.at("texel_cache_bank_conflicts") > 0);
    CHECK(figures.at("texel_cache_hits_under_miss") > 0);
    for (const std::uint32_t order : {1u, 2u})
        CHECK(run(config, bin, order) == figures);
}

} // namespace
} // namespace ffgpu::timing
