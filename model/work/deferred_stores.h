// DeferredStores: what bins of surfaces hold on chip alone, as far as memory knows: depth, stencil
// and resolved samples of scenes that ended, of which nobody has read or kept anything yet. A clear
// makes such a store needless; a read makes it due.
//
// A driver that looks ahead in its command stream by two frames knows which of the two will come
// when the scene's bins are drawn: the two buffers of a window take turns, and so do the clears of
// their samples. Here the store is made where the need for it is seen.

#pragma once

#include "model/work/tile_lines.h"

#include <cstdint>
#include <map>
#include <vector>

namespace ffgpu::work {

class DeferredStores {
public:
    explicit DeferredStores(std::uint32_t bin_size)
        : bin_size_(bin_size) {}

    // Bytes of the bin's samples are newer than memory's.
    void defer(const TileTarget& target, std::uint32_t bin, std::uint32_t bytes);
    // They were overwritten before anybody read them; true: nothing is left of the store.
    bool drop(const Surface& surface, std::uint32_t bin, std::uint32_t bytes);
    // The store of one bin is due.
    void need(const Surface& surface, std::uint32_t bin);
    // Those of [at, at + bytes) of the device's memory are due.
    void need_range(std::uint64_t at, std::uint64_t bytes);
    // A frame has ended: what was left by the frame FramesAhead before is due.
    void end_frame();

    // The lines that became due since the last call.
    std::vector<PlacedLine> take_due();

private:
    static constexpr std::uint32_t FramesAhead = 2;

    struct Bin {
        std::uint32_t bytes = 0;
        std::uint32_t frame = 0;
    };
    struct OfSurface {
        TileTarget target;
        std::map<std::uint32_t, Bin> bins;
    };

    OfSurface* find(const Surface& surface);
    void make_due(const OfSurface& of, std::uint32_t bin, std::uint32_t bytes);

    const std::uint32_t bin_size_;
    std::vector<OfSurface> surfaces_;
    std::vector<PlacedLine> due_;
    std::uint32_t frame_ = 0;
};

} // namespace ffgpu::work
