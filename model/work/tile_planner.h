// TilePlanner: sorts a gathered scene by bins: which primitives are recorded in the lists of which
// bins, where the parameter buffer is full, and the order of the quads.

#pragma once

#include "model/work/tile_bin_planner.h"

#include <cstdint>
#include <set>
#include <vector>

namespace ffgpu::work {

class TilePlanner {
public:
    TilePlanner(const WorkConfig& config, const GatheredScene& gathered, PreparedScene& scene)
        : config_(config)
        , gathered_(gathered)
        , scene_(scene)
        , plan_(scene.tiles) {}

    // Fills the scene's plan and brings its quads into their order.
    void run(DeferredStores& deferred);

private:
    struct Pass {
        std::vector<TileRecord> records; // with bins in `keys`
        std::vector<std::uint32_t> keys;
        std::set<std::uint32_t> bins;
        std::uint64_t bytes = 0; // in the parameter buffer
    };

    void record_clear(std::uint32_t draw);
    void record_draw(std::uint32_t draw);
    void
    add_record(std::uint32_t draw, std::uint32_t piece, const std::vector<std::uint32_t>& bins);
    std::vector<std::uint32_t> bins_of(const PreparedPiece& piece) const;
    std::vector<std::uint32_t> bins_in(const Rectangle& rectangle) const;
    void touch(const std::vector<std::uint32_t>& bins, Pass& pass) const;
    std::uint64_t bytes_with(const std::vector<std::uint32_t>& bins, const Pass& pass) const;
    void sort_quads();
    void add_pass(const Pass& pass, TileBinPlanner& bins);

    const WorkConfig& config_;
    const GatheredScene gathered_;
    PreparedScene& scene_;
    TilePlan& plan_;
    std::vector<Pass> passes_;
    std::vector<std::uint32_t> pass_of_quad_;
    std::vector<BinKey> part_keys_; // of the scene's pieces, sorted
};

} // namespace ffgpu::work
