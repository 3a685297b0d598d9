// TileBinPlanner: of each bin of a scene its quads, and what of its targets is loaded and stored.
//
// Loaded is what is read or kept and has no value on chip yet. Stored is what is new, once: colour
// at the end of the bin; depth, and samples that were resolved, not before somebody needs them
// (DeferredStores), except where the parameter buffer was full: then all is stored, because nobody
// knows what comes.

#pragma once

#include "model/work/tile_scene.h"

#include <cstdint>
#include <vector>

namespace ffgpu::work {

class TileBinPlanner {
public:
    // The scene's quads, sorted, each with its pass, and their pieces, each with its bin.
    struct Sorted {
        PreparedScene& scene;
        const std::vector<std::uint32_t>& pass_of_quad;
        const std::vector<BinKey>& key_of_piece;
        DeferredStores& deferred;
    };
    struct Place {
        bool is_first = false, is_last = false; // of the passes
        std::uint32_t pass = 0;
    };

    TileBinPlanner(const WorkConfig& config, const GatheredScene& gathered, const Sorted& sorted)
        : config_(config)
        , gathered_(gathered)
        , sorted_(sorted) {}

    // Bins come in their order; bin's list is there already.
    void plan(std::uint32_t key, const Place& place, TileBin& bin);

private:
    void take_quads(const Place& place, TileBin& bin);
    void collect_clears(const Place& place, const TileBin& bin);
    void add_fills(const Rectangle& area, const TileBin& bin);
    void plan_target(std::size_t target, const Place& place, const TileBin& bin);
    void apply(const PreparedQuad& quad, std::size_t target, TileContents& contents) const;
    bool is_resolved(std::size_t target, const Place& place) const;
    void load_and_store(std::size_t target, const TileContents& contents, const Place& place);

    const WorkConfig& config_;
    const GatheredScene gathered_;
    const Sorted sorted_;
    std::uint32_t next_quad_ = 0, next_piece_ = 0;
    // Of the bin:
    std::uint32_t key_ = 0;
    std::vector<std::uint32_t> clears_; // draws
    std::vector<PlacedLine> loads_, stores_;
};

} // namespace ffgpu::work
