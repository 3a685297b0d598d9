// The configuration of the memory controller and of the DRAM behind it.

#pragma once

#include "model/base/parameters.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

enum class PagePolicy : std::uint8_t { Open, Closed };
inline constexpr std::array<std::string_view, 2> PagePolicyNames{"open", "closed"};

struct MemoryConfig {
    static constexpr std::string_view Name = "memory";
    std::uint32_t channels = 2;
    std::uint32_t banks = 4;
    std::uint32_t row_bytes = 2048;
    std::uint32_t interleave_bytes = 256;
    std::uint32_t bytes_per_cycle = 8;
    std::uint32_t queue = 16;
    PagePolicy page_policy = PagePolicy::Open;
    std::uint32_t row_to_column_cycles = 4;
    std::uint32_t column_cycles = 4;
    std::uint32_t precharge_cycles = 4;
    std::uint32_t turnaround_cycles = 3;
    std::uint32_t latency = 20;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("channels",
              self.channels,
              {.unit = "channels",
               .minimum = 1,
               .maximum = 16,
               .power_of_two = true,
               .meaning = "independent buses"});
        field("banks",
              self.banks,
              {.unit = "banks",
               .minimum = 1,
               .maximum = 64,
               .power_of_two = true,
               .meaning = "a channel"});
        field("row_bytes",
              self.row_bytes,
              {.unit = "bytes",
               .minimum = 256,
               .maximum = 65536,
               .power_of_two = true,
               .meaning = "of an open row"});
        field("interleave_bytes",
              self.interleave_bytes,
              {.unit = "bytes",
               .minimum = 64,
               .maximum = 65536,
               .power_of_two = true,
               .meaning = "before the next channel"});
        field("bytes_per_cycle",
              self.bytes_per_cycle,
              {.unit = "bytes/cycle",
               .minimum = 1,
               .maximum = 256,
               .power_of_two = true,
               .meaning = "of a channel's bus"});
        field(
            "queue",
            self.queue,
            {.unit = "requests", .minimum = 1, .maximum = 1024, .meaning = "waiting at a channel"});
        field("page_policy",
              self.page_policy,
              {.meaning = "rows after an access", .choices = PagePolicyNames});
        field("row_to_column_cycles",
              self.row_to_column_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 256,
               .meaning = "activate to column (tRCD)"});
        field("column_cycles",
              self.column_cycles,
              {.unit = "cycles", .minimum = 0, .maximum = 256, .meaning = "column to data (CL)"});
        field("precharge_cycles",
              self.precharge_cycles,
              {.unit = "cycles", .minimum = 0, .maximum = 256, .meaning = "to close a row (tRP)"});
        field("turnaround_cycles",
              self.turnaround_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 256,
               .meaning = "bus idle between read and write"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of the way to and from the controller"});
    }
};

} // namespace ffgpu::timing
