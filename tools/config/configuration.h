// Configuration: all that a user can set about the machine, as one tree of named parameters.

#pragma once

#include "model/base/parameters.h"
#include "model/timing/config.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::tools {

// How the functional GPU works. It changes speed, never a pixel.
struct GpuParameters {
    static constexpr std::string_view Name = "gpu";
    std::uint32_t threads = 0;
    std::uint32_t tile_size = 64;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("threads",
              self.threads,
              {.unit = "threads",
               .minimum = 0,
               .maximum = 256,
               .meaning = "that draw; 0: one a processor of the host"});
        field("tile_size",
              self.tile_size,
              {.unit = "pixels",
               .minimum = 16,
               .maximum = 128,
               .power_of_two = true,
               .meaning = "side of the squares that are drawn one by one"});
    }
};

struct Configuration {
    GpuParameters gpu;
    timing::TimingConfig timing;

    // Calls group(name, group) for each group of parameters.
    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& group) {
        group(GpuParameters::Name, self.gpu);
        timing::TimingConfig::visit(self.timing, group);
    }
};

} // namespace ffgpu::tools
