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
        : all_(std::bit_ceil(items))
        , mask_(all_.size() - 1) {}

    Moment& operator[](std::uint64_t item) { return all_[item & mask_]; }
    const Moment& operator[](std::uint64_t item) const { return all_[item & mask_]; }
    auto begin() { return all_.begin(); }
    auto end() { return all_.end(); }

    // For `item` beside those from `first` on; what was before them is forgotten.
    void make_room(std::uint64_t first, std::uint64_t item) {
        if (item <= first + mask_) return;
        Moments more(item - first + 1);
        for (std::uint64_t kept = first; kept <= first + mask_; ++kept)
            more[kept] = (*this)[kept];
        std::swap(*this, more);
    }

private:
    std::vector<Moment> all_; // a power of two
    std::size_t mask_;        // of their places; the vector's size would be a division
};

} // namespace ffgpu::timing
