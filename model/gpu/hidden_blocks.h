// HiddenBlocks: tells blocks of a tile in which all that a primitive covers fails the early depth
// test, from bounds of what the depth target holds (N. Greene, M. Kass, G. Miller, Hierarchical
// Z-Buffer Visibility, SIGGRAPH 1993). Whoever draws may count such fragments and pass them over:
// no result depends on that.
//
// A bound is what a block's farthest pixel held when it was looked at. Draws whose test lets
// through only what is nearer can make it too far, never too near: so it is not kept up to date.
// Only what fills a block has it looked at, and where that did not help less often.

#pragma once

#include "model/fragment/fragment_pipe.h"
#include "model/raster/coverage.h"
#include "model/raster/setup_record.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

class HiddenBlocks {
public:
    explicit HiddenBlocks(std::span<const std::byte> memory)
        : memory_(memory) {}

    // What follows is in this tile, of which nothing is known. It begins at multiples of BlockSize
    // and is at most MaxTileSize wide and high.
    void begin_tile(const Rectangle& tile);
    // What follows is of this pipe. Fragments of the draws before may still wait for their test,
    // those of other pipes may not.
    void begin_draws(const FragmentPipe& pipe);
    // Depths were changed by something else than draws.
    void forget() { known_.reset(); }

    // Whether anything can be said of these draws: they are tested early, by Less or Lequal.
    bool tells() const { return tells_; }
    // True: no fragment of the record, which covers pixels by their centres, passes the depth test
    // in the block. Asked only where it tells().
    bool hides(const SetupRecord& record, const BlockCoverage& block);

private:
    struct Bound {
        std::uint32_t farthest = ~0u;
        std::uint8_t failures = 1; // looks in a row that did not help: what fills a block first is
        std::uint8_t wait = 1;     // mostly not hidden; that often it is not looked
    };

    static constexpr unsigned BlocksAcross = MaxTileSize / BlockSize;

    std::span<const std::byte> memory_;
    Rectangle tile_;
    Surface target_;
    bool tells_ = false;
    bool equal_passes_ = false;
    std::bitset<MaxTileBlocks> known_;
    std::array<Bound, MaxTileBlocks> bounds_;
};

} // namespace ffgpu
