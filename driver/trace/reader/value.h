// Value: one argument or result of a traced call. A call keeps all of its values in one array, in
// pre-order: an array's elements follow it at once. So a call of any shape costs no allocation
// once the array has grown.

#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace ffgpu::trace {

enum class ValueKind : std::uint8_t {
    Null,
    Bool,
    Signed,
    Unsigned,
    Real,       // float and double
    String,     // Call::text()
    Blob,       // Call::blob()
    Enum,       // a number of 64 bits, with sign
    Bitmask,    // a number
    Array,      // elements follow
    Struct,     // members follow
    Pointer,    // an address in the traced program, or an offset into a buffer object
    Repr,       // two values follow: one for humans, one for machines
    WideString, // read and dropped: OpenGL has none
    Numbers,    // was an Array: numbers as its command reads them stand where its elements stood
};

struct Value {
    ValueKind kind = ValueKind::Null;
    std::uint32_t extent = 1; // Values in this one's tree, itself included.
    // The number; the element count; how many bytes of Numbers; or where the text or blob is.
    std::uint64_t bits = 0;

    bool is_null() const { return kind == ValueKind::Null; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(bits); } // Array, Struct
    double real() const { return std::bit_cast<double>(bits); }              // Real
};

// The number a value stands for, as a GL function's parameter of type `Number` gets it; what is
// no number is 0. A real number is clamped to an integer's range, and NaN is 0.
template <class Number>
Number to_number(const Value& value) {
    switch (value.kind) {
    case ValueKind::Real:
        if constexpr (std::is_floating_point_v<Number>) {
            return static_cast<Number>(value.real());
        } else {
            constexpr double Low = static_cast<double>(std::numeric_limits<Number>::min());
            constexpr double High = static_cast<double>(std::numeric_limits<Number>::max());
            const double real = std::isnan(value.real()) ? 0 : value.real();
            if (real <= Low) return std::numeric_limits<Number>::min();
            if (real >= High) return std::numeric_limits<Number>::max();
            return static_cast<Number>(real);
        }
    case ValueKind::Signed:
    case ValueKind::Enum:
        return static_cast<Number>(static_cast<std::int64_t>(value.bits));
    case ValueKind::Bool:
    case ValueKind::Unsigned:
    case ValueKind::Bitmask:
    case ValueKind::Pointer:
        return static_cast<Number>(value.bits);
    default:
        return Number{};
    }
}

} // namespace ffgpu::trace
