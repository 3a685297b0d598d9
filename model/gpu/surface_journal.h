// SurfaceJournal: of which targets a work stream with values has told all that they hold. What
// else than its draws and clears writes memory makes it forget the targets there.

#pragma once

#include "model/device/registers.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ffgpu {

class SurfaceJournal {
public:
    bool knows(const Surface& surface) const {
        return std::find(known_.begin(), known_.end(), surface) != known_.end();
    }
    bool touches(std::uint64_t at, std::uint64_t bytes) const {
        return std::any_of(known_.begin(), known_.end(), [&](const Surface& surface) {
            return overlap(surface, at, bytes);
        });
    }
    // What lay at its place before is no more.
    void learn(const Surface& surface) {
        forget(surface.address, surface.bytes());
        known_.push_back(surface);
    }
    void forget(std::uint64_t at, std::uint64_t bytes) {
        std::erase_if(known_, [&](const Surface& surface) { return overlap(surface, at, bytes); });
    }
    void clear() { known_.clear(); }

private:
    static bool overlap(const Surface& surface, std::uint64_t at, std::uint64_t bytes) {
        return surface.address < at + bytes && at < surface.address + surface.bytes();
    }

    std::vector<Surface> known_; // They do not overlap.
};

} // namespace ffgpu
