// Configuration: all that a user can set about the machine, as one tree of named parameters.

#pragma once

#include "driver/objects/control_panel.h"
#include "model/base/parameters.h"
#include "model/timing/config.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::tools {

// How the functional GPU and its driver work. Threads and tiles change speed, never a pixel; the
// others are a control panel, which forces them on the program.
struct GpuParameters {
    static constexpr std::string_view Name = "gpu";
    std::uint32_t threads = 0;
    std::uint32_t tile_size = 0;
    gl::ForcedFilter texture_filter = gl::ForcedFilter::AsAsked;
    std::uint32_t supersampling = 1;

    gl::ControlPanel panel() const { return {texture_filter, supersampling}; }
    bool forces() const { return panel() != gl::ControlPanel{}; }

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
               .or_zero = true,
               .meaning = "side of the squares that are drawn one by one; 0: 64, of large targets "
                          "128"});
        field("texture_filter",
              self.texture_filter,
              {.meaning = "of GL_FFGPU_texture_filter, forced on each texture whose minification "
                          "filter is not GL_NEAREST; as_asked: the program decides",
               .choices = gl::ForcedFilterNames});
        field("supersampling",
              self.supersampling,
              {.unit = "samples",
               .minimum = 1,
               .maximum = gl::MaxSupersampling,
               .power_of_two = true,
               .meaning = "of a pixel of every window, each drawn and shaded for itself, then "
                          "averaged"});
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
