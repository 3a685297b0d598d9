// ClearedTiles: of a target, which of a bin's tiles still hold what a clear left in them, and what
// of them was drawn to since. A clear to the same value need only undo the drawing: memory ends as
// if it had been written whole, and the background of a scene is not written frame after frame.
//
// ClearedTargets keeps those of the targets that were drawn to last. What else than bins writes
// memory makes it forget the targets there.

#pragma once

#include "model/device/registers.h"
#include "model/packets/rectangle.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu {

// Tiles are told apart by who calls: one caller at a time for each of them.
class ClearedTiles {
public:
    ClearedTiles(const Surface& target, int tile_size, std::size_t tiles)
        : target_(target)
        , tile_size_(tile_size)
        , tiles_(tiles) {}

    bool are_of(const Surface& target, int tile_size, std::size_t tiles) const {
        return target_ == target && tile_size_ == tile_size && tiles_.size() == tiles;
    }
    const Surface& target() const { return target_; }

    // Pixels of `area`, a part of the tile, may be written by a draw from now on.
    void draw(std::uint32_t tile, const Rectangle& area);

    // A clear makes the bits of `mask` those of `value` in each pixel of `area`, a part of the tile
    // or all of it that lies on the target (`whole`). Returns where that may change something: who
    // calls writes at least there.
    Rectangle clear(std::uint32_t tile,
                    const Rectangle& area,
                    bool whole,
                    std::uint32_t value,
                    std::uint32_t mask);

private:
    // Outside of `drawn` the bits of `mask` of each pixel are those of `value`.
    struct Tile {
        std::uint32_t value = 0, mask = 0;
        Rectangle drawn;
    };

    Surface target_;
    int tile_size_;
    std::vector<Tile> tiles_;
};

// One for each target, in the order of Targets::for_each; null where nothing is kept.
using ClearedOfTargets = std::array<std::shared_ptr<ClearedTiles>, ColorTargets + 1>;

class ClearedTargets {
public:
    // For a bin that draws into `targets`. Of targets that lie one in the other nothing is kept.
    ClearedOfTargets of(const Targets& targets, int tile_size, std::size_t tiles);

    void forget(std::uint64_t at, std::uint64_t bytes);
    void clear() { kept_.clear(); }

private:
    static constexpr std::size_t Most = 16;

    std::shared_ptr<ClearedTiles> of(const Surface& target, int tile_size, std::size_t tiles);

    std::vector<std::shared_ptr<ClearedTiles>> kept_; // They do not overlap. The oldest is first.
};

} // namespace ffgpu
