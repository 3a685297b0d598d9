// The configuration of the interpolator of attributes: a unit of its own, or none.

#pragma once

#include "model/base/parameters.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

struct InterpolatorConfig {
    static constexpr std::string_view Name = "interpolator";
    std::uint32_t value_cycles = 0;
    std::uint32_t divide_latency = 1;
    std::uint32_t divide_queue = 8;
    std::uint32_t latency = 1;
    std::uint32_t value_places = 0;

    bool is_on() const { return value_cycles > 0; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("value_cycles",
              self.value_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "a quad and attribute that varies over its primitive, and for w where "
                          "that has perspective; 0: attributes take no time, and there is no such "
                          "unit"});
        field("divide_latency",
              self.divide_latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "of w and 1/q, before a quad's first attribute, where there are any"});
        field("divide_queue",
              self.divide_queue,
              {.unit = "quads",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "whose divisors are made ahead of their attributes"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "from a quad's last attribute to the next unit"});
        field("value_places",
              self.value_places,
              {.unit = "values",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of all quads on their way there; the first one's are collected, but "
                          "for the last, and take none; 0: as many as the quads have"});
    }
};

} // namespace ffgpu::timing
