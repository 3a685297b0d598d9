// The configuration of the machine's clock: cycles are counted whatever it is; reports make
// milliseconds of them.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct ClockConfig {
    static constexpr std::string_view Name = "clock";
    std::uint32_t core_mhz = 200;

    double milliseconds(std::uint64_t cycles) const {
        return static_cast<double>(cycles) / (1000.0 * core_mhz);
    }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("core_mhz",
              self.core_mhz,
              {.unit = "MHz",
               .minimum = 1,
               .maximum = 10000,
               .meaning = "of the machine; the memory's is memory.memory_clocks / "
                          "memory.core_clocks of it"});
    }
};

} // namespace ffgpu::timing
