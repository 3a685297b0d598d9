// Parameters: how a configuration describes itself.
//
// A group of parameters is a plain struct whose member initialisers are the defaults. Its visit()
// names each field once, with unit, range and meaning; the TOML reader, `ffgpu config`, the checks
// and the copy of the configuration in every result loop over it.
//
//     template <class Self, class Visitor> static void visit(Self& self, Visitor&& field) {
//         field("ways", self.ways, {.unit = "ways", .minimum = 1, .maximum = 64, .meaning =
//         "..."});
//     }

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ffgpu {

struct ParameterInfo {
    std::string_view unit{};
    std::int64_t minimum = 0;
    std::int64_t maximum = 0;
    bool power_of_two = false;
    bool or_zero = false; // beside that range
    std::string_view meaning{};
    std::span<const std::string_view> choices = {}; // not empty: an enumeration, value = index
};

} // namespace ffgpu
