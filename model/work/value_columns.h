// Values in a work file's column: a quad's words as steps from the word before, the first from the
// first of the quad before; rows of a surface as bytes, or as equal to the row before.

#pragma once

#include "model/work/column_bytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

class ValueColumnWriter {
public:
    void words(ColumnWriter& out, std::span<const std::uint32_t> words) {
        out.number(Column::Values, words.size());
        std::uint32_t expected = first_;
        for (const std::uint32_t word : words) {
            out.difference(Column::Values, static_cast<std::int32_t>(word - expected));
            expected = word;
        }
        if (!words.empty()) first_ = words[0];
    }

private:
    std::uint32_t first_ = 0;
};

class ValueColumnReader {
public:
    // Of one quad: more than that no quad has.
    static constexpr std::uint64_t MostWords = 256;

    void append_words(ColumnReader& in, std::vector<std::uint32_t>& words) {
        const std::uint64_t count = in.number(Column::Values, MostWords);
        std::uint32_t word = first_;
        for (std::uint64_t i = 0; i < count; ++i) {
            word += static_cast<std::uint32_t>(in.difference(Column::Values));
            if (i == 0) first_ = word;
            words.push_back(word);
        }
    }

private:
    std::uint32_t first_ = 0;
};

inline void
write_row(ColumnWriter& out, std::span<const std::byte> row, std::span<const std::byte> before) {
    const bool same = std::equal(row.begin(), row.end(), before.begin(), before.end());
    out.byte(Column::Values, same);
    if (same) return;
    for (const std::byte value : row)
        out.byte(Column::Values, static_cast<std::uint8_t>(value));
}

// `row` holds the row before.
inline void read_row(ColumnReader& in, std::span<std::byte> row) {
    if (in.byte(Column::Values) != 0) return;
    for (std::byte& value : row)
        value = std::byte{in.byte(Column::Values)};
}

} // namespace ffgpu::work
