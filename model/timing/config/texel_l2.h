// The configuration of the second-level texel cache.

#pragma once

#include "model/base/parameters.h"
#include "model/timing/config/cache.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct TexelL2Config : work::CachePolicy, CacheQueuesConfig {
    static constexpr std::string_view Name = "texel_l2";
    bool enable = false;
    std::uint32_t sets = 256;
    std::uint32_t ways = 8;
    std::uint32_t line_bytes = 64;
    std::uint32_t lookups_per_cycle = 1;
    std::uint32_t queue = 64;
    std::uint32_t outstanding_lines = 64;
    std::uint32_t latency = 8;
    std::uint32_t bytes_per_cycle = 64;

    // What every cache has.
    CacheConfig cache() const {
        CacheConfig cache;
        cache.sets = sets;
        cache.ways = ways;
        cache.line_bytes = line_bytes;
        cache.outstanding_lines = outstanding_lines;
        static_cast<CachePolicy&>(cache) = *this;
        static_cast<CacheQueuesConfig&>(cache) = *this;
        return cache;
    }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("enable",
              self.enable,
              {.meaning = "a second-level cache that all first-level texel caches share; it holds "
                          "texels as they lie in memory"});
        field("sets",
              self.sets,
              {.unit = "sets",
               .minimum = 1,
               .maximum = 1 << 20,
               .power_of_two = true,
               .meaning = "1: fully associative"});
        field("ways",
              self.ways,
              {.unit = "ways", .minimum = 1, .maximum = 1 << 16, .meaning = "1: direct mapped"});
        field("line_bytes",
              self.line_bytes,
              {.unit = "bytes",
               .minimum = 16,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of a line; no less than texel_cache.line_bytes"});
        field("lookups_per_cycle",
              self.lookups_per_cycle,
              {.unit = "lines/cycle", .minimum = 1, .maximum = 64, .meaning = "tags compared"});
        field("queue",
              self.queue,
              {.unit = "requests",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "of each first-level cache, between tag check and data"});
        field("outstanding_lines",
              self.outstanding_lines,
              {.unit = "lines",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "fills under way at once"});
        visit_pace(self, field);
        CachePolicy::visit(self, field);
        CacheQueuesConfig::visit(self, field);
    }

private:
    template <class Self, class Visitor>
    static void visit_pace(Self& self, Visitor&& field) {
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of an answer, beside its look-up and its transfer"});
        field("bytes_per_cycle",
              self.bytes_per_cycle,
              {.unit = "bytes/cycle",
               .minimum = 1,
               .maximum = 512,
               .meaning = "of the link to each first-level cache"});
    }
};

} // namespace ffgpu::timing
