// The configuration of the fragment pipes.

#pragma once

#include "model/base/parameters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

enum class Distribution : std::uint8_t { Tiles, Scanlines, Triangles };
inline constexpr std::array<std::string_view, 3> DistributionNames{
    "tiles", "scanlines", "triangles"};

struct FragmentConfig {
    static constexpr std::string_view Name = "fragment";
    Distribution distribution = Distribution::Tiles;
    std::uint32_t distribution_width = 8;
    std::uint32_t pipe_queue = 32;
    std::uint32_t quad_cycles = 1;
    std::uint32_t combiners = 1;
    std::uint32_t combiner_cycles = 1;
    std::uint32_t entry_cycles = 0;
    std::uint32_t latency = 12;
    std::uint32_t queue = 64;

    // That a quad with so many enabled environments takes its pipe.
    std::uint32_t cycles(std::uint32_t environments) const {
        const std::uint32_t rounds = (environments + combiners - 1) / combiners;
        return std::max(quad_cycles, entry_cycles + rounds * combiner_cycles);
    }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("distribution",
              self.distribution,
              {.meaning =
                   "of quads to the raster.quads_per_cycle fragment pipes: squares, of which "
                   "neighbours go to different pipes; bands of scan lines; or primitives "
                   "take turns, and quads leave in the order in which they came",
               .choices = DistributionNames});
        field("distribution_width",
              self.distribution_width,
              {.unit = "pixels",
               .minimum = 2,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of such a square or band"});
        field("pipe_queue",
              self.pipe_queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "before each pipe's texture unit and its environments"});
        field("quad_cycles",
              self.quad_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 64,
               .meaning = "that a quad takes its pipe at least: 4 for one pixel a cycle"});
        field("combiners",
              self.combiners,
              {.unit = "environments",
               .minimum = 1,
               .maximum = 8,
               .meaning = "of a pipe, side by side"});
        field("combiner_cycles",
              self.combiner_cycles,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 64,
               .meaning = "a quad and enabled texture environment of each of them"});
        field("entry_cycles",
              self.entry_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "more a quad, which leaves at the end of its cycles; 0: at their begin"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of the environments and fog"});
        field("queue",
              self.queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "between the stages of the fragment pipe"});
    }
};

} // namespace ffgpu::timing
