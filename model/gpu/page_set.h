// PageSet: a set of ranges of device memory, kept by whole pages: what a bin reads and writes.
// Pages make it small and quick; the worst they cost is a bin carried out early.

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ffgpu {

class PageSet {
public:
    explicit PageSet(std::uint64_t memory_bytes)
        : words_(((memory_bytes >> PageBits) >> 6) + 1) {}

    void add(std::uint64_t at, std::uint64_t bytes) {
        if (bytes == 0) return;
        const std::uint64_t last = (at + bytes - 1) >> PageBits;
        for (std::uint64_t page = at >> PageBits; page <= last; ++page)
            words_[page >> 6] |= std::uint64_t{1} << (page & 63);
        empty_ = false;
    }

    bool overlaps(std::uint64_t at, std::uint64_t bytes) const {
        if (empty_ || bytes == 0) return false;
        const std::uint64_t last = (at + bytes - 1) >> PageBits;
        for (std::uint64_t page = at >> PageBits; page <= last; ++page)
            if (words_[page >> 6] >> (page & 63) & 1) return true;
        return false;
    }

    void clear() {
        if (!empty_) std::fill(words_.begin(), words_.end(), 0);
        empty_ = true;
    }

private:
    static constexpr unsigned PageBits = 12;

    std::vector<std::uint64_t> words_;
    bool empty_ = true;
};

} // namespace ffgpu
