// Division by powers of two that are known at run time only: a shift instead of tens of cycles.

#pragma once

#include <bit>
#include <concepts>
#include <type_traits>

namespace ffgpu {

template <std::unsigned_integral T>
constexpr T quotient(T value, std::type_identity_t<T> power_of_two) {
    return value >> std::countr_zero(power_of_two);
}

template <std::unsigned_integral T>
constexpr T remainder(T value, std::type_identity_t<T> power_of_two) {
    return value & (power_of_two - 1);
}

} // namespace ffgpu
