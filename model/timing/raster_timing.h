// RasterTiming: walks the blocks of each piece's box (work/block_walk.h) and makes the quads of
// those that are not empty, quads_per_cycle of them. A block with quads takes tile_cycles and then
// its quads' cycles; one without takes empty_tile_cycles; a piece takes a cycle at least. An
// immediate machine follows the primitives, a tile-based one the bins, in each of them the parts of
// the pieces in its list.
//
// With Walk::Tiles (raster_tiles.cpp) it looks at every block of the outer tiles and at every quad
// of the blocks that the edges touch, a cycle each, and makes those that are covered.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/in_flight.h"
#include "model/timing/tile_tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class RasterStatistics : public StatisticsGroup {
public:
    Counter& blocks = count("raster_blocks", "blocks", "walked that held quads");
    Counter& empty_blocks = count("raster_empty_blocks", "blocks", "walked that held none");
};

class RasterTiming final : public Unit {
public:
    struct Ports {
        Channel<SetupToken>& setups_in; // immediate
        Channel<BinToken>& bins_in;     // tile-based
        Channel<QuadToken>& quads_out;
    };

    RasterTiming(sc_core::sc_module_name name,
                 const Clock& clock,
                 const RasterConfig& config,
                 const Ports& ports,
                 InFlight& in_flight)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports)
        , in_flight_(in_flight) {}

    // In the next cycle it could come to quads that the host has not told: the clock must not go
    // on without them.
    bool starves() const;

    std::string state() const override;
    const RasterStatistics& statistics() const { return statistics_; }

private:
    Activity step() override;
    Activity walk();
    Cycle next_work(Activity last) const override;
    bool take();
    void take(const SetupToken& token);
    void take(const BinToken& token);
    void take_scene(TimedScene& scene);
    void take_pieces(std::uint32_t begin, std::uint32_t end);
    void end_record();
    const TimedPart& part_with_quad();
    bool starves(const TimedScene& scene, std::uint32_t quad, std::uint32_t end) const;
    Activity walk_piece();
    Cycle cycles_to(const PreparedQuad& quad) const;
    bool step_to_block(const PreparedQuad& quad);
    void end_piece(const work::PreparedPiece& piece);
    // Walk::Tiles:
    struct TileWalk {
        bool begun = false;
        Cycle cycles_left = 0;     // of the piece
        Cycle steps = 0;           // tiles and blocks that were stepped to
        std::uint32_t scanned = 0; // quads of the block
        std::uint64_t empty = 0;   // blocks of the box without quads,
        std::uint64_t touched = 0; // and those of them that the edges touch
        std::uint64_t passed_empty = 0, passed_touched = 0;
    };
    void begin_tiles(const work::PreparedPiece& piece);
    Cycle steps_to(const PieceBox& box, const PreparedQuad& quad) const;
    Cycle scan_to(const PieceBox& box, const PreparedQuad& quad);
    bool last_quad_has_left() const;
    Activity walk_tiles();
    void end_tiles();

    const RasterConfig config_;
    const Ports ports_;
    InFlight& in_flight_;
    RasterStatistics statistics_;
    TimedScene* scene_ = nullptr;
    std::uint64_t scene_number_ = ~std::uint64_t{0};
    const TimedPart* part_ = nullptr; // of the scene: the quad is in this, or in another
    // False: the scene under way was told as a whole, and nothing behind it is looked at before
    // the record's end.
    bool may_starve_ = true;
    std::uint32_t draw_ = 0; // immediate: of the record under way
    bool ends_draw_ = false;
    std::uint32_t bin_ = 0; // tile-based: under way
    std::uint32_t piece_ = 0, end_piece_ = 0;
    std::uint32_t quad_ = 0; // of the piece, among the scene's
    bool in_block_ = false;  // Its block was stepped to.
    Cycle walked_at_ = 0;    // the first cycle after the steps under way
    TileWalk walk_;
};

} // namespace ffgpu::timing
