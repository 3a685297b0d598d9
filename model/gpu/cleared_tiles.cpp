#include "model/gpu/cleared_tiles.h"

#include <algorithm>
#include <utility>

namespace ffgpu {
namespace {

bool overlap(const Surface& surface, std::uint64_t at, std::uint64_t bytes) {
    return surface.address < at + bytes && at < surface.address + surface.bytes();
}

bool is_target(const Surface& surface) {
    return surface.format != Format::None;
}

} // namespace

void ClearedTiles::draw(std::uint32_t tile, const Rectangle& area) {
    Rectangle& drawn = tiles_[tile].drawn;
    drawn = unite(drawn, area);
}

Rectangle ClearedTiles::clear(std::uint32_t tile,
                              const Rectangle& area,
                              bool whole,
                              std::uint32_t value,
                              std::uint32_t mask) {
    Tile& of = tiles_[tile];
    const bool same = (mask & ~of.mask) == 0 && ((of.value ^ value) & mask) == 0;
    const Rectangle changed = same ? intersect(of.drawn, area) : area;
    if (whole) {
        // Where nothing was drawn since, what other clears left in other bits is there still.
        const bool keeps = of.drawn.empty();
        of.value = (value & mask) | (keeps ? of.value & ~mask : 0);
        of.mask = mask | (keeps ? of.mask : 0);
        of.drawn = {};
    } else if (!same) {
        of.drawn = unite(of.drawn, area);
    }
    return changed;
}

ClearedOfTargets ClearedTargets::of(const Targets& targets, int tile_size, std::size_t tiles) {
    std::vector<Surface> together;
    bool apart = true;
    Targets::for_each(targets, [&](const Surface& surface) {
        if (!is_target(surface)) return;
        for (const Surface& other : together)
            apart = apart && !overlap(other, surface.address, surface.bytes());
        together.push_back(surface);
    });
    ClearedOfTargets all;
    std::size_t place = 0;
    Targets::for_each(targets, [&](const Surface& surface) {
        auto& one = all[place++];
        if (!is_target(surface)) return;
        if (apart)
            one = of(surface, tile_size, tiles);
        else
            forget(surface.address, surface.bytes());
    });
    return all;
}

std::shared_ptr<ClearedTiles>
ClearedTargets::of(const Surface& target, int tile_size, std::size_t tiles) {
    for (const auto& one : kept_)
        if (one->are_of(target, tile_size, tiles)) return one;
    forget(target.address, target.bytes());
    if (kept_.size() == Most) kept_.erase(kept_.begin());
    return kept_.emplace_back(std::make_shared<ClearedTiles>(target, tile_size, tiles));
}

void ClearedTargets::forget(std::uint64_t at, std::uint64_t bytes) {
    std::erase_if(kept_, [&](const auto& one) { return overlap(one->target(), at, bytes); });
}

} // namespace ffgpu
