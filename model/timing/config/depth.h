// The configuration of the depth unit: when depth is tested, and the coarse test before it.

#pragma once

#include "model/base/parameters.h"
#include "model/work/config.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct DepthConfig {
    static constexpr std::string_view Name = "depth";
    work::DepthTest test = work::DepthTest::AsGlAllows;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("test",
              self.test,
              {.meaning = "as_gl_allows: tested and written before texturing where nothing can see "
                          "the difference; early_where_exact: draws that may lose fragments later, "
                          "too, which are tested before and once more, and written, after "
                          "texturing; late: all after texturing",
               .choices = work::DepthTestNames});
    }
};

enum class CoarseDepth : std::uint8_t { Off, Max, MinMax };
inline constexpr std::array<std::string_view, 3> CoarseDepthNames{"off", "max", "min_max"};

struct HierarchicalDepthConfig {
    static constexpr std::string_view Name = "hierarchical_depth";
    CoarseDepth keeps = CoarseDepth::Off;
    bool accepts = false;
    std::uint32_t block_lines = 1;
    std::uint32_t depth_bits = 24;
    std::uint32_t tests_per_cycle = 1;

    bool is_on() const { return keeps != CoarseDepth::Off; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("keeps",
              self.keeps,
              {.meaning = "of each block: nothing; the greatest depth; the least, too",
               .choices = CoarseDepthNames});
        field("accepts",
              self.accepts,
              {.meaning = "what passes for certain is written without being read; min_max only"});
        field("block_lines",
              self.block_lines,
              {.unit = "lines",
               .minimum = 1,
               .maximum = 64,
               .power_of_two = true,
               .meaning = "of the depth cache that make a block, neighbours in memory"});
        field("depth_bits",
              self.depth_bits,
              {.unit = "bits",
               .minimum = 4,
               .maximum = 24,
               .meaning = "of a depth that is kept: the upper ones, the least rounded down and the "
                          "greatest up"});
        field("tests_per_cycle",
              self.tests_per_cycle,
              {.unit = "quads/cycle",
               .minimum = 1,
               .maximum = 64,
               .meaning = "for each fragment pipe"});
    }
};

} // namespace ffgpu::timing
