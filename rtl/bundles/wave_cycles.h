// The cycles of a Verilated module of which waves are written.

#pragma once

#include <cstdint>
#include <limits>

namespace ffgpu::rtl {

struct WaveCycles {
    std::uint64_t first = 0, last = std::numeric_limits<std::uint64_t>::max();

    bool has(std::uint64_t cycle) const { return cycle >= first && cycle <= last; }
};

} // namespace ffgpu::rtl
