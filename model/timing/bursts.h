// Bursts: a rectangle of memory, rows of bytes `stride` apart, cut at multiples of the burst's
// size, one after the other. Rows that follow each other without a gap are one.

#pragma once

#include <algorithm>
#include <cstdint>

namespace ffgpu::timing {

class Bursts {
public:
    Bursts() = default;
    Bursts(std::uint64_t at, std::uint64_t bytes)
        : Bursts(at, bytes, 0, bytes == 0 ? 0 : 1) {}
    Bursts(std::uint64_t at, std::uint64_t row_bytes, std::uint64_t stride, std::uint64_t rows)
        : row_(at)
        , row_bytes_(row_bytes)
        , stride_(stride)
        , rows_(row_bytes == 0 ? 0 : rows) {
        if (stride != row_bytes || rows_ == 0) return;
        row_bytes_ *= rows_;
        rows_ = 1;
    }

    bool empty() const { return rows_ == 0; }
    // Of the first one that is left.
    std::uint64_t address() const { return row_ + done_; }
    std::uint32_t bytes(std::uint32_t burst_bytes) const {
        const std::uint64_t to_boundary = burst_bytes - address() % burst_bytes;
        return static_cast<std::uint32_t>(std::min(to_boundary, row_bytes_ - done_));
    }
    void advance(std::uint32_t burst_bytes) {
        done_ += bytes(burst_bytes);
        if (done_ < row_bytes_) return;
        done_ = 0;
        row_ += stride_;
        --rows_;
    }

private:
    std::uint64_t row_ = 0, row_bytes_ = 0, stride_ = 0, rows_ = 0;
    std::uint64_t done_ = 0; // of the row
};

} // namespace ffgpu::timing
