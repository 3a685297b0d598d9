// The configuration of the machine in time: one struct a unit, every field with unit, range and
// meaning. Defaults describe a mid-size part of the early 2000s: one pipe of four fragments a
// cycle, a 16 KB texel cache, 16 bytes a cycle of memory bandwidth.

#pragma once

#include "model/base/parameters.h"
#include "model/timing/cache_traffic_config.h"
#include "model/timing/memory/config.h"
#include "model/work/cache_policy.h"
#include "model/work/config.h"

#include <cstdint>

namespace ffgpu::timing {

using work::Architecture;
using work::Layout;
using work::Traversal;

struct CommandProcessorConfig {
    static constexpr std::string_view Name = "command_processor";
    std::uint32_t draw_cycles = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("draw_cycles",
              self.draw_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "to decode a draw and its state"});
    }
};

struct VertexConfig {
    static constexpr std::string_view Name = "vertex";
    std::uint32_t cache_sets = 16;
    std::uint32_t cache_ways = 4;
    std::uint32_t line_bytes = 64;
    std::uint32_t fetch_queue = 16;
    std::uint32_t reuse_entries = 16;
    std::uint32_t transform_cycles = 4;
    std::uint32_t light_cycles = 6;
    std::uint32_t latency = 40;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("cache_sets",
              self.cache_sets,
              {.unit = "sets",
               .minimum = 1,
               .maximum = 65536,
               .power_of_two = true,
               .meaning = "vertex fetch cache"});
        field("cache_ways",
              self.cache_ways,
              {.unit = "ways", .minimum = 1, .maximum = 64, .meaning = "vertex fetch cache"});
        field("line_bytes",
              self.line_bytes,
              {.unit = "bytes",
               .minimum = 16,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "line of the vertex fetch cache"});
        field("fetch_queue",
              self.fetch_queue,
              {.unit = "vertices",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "vertices waiting for their data"});
        field("reuse_entries",
              self.reuse_entries,
              {.unit = "vertices",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "post-transform reuse, first in first out; 0: none"});
        field("transform_cycles",
              self.transform_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of the geometry unit a vertex"});
        field("light_cycles",
              self.light_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1024,
               .meaning = "more for each enabled light"});
        field("latency",
              self.latency,
              {.unit = "cycles", .minimum = 1, .maximum = 4096, .meaning = "of the geometry unit"});
    }
};

struct SetupConfig {
    static constexpr std::string_view Name = "setup";
    std::uint32_t triangle_cycles = 2;
    std::uint32_t reject_cycles = 1;
    std::uint32_t queue = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field(
            "triangle_cycles",
            self.triangle_cycles,
            {.unit = "cycles", .minimum = 1, .maximum = 1024, .meaning = "to set up a primitive"});
        field("reject_cycles",
              self.reject_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "for a primitive that is clipped away or culled"});
        field("queue",
              self.queue,
              {.unit = "primitives",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between geometry and set-up"});
    }
};

struct RasterConfig : work::RasterOrder {
    static constexpr std::string_view Name = "raster";
    std::uint32_t quads_per_cycle = 1;
    std::uint32_t tile_cycles = 1;
    std::uint32_t queue = 64;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        RasterOrder::visit(self, field);
        field("quads_per_cycle",
              self.quads_per_cycle,
              {.unit = "quads/cycle",
               .minimum = 1,
               .maximum = 16,
               .meaning = "of the rasterizer, and the number of fragment pipes: each with its own "
                          "look-ups, filters and environments"});
        field("tile_cycles",
              self.tile_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "to step to a primitive's next tile"});
        field("queue",
              self.queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between rasterizer and early depth"});
    }
};

// What a cache does in time, whatever its shape.
struct CachePace : work::CachePolicy, CacheTrafficConfig {
    std::uint32_t lookups_per_cycle = 1;
    std::uint32_t fragment_fifo = 64;
    std::uint32_t outstanding_lines = 64;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("lookups_per_cycle",
              self.lookups_per_cycle,
              {.unit = "lines/cycle",
               .minimum = 1,
               .maximum = 64,
               .meaning = "tags compared a cycle, for each fragment pipe"});
        field("fragment_fifo",
              self.fragment_fifo,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "quads between tag check and data, of each fragment pipe: hides misses"});
        field("outstanding_lines",
              self.outstanding_lines,
              {.unit = "lines",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "fills under way at once"});
        CachePolicy::visit(self, field);
        CacheTrafficConfig::visit(self, field);
    }
};

// The caches of depth and colour.
struct CacheConfig : work::CacheShape, CachePace {
    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        CacheShape::visit(self, field);
        CachePace::visit(self, field);
    }
};

struct TexelCacheConfig : work::TexelCacheShape, CachePace {
    static constexpr std::string_view Name = "texel_cache";
    std::uint32_t bilinear_quads_per_cycle = 1;

    TexelCacheConfig() {
        lookups_per_cycle = 4;
        fragment_fifo = 128;
    }

    // What every cache has.
    CacheConfig cache() const { return {*this, *this}; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        TexelCacheShape::visit(self, field);
        CachePace::visit(self, field);
        field("bilinear_quads_per_cycle",
              self.bilinear_quads_per_cycle,
              {.unit = "quads/cycle",
               .minimum = 1,
               .maximum = 16,
               .meaning =
                   "filtered by the units of a fragment pipe together; trilinear takes twice "
                   "as long"});
    }
};

struct DepthCacheConfig : CacheConfig {
    static constexpr std::string_view Name = "depth_cache";
};

struct ColorCacheConfig : CacheConfig {
    static constexpr std::string_view Name = "color_cache";
};

enum class Distribution : std::uint8_t { Tiles, Scanlines };
inline constexpr std::array<std::string_view, 2> DistributionNames{"tiles", "scanlines"};

struct FragmentConfig {
    static constexpr std::string_view Name = "fragment";
    Distribution distribution = Distribution::Tiles;
    std::uint32_t distribution_width = 8;
    std::uint32_t pipe_queue = 32;
    std::uint32_t combiner_cycles = 1;
    std::uint32_t latency = 12;
    std::uint32_t queue = 64;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("distribution",
              self.distribution,
              {.meaning = "of quads to the raster.quads_per_cycle fragment pipes: squares on the "
                          "diagonal share a pipe, or bands of scan lines",
               .choices = DistributionNames});
        field("distribution_width",
              self.distribution_width,
              {.unit = "pixels",
               .minimum = 2,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of such a square or band"});
        field("pipe_queue",
              self.pipe_queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "before each pipe's texture unit and its environments"});
        field("combiner_cycles",
              self.combiner_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 64,
               .meaning = "a quad and enabled texture environment"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of the environments and fog"});
        field("queue",
              self.queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between the stages of the fragment pipe"});
    }
};

struct TimingConfig {
    CommandProcessorConfig command_processor;
    VertexConfig vertex;
    SetupConfig setup;
    RasterConfig raster;
    TexelCacheConfig texel_cache;
    DepthCacheConfig depth_cache;
    ColorCacheConfig color_cache;
    FragmentConfig fragment;
    MemoryConfig memory;

    // The part that work's order and places depend on.
    work::WorkConfig work() const {
        return {.raster = raster,
                .texel_cache = texel_cache,
                .depth_cache = depth_cache,
                .color_cache = color_cache};
    }

    // Calls group(name, group) for each; then Group::visit names its fields.
    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& group) {
        const auto each = [&](auto& member) {
            group(std::remove_cvref_t<decltype(member)>::Name, member);
        };
        each(self.command_processor);
        each(self.vertex);
        each(self.setup);
        each(self.raster);
        each(self.texel_cache);
        each(self.depth_cache);
        each(self.color_cache);
        each(self.fragment);
        each(self.memory);
    }
};

} // namespace ffgpu::timing
