// Whether the machine finds out what it waited for. It decides no other figure.

#pragma once

#include "model/base/parameters.h"

#include <string_view>

namespace ffgpu::timing {

struct BottlenecksConfig {
    static constexpr std::string_view Name = "bottlenecks";
    bool enable = true;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("enable",
              self.enable,
              {.meaning = "of each command and frame, what it waited for and what it would gain; "
                          "off: all of that is 0, and the machine takes less time"});
    }
};

} // namespace ffgpu::timing
