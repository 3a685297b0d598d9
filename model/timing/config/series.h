// The configuration of the series: the machine's accounts over time. It decides no other figure.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct SeriesConfig {
    static constexpr std::string_view Name = "series";
    std::uint32_t interval_cycles = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("interval_cycles",
              self.interval_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1'000'000'000,
               .meaning = "of a row of series.csv, which holds what every account counted in "
                          "them; 0: no series"});
    }
};

} // namespace ffgpu::timing
