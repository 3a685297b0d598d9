// The configuration of scan-out.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct ScanOutConfig {
    static constexpr std::string_view Name = "scan_out";
    std::uint32_t refresh_cycles = 0;
    std::uint32_t line_bytes = 64;
    std::uint32_t queue = 16;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("refresh_cycles",
              self.refresh_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1'000'000'000,
               .meaning = "in which the screen reads the shown surface once, evenly; 0: no "
                          "scan-out"});
        field("line_bytes",
              self.line_bytes,
              {.unit = "bytes",
               .minimum = 16,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of a memory access"});
        field("queue",
              self.queue,
              {.unit = "lines",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "asked for and not yet come"});
    }
};

} // namespace ffgpu::timing
