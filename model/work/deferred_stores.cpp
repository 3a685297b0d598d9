#include "model/work/deferred_stores.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {

DeferredStores::OfSurface* DeferredStores::find(const Surface& surface) {
    const auto found = std::find_if(surfaces_.begin(), surfaces_.end(), [&](const OfSurface& of) {
        return of.target.surface == surface;
    });
    return found == surfaces_.end() ? nullptr : &*found;
}

void DeferredStores::make_due(const OfSurface& of, std::uint32_t bin, std::uint32_t bytes) {
    add_bin_lines(of.target, bin_rectangle(bin_size_, bin), bytes, due_);
}

void DeferredStores::defer(const TileTarget& target, std::uint32_t bin, std::uint32_t bytes) {
    if (bytes == 0) return;
    OfSurface* of = find(target.surface);
    if (!of) of = &surfaces_.emplace_back(OfSurface{target, {}});
    Bin& deferred = of->bins[bin];
    deferred = {deferred.bytes | bytes, frame_};
}

bool DeferredStores::drop(const Surface& surface, std::uint32_t bin, std::uint32_t bytes) {
    OfSurface* const of = find(surface);
    if (!of) return false;
    const auto deferred = of->bins.find(bin);
    if (deferred == of->bins.end()) return false;
    deferred->second.bytes &= ~bytes;
    if (deferred->second.bytes != 0) return false;
    of->bins.erase(deferred);
    return true;
}

void DeferredStores::need(const Surface& surface, std::uint32_t bin) {
    OfSurface* const of = find(surface);
    if (!of) return;
    const auto deferred = of->bins.find(bin);
    if (deferred == of->bins.end()) return;
    make_due(*of, bin, deferred->second.bytes);
    of->bins.erase(deferred);
}

void DeferredStores::need_range(std::uint64_t at, std::uint64_t bytes) {
    for (OfSurface& of : surfaces_) {
        const Surface& surface = of.target.surface;
        if (at >= surface.address + surface.bytes() || surface.address >= at + bytes) continue;
        for (const auto& [bin, deferred] : of.bins)
            make_due(of, bin, deferred.bytes);
        of.bins.clear();
    }
}

void DeferredStores::end_frame() {
    for (OfSurface& of : surfaces_) {
        std::erase_if(of.bins, [&](const auto& entry) {
            if (frame_ - entry.second.frame < FramesAhead) return false;
            make_due(of, entry.first, entry.second.bytes);
            return true;
        });
    }
    std::erase_if(surfaces_, [](const OfSurface& of) { return of.bins.empty(); });
    ++frame_;
}

std::vector<PlacedLine> DeferredStores::take_due() {
    return std::exchange(due_, {});
}

} // namespace ffgpu::work
