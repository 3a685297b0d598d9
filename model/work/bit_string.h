// A string of bits, the lowest of a byte first: what compressed blocks are written as.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ffgpu::work {

class BitWriter {
public:
    // The lowest `count` bits of value, up to 32.
    void put(std::uint32_t value, unsigned count) {
        for (unsigned i = 0; i < count; ++i, ++bits_) {
            if (bits_ % 8 == 0) bytes_.push_back(0);
            bytes_.back() =
                static_cast<std::uint8_t>(bytes_.back() | (value >> i & 1) << bits_ % 8);
        }
    }
    void append(const BitWriter& other) {
        for (std::size_t i = 0; i < other.bits_; ++i)
            put(other.bytes_[i / 8] >> i % 8 & 1u, 1);
    }
    std::size_t bits() const { return bits_; }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<std::uint8_t> bytes_;
    std::size_t bits_ = 0;
};

// Behind the end there are zeros.
class BitReader {
public:
    explicit BitReader(std::span<const std::uint8_t> bytes)
        : bytes_(bytes) {}

    std::uint32_t get(unsigned count) {
        std::uint32_t value = 0;
        for (unsigned i = 0; i < count; ++i, ++at_)
            if (at_ / 8 < bytes_.size())
                value |= std::uint32_t{bytes_[at_ / 8] >> at_ % 8 & 1u} << i;
        return value;
    }
    std::int32_t get_signed(unsigned count) {
        if (count == 0) return 0;
        const unsigned spare = 32 - count;
        return static_cast<std::int32_t>(get(count) << spare) >> spare;
    }

private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

} // namespace ffgpu::work
