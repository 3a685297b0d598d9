// Seal: a hash over results, which ties them to the version that docs/arithmetic.md states.

#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace ffgpu::test {

// 64-bit FNV-1a.
struct Seal {
    std::uint64_t hash = 0xcbf29ce484222325;

    void add(std::uint64_t value) {
        for (int i = 0; i < 8; ++i)
            hash = (hash ^ (value >> (8 * i) & 0xff)) * 0x100000001b3;
    }
    void add(float value) { add(std::uint64_t{std::bit_cast<std::uint32_t>(value)}); }

    std::string text() const {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
        return digits;
    }
};

inline std::string arithmetic_page() {
    std::ifstream file(std::string(FFGPU_SOURCE_DIR) + "/docs/arithmetic.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace ffgpu::test
