// LineMask: which bytes of a cache line, a bit each. Lines of more than 64 bytes have a bit for
// each sixty-fourth of a line.

#pragma once

#include "model/base/powers_of_two.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace ffgpu::work {

using LineMask = std::uint64_t;
inline constexpr std::uint32_t LineMaskBits = 64;

// Of a line: the bits of which a byte is written, and those of which all bytes are.
struct WrittenBytes {
    LineMask touched = 0;
    LineMask covered = 0;

    void operator|=(const WrittenBytes& other) {
        touched |= other.touched;
        covered |= other.covered;
    }
    bool operator==(const WrittenBytes&) const = default;
};

class LineGrain {
public:
    explicit LineGrain(std::uint32_t line_bytes)
        : line_bytes_(line_bytes)
        , grain_(std::max(line_bytes / LineMaskBits, 1u))
        , all_(ones(line_bytes / grain_)) {}

    std::uint32_t line_bytes() const { return line_bytes_; }
    // Bytes a bit.
    std::uint32_t bytes() const { return grain_; }
    LineMask all() const { return all_; }

    // Bits of which a byte lies in [begin, end), offsets within a line.
    LineMask touched(std::uint32_t begin, std::uint32_t end) const {
        return ones(quotient(end + grain_ - 1, grain_)) & ~ones(quotient(begin, grain_));
    }
    // Bits of which all bytes lie in [begin, end).
    LineMask covered(std::uint32_t begin, std::uint32_t end) const {
        return ones(quotient(end, grain_)) & ~ones(quotient(begin + grain_ - 1, grain_));
    }

    std::uint32_t count_bytes(LineMask mask) const {
        return static_cast<std::uint32_t>(std::popcount(mask)) * grain_;
    }
    // Bytes of the aligned pieces of `piece` bytes, a power of two, that hold a bit of the mask.
    std::uint32_t moved_bytes(LineMask mask, std::uint32_t piece) const {
        if (mask == all_) return line_bytes_;
        const std::uint32_t bits = std::clamp(piece / grain_, 1u, line_bytes_ / grain_);
        const LineMask one = ones(bits);
        std::uint32_t bytes = 0;
        for (std::uint32_t at = 0; at < line_bytes_ / grain_; at += bits)
            bytes += (mask >> at & one) != 0 ? bits * grain_ : 0;
        return bytes;
    }

private:
    static LineMask ones(std::uint32_t bits) {
        return bits >= LineMaskBits ? ~LineMask{0} : (LineMask{1} << bits) - 1;
    }

    std::uint32_t line_bytes_;
    std::uint32_t grain_;
    LineMask all_;
};

} // namespace ffgpu::work
