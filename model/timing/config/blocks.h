// The configuration of the blocks of a target: states on the chip, fast clear, compression. A block
// is what a line of the target's cache holds.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct BlockConfig {
    bool fast_clear = false;
    bool compression = false;
    std::uint32_t on_chip = 0;
    std::uint32_t clears_per_cycle = 64;

    bool is_on() const { return fast_clear || compression; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("fast_clear",
              self.fast_clear,
              {.meaning = "a clear of whole blocks writes their states only"});
        field("compression",
              self.compression,
              {.meaning =
                   "blocks are written compressed, in whole bursts of the memory, where that "
                   "is less"});
        field("on_chip",
              self.on_chip,
              {.unit = "blocks",
               .minimum = 0,
               .maximum = 1 << 24,
               .meaning = "whose states the chip keeps, of the targets in the order of their first "
                          "use; others are never cleared fast or compressed. 0: all"});
        field("clears_per_cycle",
              self.clears_per_cycle,
              {.unit = "blocks/cycle",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "states that a fast clear writes"});
    }
};

struct DepthBlockConfig : BlockConfig {
    static constexpr std::string_view Name = "depth_blocks";
};

struct ColorBlockConfig : BlockConfig {
    static constexpr std::string_view Name = "color_blocks";
};

} // namespace ffgpu::timing
