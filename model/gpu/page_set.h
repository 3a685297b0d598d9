// PageSet: a set of ranges of device memory, kept by whole pages: what a bin reads and writes.
// Pages make it small and quick; the worst they cost is a bin carried out early.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu {

class PageSet {
public:
    explicit PageSet(std::uint64_t memory_bytes)
        : words_(((memory_bytes >> PageBits) >> 6) + 1) {}

    void add(std::uint64_t at, std::uint64_t bytes) {
        for_each_word(at, bytes, [this](std::size_t word, std::uint64_t pages) {
            words_[word] |= pages;
            return false;
        });
        empty_ = empty_ && bytes == 0;
    }

    bool overlaps(std::uint64_t at, std::uint64_t bytes) const {
        if (empty_) return false;
        return for_each_word(at, bytes, [this](std::size_t word, std::uint64_t pages) {
            return (words_[word] & pages) != 0;
        });
    }

    void clear() {
        if (!empty_) std::fill(words_.begin(), words_.end(), 0);
        empty_ = true;
    }

private:
    static constexpr unsigned PageBits = 12;

    // Calls visit(word, its pages of the range) until it returns true; returns whether it did.
    template <class Visit>
    static bool for_each_word(std::uint64_t at, std::uint64_t bytes, Visit&& visit) {
        if (bytes == 0) return false;
        const std::uint64_t first = at >> PageBits, last = (at + bytes - 1) >> PageBits;
        for (std::uint64_t word = first / 64; word <= last / 64; ++word) {
            std::uint64_t pages = ~std::uint64_t{0};
            if (word == first / 64) pages &= ~std::uint64_t{0} << first % 64;
            if (word == last / 64) pages &= ~std::uint64_t{0} >> (63 - last % 64);
            if (visit(static_cast<std::size_t>(word), pages)) return true;
        }
        return false;
    }

    std::vector<std::uint64_t> words_;
    bool empty_ = true;
};

} // namespace ffgpu
