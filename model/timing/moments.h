// Moments: those of a link's items, by the items' numbers. Few are of use at a time: what is kept
// is small, so that the processor's cache holds it, and grows where it has to.

#pragma once

#include "model/timing/moment.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class Moments {
public:
    // Of so many items in a row, at the least.
    explicit Moments(std::size_t items)
        : all_(std::bit_ceil(items)) {}

    Moment& operator[](std::uint64_t item) { return all_[item & (all_.size() - 1)]; }
    const Moment& operator[](std::uint64_t item) const { return all_[item & (all_.size() - 1)]; }
    auto begin() { return all_.begin(); }
    auto end() { return all_.end(); }

    // For `item` beside those from `first` on; what was before them is forgotten.
    void make_room(std::uint64_t first, std::uint64_t item) {
        if (item < first + all_.size()) return;
        Moments more(item - first + 1);
        for (std::uint64_t kept = first; kept < first + all_.size(); ++kept)
            more[kept] = (*this)[kept];
        std::swap(all_, more.all_);
    }

private:
    std::vector<Moment> all_; // a power of two
};

} // namespace ffgpu::timing
