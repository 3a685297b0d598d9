// The columns of a block while it is written, and while it is read: numbers as bytes, seven bits
// each, the lowest first; signed ones as 0, -1, 1, -2 ...

#pragma once

#include "model/work/work_file_format.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::work {

constexpr std::uint64_t zigzag(std::int64_t value) {
    return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}
constexpr std::int64_t unzigzag(std::uint64_t value) {
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
}

// Returns the end of what it writes: at most 10 bytes.
inline std::uint8_t* put_number(std::uint8_t* to, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7)
        *to++ = static_cast<std::uint8_t>(value | 0x80);
    *to++ = static_cast<std::uint8_t>(value);
    return to;
}

class ColumnWriter {
public:
    void byte(Column column, std::uint8_t value) {
        std::uint8_t* const to = room(column, 1);
        *to = value;
        written(column, to + 1);
    }
    void number(Column column, std::uint64_t value) {
        written(column, put_number(room(column, MostOfNumber), value));
    }
    void difference(Column column, std::int64_t value) { number(column, zigzag(value)); }
    void text(Column column, std::string_view value) {
        number(column, value.size());
        for (const char letter : value)
            byte(column, static_cast<std::uint8_t>(letter));
    }

    // The end of the column, with room for `count` bytes behind it; those up to written()'s `end`
    // belong to it then.
    std::uint8_t* room(Column column, std::size_t count) {
        Bytes& bytes = columns_[static_cast<std::size_t>(column)];
        if (bytes.room.size() - bytes.count < count)
            bytes.room.resize(std::max(2 * bytes.room.size(), bytes.count + count));
        return bytes.room.data() + bytes.count;
    }
    void written(Column column, const std::uint8_t* end) {
        Bytes& bytes = columns_[static_cast<std::size_t>(column)];
        bytes.count = static_cast<std::size_t>(end - bytes.room.data());
    }

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const Bytes& column : columns_)
            sum += column.count;
        return sum;
    }
    std::span<const std::uint8_t> of(Column column) const {
        const Bytes& bytes = columns_[static_cast<std::size_t>(column)];
        return std::span(bytes.room).first(bytes.count);
    }
    void clear() {
        for (Bytes& column : columns_)
            column.count = 0;
    }

private:
    static constexpr std::size_t MostOfNumber = 10;
    struct Bytes {
        std::vector<std::uint8_t> room;
        std::size_t count = 0;
    };
    std::array<Bytes, ColumnCount> columns_;
};

// The largest count that a file may tell.
constexpr std::uint64_t Most32 = std::numeric_limits<std::uint32_t>::max();

// `from + by` modulo 2^16: what a damaged file tells is checked where it is used.
constexpr std::uint16_t moved(std::uint16_t from, std::int64_t by) {
    return static_cast<std::uint16_t>(from + by);
}

// A block's numbers make no sense.
class DamagedItem : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Throws DamagedItem where a column ends too early or a number is beyond its range.
class ColumnReader {
public:
    void set(Column column, std::span<const std::uint8_t> bytes) {
        columns_[static_cast<std::size_t>(column)] = {bytes.data(), bytes.data() + bytes.size()};
    }

    std::uint8_t byte(Column column) {
        Bytes& bytes = columns_[static_cast<std::size_t>(column)];
        if (bytes.next == bytes.end) throw DamagedItem("a block's numbers end too early");
        return *bytes.next++;
    }
    std::uint64_t number(Column column) {
        const std::uint8_t first = byte(column);
        return first < 0x80 ? first : long_number(column, first); // Most are short.
    }
    // Not above `most`.
    std::uint64_t number(Column column, std::uint64_t most) {
        const std::uint64_t value = number(column);
        if (value > most) throw DamagedItem("a number is beyond its range");
        return value;
    }
    std::uint32_t word(Column column) { return static_cast<std::uint32_t>(number(column, Most32)); }
    std::int64_t difference(Column column) { return unzigzag(number(column)); }
    std::string text(Column column, std::size_t longest) {
        std::string value(number(column, longest), '\0');
        for (char& letter : value)
            letter = static_cast<char>(byte(column));
        return value;
    }
    bool at_end() const {
        for (const auto& column : columns_)
            if (column.next != column.end) return false;
        return true;
    }

private:
    struct Bytes {
        const std::uint8_t* next = nullptr;
        const std::uint8_t* end = nullptr;
    };

    // One of more bytes than the first.
    [[gnu::noinline]] std::uint64_t long_number(Column column, std::uint8_t first) {
        std::uint64_t value = first & 0x7fu;
        for (unsigned shift = 7; shift < 64; shift += 7) {
            const std::uint8_t part = byte(column);
            value |= std::uint64_t{part & 0x7fu} << shift;
            if (part < 0x80) return value;
        }
        throw DamagedItem("a number is longer than 64 bits");
    }

    std::array<Bytes, ColumnCount> columns_{};
};

} // namespace ffgpu::work
