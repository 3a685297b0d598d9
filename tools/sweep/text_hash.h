// Names for contents, and random numbers that are the same everywhere.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace ffgpu::tools {

constexpr std::uint64_t HashStart = 0xcbf29ce484222325; // 64-bit FNV-1a

inline std::uint64_t hash_on(std::uint64_t hash, std::string_view text) {
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
}

inline std::string text_hash(std::string_view text) {
    return fmt::format("{:016x}", hash_on(HashStart, text));
}

// SplitMix64 (S. Vigna).
class RawRandom {
public:
    explicit RawRandom(std::uint64_t seed)
        : state_(seed) {}

    std::uint64_t below(std::uint64_t limit) { return next() % limit; }

private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

} // namespace ffgpu::tools
