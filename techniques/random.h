// Random: the numbers that synthesis draws from. SplitMix64 (Steele, Lea and Flood 2014), so that a
// seed means the same texture with any compiler and standard library.

#pragma once

#include <cstdint>

namespace ffgpu::techniques {

class Random {
public:
    explicit Random(std::uint64_t seed)
        : state_(seed) {}

    // 64 random bits.
    std::uint64_t next() { return mix(state_ += Step); }
    // In [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    // In [low, high).
    double between(double low, double high) { return low + (high - low) * unit(); }
    // In [0, count), count > 0, by the remainder.
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

    // The generator's output function: a bijection of 64 bits that leaves no pattern behind.
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    static constexpr std::uint64_t Step = 0x9e3779b97f4a7c15u;

private:
    std::uint64_t state_;
};

} // namespace ffgpu::techniques
