// The configuration of the host's bus.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct HostConfig {
    static constexpr std::string_view Name = "host";
    std::uint32_t bytes_per_cycle = 8;
    std::uint32_t command_bytes = 32;
    std::uint32_t register_bytes = 8;
    std::uint32_t queue = 16;
    std::uint32_t burst_bytes = 64;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("bytes_per_cycle",
              self.bytes_per_cycle,
              {.unit = "bytes/cycle",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of the bus that carries commands, uploads and what the driver reads; 0: "
                          "any number"});
        field("command_bytes",
              self.command_bytes,
              {.unit = "bytes",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of a draw, an image, a clear, a copy, a read or the end of a frame"});
        field("register_bytes",
              self.register_bytes,
              {.unit = "bytes",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of a register write, beside the words that are written"});
        field("queue",
              self.queue,
              {.unit = "commands",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between the bus and the command processor"});
        field("burst_bytes",
              self.burst_bytes,
              {.unit = "bytes",
               .minimum = 16,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of a memory access of uploads, of the driver's reads and of images"});
    }
};

} // namespace ffgpu::timing
