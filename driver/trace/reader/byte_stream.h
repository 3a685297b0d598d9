// ByteStream: a cursor over a container's chunks that reads apitrace's elementary encodings. Two
// chunks are never needed at once: what straddles a boundary is copied.

#pragma once

#include "driver/trace/reader/container.h"
#include "driver/trace/reader/damage.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace ffgpu::trace {

class ByteStream {
public:
    explicit ByteStream(std::unique_ptr<Container> container)
        : container_(std::move(container)) {}

    bool at_end() { return at_ == end_ && !next_chunk(); }

    // Bytes of the uncompressed stream before the cursor.
    std::uint64_t position() const {
        return chunk_start_ + static_cast<std::uint64_t>(at_ - chunk_.data());
    }

    std::uint8_t byte() {
        if (at_ == end_) [[unlikely]]
            need_chunk();
        return std::to_integer<std::uint8_t>(*at_++);
    }

    // Little-endian base 128: seven bits a byte, low ones first, the top bit on all but the last.
    std::uint64_t uint() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const std::uint8_t part = byte();
            value |= std::uint64_t{part & 0x7fu} << shift;
            if ((part & 0x80) == 0) [[likely]]
                return value;
        }
        throw Damage{"expected an integer of at most 10 bytes"};
    }

    float float32() { return std::bit_cast<float>(little_endian<std::uint32_t>()); }
    double float64() { return std::bit_cast<double>(little_endian<std::uint64_t>()); }

    // Appends `count` bytes to `to`. Memory grows with the bytes that are there, not with `count`.
    template <class Buffer>
    void append(Buffer& to, std::uint64_t count) {
        while (count > 0) {
            if (at_ == end_) need_chunk();
            const std::size_t part = std::min<std::uint64_t>(count, left());
            to.append(at_, part);
            at_ += part;
            count -= part;
        }
    }

    void rewind();

private:
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

    template <class Unsigned>
    Unsigned little_endian() {
        static_assert(std::endian::native == std::endian::little);
        Unsigned value;
        if (left() >= sizeof value) [[likely]] {
            std::memcpy(&value, at_, sizeof value);
            at_ += sizeof value;
            return value;
        }
        value = 0;
        for (unsigned i = 0; i < sizeof value; ++i)
            value |= Unsigned{byte()} << (8 * i);
        return value;
    }

    bool next_chunk();
    void need_chunk();

    std::unique_ptr<Container> container_;
    std::vector<std::byte> chunk_;
    const std::byte* at_ = nullptr;
    const std::byte* end_ = nullptr;
    std::uint64_t chunk_start_ = 0;
};

} // namespace ffgpu::trace
