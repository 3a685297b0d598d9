// The configuration of vertex fetch and geometry.

#pragma once

#include "model/base/parameters.h"
#include "model/timing/config/cache_traffic.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

// Which vertex the post-transform reuse gives up: the first that came, or the one not used for the
// longest time.
enum class ReusePolicy : std::uint8_t { Fifo, Lru };
inline constexpr std::array<std::string_view, 2> ReusePolicyNames{"fifo", "lru"};

// The queues are those of the caches of vertices and of indices, each.
struct VertexConfig : CacheQueuesConfig {
    static constexpr std::string_view Name = "vertex";
    std::uint32_t cache_sets = 16;
    std::uint32_t cache_ways = 4;
    std::uint32_t line_bytes = 64;
    std::uint32_t outstanding_lines = 64;
    std::uint32_t index_cache_lines = 4;
    std::uint32_t index_queue = 64;
    std::uint32_t fetch_queue = 16;
    std::uint32_t fetch_bytes_per_cycle = 32;
    std::uint32_t vertices_per_cycle = 1;
    std::uint32_t reuse_entries = 16;
    ReusePolicy reuse_policy = ReusePolicy::Fifo;
    std::uint32_t units = 1;
    std::uint32_t order_entries = 16;
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
               .meaning = "line of the vertex fetch cache, and of indices"});
        field("outstanding_lines",
              self.outstanding_lines,
              {.unit = "lines",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "fills of a cache of vertices or indices under way at once"});
        CacheQueuesConfig::visit(self, field);
        field("index_cache_lines",
              self.index_cache_lines,
              {.unit = "lines",
               .minimum = 0,
               .maximum = 64,
               .meaning = "cache of their own for indices; 0: they go through the vertex cache"});
        field("index_queue",
              self.index_queue,
              {.unit = "indices",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "asked for ahead of the vertices that they name"});
        field("fetch_queue",
              self.fetch_queue,
              {.unit = "vertices",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "vertices waiting for their data"});
        field("fetch_bytes_per_cycle",
              self.fetch_bytes_per_cycle,
              {.unit = "bytes/cycle",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of attributes from the vertex cache to the geometry units; 0: any "
                          "number"});
        field("vertices_per_cycle",
              self.vertices_per_cycle,
              {.unit = "vertices/cycle",
               .minimum = 1,
               .maximum = 16,
               .meaning = "indices, look-ups of lines, vertices sent to the geometry units and "
                          "vertices that leave them, each"});
        field("reuse_entries",
              self.reuse_entries,
              {.unit = "vertices",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "post-transform reuse within a draw; 0: none"});
        field("reuse_policy",
              self.reuse_policy,
              {.meaning = "which vertex it gives up", .choices = ReusePolicyNames});
        field("units",
              self.units,
              {.unit = "units",
               .minimum = 1,
               .maximum = 16,
               .meaning = "geometry units side by side, each with a vertex"});
        field("order_entries",
              self.order_entries,
              {.unit = "vertices",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "in the geometry units, or waiting there for their turn to leave; fewer "
                          "than vertex.units count as that many"});
        field("transform_cycles",
              self.transform_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of a geometry unit a vertex"});
        field("light_cycles",
              self.light_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1024,
               .meaning = "more for each enabled light"});
        field(
            "latency",
            self.latency,
            {.unit = "cycles", .minimum = 1, .maximum = 4096, .meaning = "of the geometry units"});
    }
};

} // namespace ffgpu::timing
