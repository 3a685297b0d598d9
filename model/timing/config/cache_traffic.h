// The configuration of what a cache does in a cycle, and of how it talks to memory.

#pragma once

#include "model/base/parameters.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

// What a write does that misses (N. P. Jouppi, Cache Write Policies and Performance, ISCA 1993).
enum class WriteMiss : std::uint8_t { WriteValidate, FetchOnWrite };
inline constexpr std::array<std::string_view, 2> WriteMissNames{"write_validate", "fetch_on_write"};

struct CacheQueuesConfig {
    std::uint32_t banks = 1;
    std::uint32_t ports = 0;
    std::uint32_t request_queue = 16;
    std::uint32_t miss_queue = 1;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("banks",
              self.banks,
              {.unit = "banks",
               .minimum = 1,
               .maximum = 64,
               .power_of_two = true,
               .meaning = "of tags and data: line number modulo banks"});
        field("ports",
              self.ports,
              {.unit = "lines/cycle",
               .minimum = 0,
               .maximum = 64,
               .meaning = "look-ups that a bank serves in a cycle; 0: all"});
        field("request_queue",
              self.request_queue,
              {.unit = "requests",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "on their way to the memory's arbiter"});
        field("miss_queue",
              self.miss_queue,
              {.unit = "misses",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "whose requests wait for the request queue"});
    }
};

struct CacheTrafficConfig : CacheQueuesConfig {
    WriteMiss write_miss = WriteMiss::WriteValidate;
    std::uint32_t transfer_bytes = 4;

    template <class Self, class Visitor>
    static void visit_writes(Self& self, Visitor&& field) {
        field("write_miss",
              self.write_miss,
              {.meaning = "a write to an absent line: write_validate marks the written bytes as "
                          "valid; fetch_on_write fetches a line that is not wholly written",
               .choices = WriteMissNames});
        field("transfer_bytes",
              self.transfer_bytes,
              {.unit = "bytes",
               .minimum = 1,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "pieces of a line that a masked write moves"});
    }
};

} // namespace ffgpu::timing
