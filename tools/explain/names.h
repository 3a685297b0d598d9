// Names of the contract's values in histories.

#pragma once

#include "model/device/enumerators.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace ffgpu::tools {

// "SourceAlpha"
template <class Enum>
std::string_view name_of(Enum value) {
    const auto at = static_cast<std::size_t>(value);
    return at < EnumeratorCount<Enum> ? EnumeratorNames<Enum>[at] : std::string_view("?");
}

// Of a texel's axes, and of texture coordinates.
constexpr std::string_view CoordinateNames[] = {"s", "t", "r", "q"};

} // namespace ffgpu::tools
