// Vertex fetch, geometry, clipper and set-up against the closed forms of what they take.

#include "tests/timing/analytic_scenes.h"
#include "tests/timing/front_end_scenes.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

WorkBin culled(std::uint32_t count) {
    return triangles(count, Culled);
}

TEST_CASE("n geometry units take an n-th of the time of a draw that geometry bounds") {
    const auto cycles = [](std::uint32_t units, std::uint32_t order) {
        WorkBin bin = culled(1000);
        bin.draws[0].geometry.lights = 8;
        TimingConfig config = wide_front_end();
        config.vertex.transform_cycles = 4;
        config.vertex.light_cycles = 6;
        config.vertex.units = units;
        return static_cast<double>(run(config, bin, order).at("total_cycles"));
    };
    const double one = cycles(1, 0);
    CHECK(one == Approx(3000 * (4 + 8 * 6)).epsilon(0.01));
    for (const std::uint32_t units : {2u, 4u, 8u, 16u}) {
        INFO("units " << units);
        CHECK(cycles(units, 0) == Approx(one / units).epsilon(0.05));
        CHECK(cycles(units, 3) == cycles(units, 0));
    }
}

TEST_CASE("several vertices a cycle pass where nothing else bounds them") {
    TimingConfig config = wide_front_end();
    for (const std::uint32_t width : {1u, 4u}) {
        config.vertex.vertices_per_cycle = config.vertex.units = width;
        config.setup.units = width;
        INFO("width " << width);
        CHECK(static_cast<double>(cycles_of_1000(config, culled)) ==
              Approx(3000.0 / width).epsilon(0.05)); // culled ones need no rasterizer
    }
}

TEST_CASE("attributes come at fetch_bytes_per_cycle") {
    const auto make = [](std::uint32_t count) {
        WorkBin bin = culled(count);
        bin.draws[0].geometry.vertex_bytes = 64;
        return bin;
    };
    TimingConfig config = wide_front_end();
    for (const std::uint32_t bytes : {4u, 16u, 24u}) {
        config.vertex.fetch_bytes_per_cycle = bytes;
        INFO(bytes << " bytes a cycle");
        // What a vertex leaves of its last cycle is the next one's.
        CHECK(cycles_of_1000(config, make) == 3000 * 64 / bytes);
    }
    CHECK(run(config, make(1000)).at("vertex_fetched_bytes") == 3000 * 64);
}

WorkBin indexed(std::vector<std::uint32_t> numbers, std::uint8_t index_bytes) {
    WorkBin bin = culled(static_cast<std::uint32_t>(numbers.size()) / 3);
    bin.draws[0].geometry.vertices = std::move(numbers);
    bin.draws[0].geometry.index_address = 1 << 20;
    bin.draws[0].geometry.index_bytes = index_bytes;
    return bin;
}

TEST_CASE("indices are read line by line, by a cache of their own or the vertex cache") {
    std::vector<std::uint32_t> numbers(3000);
    for (std::uint32_t i = 0; i < numbers.size(); ++i)
        numbers[i] = i % 3;
    for (const std::uint8_t bytes : {std::uint8_t{2}, std::uint8_t{4}}) {
        TimingConfig config = wide_front_end();
        const std::uint64_t lines = (3000u * bytes + 63) / 64;
        const Figures own = run(config, indexed(numbers, bytes));
        CHECK(own.at("memory_index_read_bytes") == 64 * lines);
        CHECK(own.at("index_cache_accesses") == lines);
        CHECK(own.at("memory_vertex_read_bytes") == 64);
        config.vertex.index_cache_lines = 0;
        const Figures shared = run(config, indexed(numbers, bytes));
        CHECK(shared.at("memory_index_read_bytes") == 0);
        CHECK(shared.at("memory_vertex_read_bytes") == 64 * (lines + 1));
        CHECK(run(config, indexed(numbers, bytes), 5) == shared);
    }
    CHECK(run(wide_front_end(), culled(100)).at("index_cache_accesses") == 0);
}

TEST_CASE("indices asked for ahead hide the memory's latency, one at a time shows it") {
    std::vector<std::uint32_t> numbers(3000, 0);
    const auto cycles = [&](std::uint32_t queue) {
        TimingConfig config = wide_front_end();
        config.memory.latency = 60;
        config.vertex.index_queue = queue;
        return run(config, indexed(numbers, 2)).at("total_cycles");
    };
    const std::uint64_t lines = 3000 * 2 / 64;
    CHECK(cycles(256) < 3000 + 500);
    CHECK(cycles(1) > 3000 + lines * 60);
}

TEST_CASE("the post-transform reuse gives up the oldest vertex, or the one unused for longest") {
    const std::vector<std::uint32_t> numbers{0, 1, 2, 0, 3, 0};
    TimingConfig config = wide_front_end();
    config.vertex.reuse_entries = 3;
    CHECK(run(config, indexed(numbers, 2)).at("vertex_reused") == 1); // 3 takes 0's place
    config.vertex.reuse_policy = ReusePolicy::Lru;
    CHECK(run(config, indexed(numbers, 2)).at("vertex_reused") == 2); // 3 takes 1's
    config.vertex.reuse_entries = 0;
    CHECK(run(config, indexed(numbers, 2)).at("vertex_reused") == 0);
}

TEST_CASE("a primitive leaves geometry behind its own last vertex") {
    // One triangle of 1000 is drawn: the first, whose pixels are done while the others' vertices
    // come, or the last, whose pixels come when all else is over.
    const auto cycles = [](std::uint32_t drawn) {
        WorkBin bin = make_bin(planar_scene(64));
        const WorkBin list = culled(1000);
        bin.draws[0].geometry = list.draws[0].geometry;
        for (WorkBatch& batch : bin.tiles[0].batches) {
            batch.textures.clear();
            for (WorkQuad& quad : batch.quads)
                quad.primitive = drawn;
        }
        PrimitiveWork& primitive = bin.draws[0].geometry.primitives[drawn];
        primitive.fate = PrimitiveFate::Drawn;
        primitive.pieces = 1;
        bin.draws[0].geometry.pieces = {{0, 0, 64, 64}};
        TimingConfig config = wide_front_end();
        config.vertex.transform_cycles = 4;
        config.raster.tile_cycles = 0;
        return static_cast<double>(run(config, bin).at("total_cycles"));
    };
    CHECK(cycles(999) - cycles(0) == Approx(32 * 32).epsilon(0.05));
    CHECK(cycles(500) == Approx(cycles(0)).epsilon(0.005));
}

TEST_CASE("a primitive takes the clipper plane_cycles for each plane, one that needs no cut none") {
    TimingConfig config = wide_front_end();
    config.clip.plane_cycles = 5;
    for (const std::uint8_t planes : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{6}}) {
        const auto make = [&](std::uint32_t count) {
            return triangles(count, {.pieces = 1, .planes = planes, .fate = PrimitiveFate::Drawn});
        };
        INFO(int{planes} << " planes");
        CHECK(cycles_of_1000(config, make) == 1000u * std::max(planes * 5u, 3u)); // or its vertices
        CHECK(run(config, make(10)).at("clip_planes") == 10u * planes);
    }
    CHECK(cycles_of_1000(config, culled) == 3000);
}

TEST_CASE("what lies outside ends at the clipper, and the draw with it") {
    TimingConfig config = wide_front_end();
    config.setup.reject_cycles = 50;
    const auto make = [](std::uint32_t count) {
        return triangles(count, {.fate = PrimitiveFate::Outside});
    };
    CHECK(cycles_of_1000(config, make) == 3000);
    CHECK(run(config, make(1000)).at("clip_outside") == 1000);
    CHECK(cycles_of_1000(config, culled) == 50000);
}

TEST_CASE("a culled primitive ends in set-up, the last one's draw in the rasterizer") {
    for (const Walk walk : {Walk::Box, Walk::Tiles}) {
        TimingConfig config = wide_front_end();
        config.raster.walk = walk;
        config.raster.traversal = work::Traversal::Nested; // by which tiles are walked
        CHECK(run(config, culled(1000)).at("raster_busy_cycles") == 1);
    }
}

TEST_CASE("m set-up units take an m-th of what the pieces and their attributes take one") {
    const auto make = [](std::uint32_t count) {
        WorkBin bin = triangles(count, {.pieces = 2});
        bin.draws[0].geometry.interpolants = 5;
        return bin;
    };
    for (const std::uint32_t units : {1u, 2u, 4u, 8u, 16u}) {
        TimingConfig config = wide_front_end();
        config.setup.units = units;
        config.setup.triangle_cycles = 32;
        INFO("units " << units);
        CHECK(cycles_of_1000(config, make) == 2000u * 32 / units);
        config.setup.attribute_cycles = 8;
        CHECK(cycles_of_1000(config, make) == 2000u * (32 + 5 * 8) / units);
        CHECK(run(config, make(100), 7) == run(config, make(100)));
    }
}

} // namespace
} // namespace ffgpu::timing
