// The configuration of vertex fetch and geometry.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

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

} // namespace ffgpu::timing
