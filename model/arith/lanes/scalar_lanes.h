// One lane: the arithmetic of a stage in plain C++. It is the specification;
// highway_lanes.inl gives the same operations over vectors, with the same bits in each lane.
//
// A stage written once over Floats, Integers and Mask is included twice, with FFGPU_LANES the
// namespace: scalar_lanes in X.cpp, HWY_NAMESPACE between HWY_BEFORE_NAMESPACE and
// HWY_AFTER_NAMESPACE in X_simd.cpp.

#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace ffgpu::scalar_lanes {

constexpr unsigned LaneCount = 1;

struct Floats {
    float value;
};
struct Integers {
    std::int32_t value;
};
struct Mask {
    bool value;
};

inline Floats splat(float x) {
    return {x};
}
inline Integers splat_integer(std::int32_t x) {
    return {x};
}
inline Floats load(const float* from) {
    return {*from};
}
inline void store(Floats x, float* to) {
    *to = x.value;
}
inline void store_integers(Integers x, std::uint32_t* to) {
    *to = static_cast<std::uint32_t>(x.value);
}

inline Floats operator+(Floats a, Floats b) {
    return {a.value + b.value};
}
inline Floats operator-(Floats a, Floats b) {
    return {a.value - b.value};
}
inline Floats operator*(Floats a, Floats b) {
    return {a.value * b.value};
}
inline Floats operator/(Floats a, Floats b) {
    return {a.value / b.value};
}
inline Floats negate(Floats a) {
    return {-a.value};
}
inline Floats square_root(Floats a) {
    return {std::sqrt(a.value)};
}
inline Floats absolute(Floats a) {
    return {std::fabs(a.value)};
}

// With a NaN on either side: the second one.
inline Floats minimum(Floats a, Floats b) {
    return {a.value < b.value ? a.value : b.value};
}
inline Floats maximum(Floats a, Floats b) {
    return {a.value > b.value ? a.value : b.value};
}

inline Mask operator<(Floats a, Floats b) {
    return {a.value < b.value};
}
inline Mask operator>(Floats a, Floats b) {
    return {a.value > b.value};
}
inline Mask operator>=(Floats a, Floats b) {
    return {a.value >= b.value};
}
inline Mask operator==(Floats a, Floats b) {
    return {a.value == b.value};
}
inline Mask operator&(Mask a, Mask b) {
    return {a.value && b.value};
}
inline Mask operator|(Mask a, Mask b) {
    return {a.value || b.value};
}
inline Mask operator!(Mask a) {
    return {!a.value};
}
inline bool any(Mask a) {
    return a.value;
}

inline Floats select(Mask mask, Floats yes, Floats no) {
    return mask.value ? yes : no;
}
inline Floats zero_unless(Mask mask, Floats yes) {
    return mask.value ? yes : Floats{0.0f};
}
inline Integers zero_unless(Mask mask, Integers yes) {
    return mask.value ? yes : Integers{0};
}

inline Integers operator+(Integers a, Integers b) {
    return {a.value + b.value};
}
inline Integers operator-(Integers a, Integers b) {
    return {a.value - b.value};
}
inline Integers operator&(Integers a, Integers b) {
    return {a.value & b.value};
}
inline Integers operator|(Integers a, Integers b) {
    return {a.value | b.value};
}
template <int Bits>
Integers shift_left(Integers a) {
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(a.value) << Bits)};
}
template <int Bits>
Integers shift_right(Integers a) {
    return {a.value >> Bits};
}

inline Integers bits_of(Floats a) {
    return {std::bit_cast<std::int32_t>(a.value)};
}
inline Floats from_bits(Integers a) {
    return {std::bit_cast<float>(a.value)};
}
inline Floats to_floats(Integers a) {
    return {static_cast<float>(a.value)};
}
inline Floats gather(const float* table, Integers at) {
    return {table[at.value]};
}

// Four planes, from lane `first` on, become four words in each of LaneCount rows.
inline void store_rows(const std::array<const float*, 4>& planes, std::byte* row, std::size_t) {
    for (unsigned word = 0; word < 4; ++word)
        std::memcpy(row + 4 * word, planes[word], 4);
}

} // namespace ffgpu::scalar_lanes
