// The configuration of the texel, depth and colour caches.

#pragma once

#include "model/base/parameters.h"
#include "model/timing/config/cache_traffic.h"
#include "model/work/cache_policy.h"
#include "model/work/config.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

using work::Layout;

// What a cache does in time, whatever its shape.
struct CachePace : work::CachePolicy, CacheTrafficConfig {
    std::uint32_t lookups_per_cycle = 1;
    std::uint32_t fragment_fifo = 64;
    std::uint32_t outstanding_lines = 64;

    // What a cache has that is only read.
    template <class Self, class Visitor>
    static void visit_reads(Self& self, Visitor&& field) {
        field("lookups_per_cycle",
              self.lookups_per_cycle,
              {.unit = "lines/cycle",
               .minimum = 1,
               .maximum = 64,
               .meaning = "tags compared a cycle, for each fragment pipe; texel cache: for each "
                          "of its texture units"});
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
        CacheQueuesConfig::visit(self, field);
    }
    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_reads(self, field);
        CacheTrafficConfig::visit_writes(self, field);
    }
};

// The caches of depth and colour.
struct CacheConfig : work::CacheShape, CachePace {
    bool enable = true;
    std::uint32_t store_cycles = 0;
    std::uint32_t expand_cycles = 0; // of a fill of expanded texels; texel caches alone have any

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        CacheShape::visit(self, field);
        CachePace::visit(self, field);
        field("enable",
              self.enable,
              {.meaning =
                   "off: no cache; each quad reads its pixels from memory and stores what it "
                   "changes; fragment_fifo quads are between the two, no two of one place"});
        field("store_cycles",
              self.store_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1024,
               .meaning = "no cache: from a quad's pixels to the memory's having taken its store"});
    }
};

struct TexelCacheConfig : work::TexelCacheShape, CachePace {
    static constexpr std::string_view Name = "texel_cache";
    std::uint32_t bilinear_quads_per_cycle = 1;
    bool per_pipe = false;
    std::uint32_t decompress_cycles = 0;
    bool forgets = false;

    TexelCacheConfig() {
        lookups_per_cycle = 4;
        fragment_fifo = 128;
    }

    // What every cache has.
    CacheConfig cache() const {
        CacheConfig cache{*this, *this};
        cache.expand_cycles = decompress_cycles;
        return cache;
    }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        TexelCacheShape::visit(self, field);
        CachePace::visit_reads(self, field);
        field("bilinear_quads_per_cycle",
              self.bilinear_quads_per_cycle,
              {.unit = "quads/cycle",
               .minimum = 1,
               .maximum = 16,
               .meaning = "filtered by each texture unit; trilinear takes twice as long"});
        field("per_pipe",
              self.per_pipe,
              {.meaning = "each fragment pipe has a texel cache of this size; else one is theirs "
                          "together"});
        field("decompress_cycles",
              self.decompress_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1024,
               .meaning = "latency of expanding a compressed block: at each read, or where lines "
                          "hold texels, when a line is filled"});
        field("forgets",
              self.forgets,
              {.meaning = "all lines at the first quad of another draw: with "
                          "command_processor.drains, what a driver does that does not know which "
                          "textures have changed"});
    }
};

struct DepthCacheConfig : CacheConfig {
    static constexpr std::string_view Name = "depth_cache";
    std::uint32_t latency = 1;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        CacheConfig::visit(self, field);
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "from late depth, which every quad passes, to colour"});
    }
};

struct ColorCacheConfig : CacheConfig {
    static constexpr std::string_view Name = "color_cache";
};

} // namespace ffgpu::timing
