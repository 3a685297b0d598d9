// The columns of a block while it is written, and while it is read: numbers as bytes, seven bits
// each, the lowest first; signed ones as 0, -1, 1, -2 ...

#pragma once

#include "model/work/work_file_format.h"

#include <array>
#include <cstdint>
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

class ColumnWriter {
public:
    void byte(Column column, std::uint8_t value) { of(column).push_back(value); }
    void number(Column column, std::uint64_t value) {
        std::vector<std::uint8_t>& bytes = of(column);
        for (; value >= 0x80; value >>= 7)
            bytes.push_back(static_cast<std::uint8_t>(value | 0x80));
        bytes.push_back(static_cast<std::uint8_t>(value));
    }
    void difference(Column column, std::int64_t value) { number(column, zigzag(value)); }
    void text(Column column, std::string_view value) {
        number(column, value.size());
        of(column).insert(of(column).end(), value.begin(), value.end());
    }

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const auto& column : columns_)
            sum += column.size();
        return sum;
    }
    std::vector<std::uint8_t>& of(Column column) {
        return columns_[static_cast<std::size_t>(column)];
    }
    void clear() {
        for (auto& column : columns_)
            column.clear();
    }

private:
    std::array<std::vector<std::uint8_t>, ColumnCount> columns_;
};

// A block's numbers make no sense.
class DamagedItem : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Throws DamagedItem where a column ends too early or a number is beyond its range.
class ColumnReader {
public:
    void set(Column column, std::span<const std::uint8_t> bytes) {
        columns_[static_cast<std::size_t>(column)] = bytes;
    }

    std::uint8_t byte(Column column) {
        std::span<const std::uint8_t>& bytes = columns_[static_cast<std::size_t>(column)];
        if (bytes.empty()) throw DamagedItem("a block's numbers end too early");
        const std::uint8_t value = bytes[0];
        bytes = bytes.subspan(1);
        return value;
    }
    std::uint64_t number(Column column) {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const std::uint8_t part = byte(column);
            value |= std::uint64_t{part & 0x7fu} << shift;
            if (part < 0x80) return value;
        }
        throw DamagedItem("a number is longer than 64 bits");
    }
    // Not above `most`.
    std::uint64_t number(Column column, std::uint64_t most) {
        const std::uint64_t value = number(column);
        if (value > most) throw DamagedItem("a number is beyond its range");
        return value;
    }
    std::uint32_t word(Column column) {
        return static_cast<std::uint32_t>(number(column, 0xffffffff));
    }
    std::int64_t difference(Column column) { return unzigzag(number(column)); }
    std::string text(Column column, std::size_t longest) {
        std::string value(number(column, longest), '\0');
        for (char& letter : value)
            letter = static_cast<char>(byte(column));
        return value;
    }
    bool at_end() const {
        for (const auto& column : columns_)
            if (!column.empty()) return false;
        return true;
    }

private:
    std::array<std::span<const std::uint8_t>, ColumnCount> columns_{};
};

} // namespace ffgpu::work
