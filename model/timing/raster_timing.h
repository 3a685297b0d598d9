// RasterTiming: walks the blocks of each piece's box (work/block_walk.h) and makes the quads of
// those that are not empty. An immediate machine follows the primitives, a tile-based one the bins,
// in each of them the parts of the pieces in its list.
//
// With Walk::Box (raster_blocks.cpp) the walk is ahead of the quads by a queue: a block with quads
// takes it tile_cycles, one without empty_tile_cycles, a piece without quads a cycle at least. A
// block has its place in the queue of block_queue from the walk's first step to it until its last
// quad is made; so have the empty ones behind a piece's last quads, until they are passed. Of the
// blocks that were walked to, quads_per_cycle quads are made in a cycle, all of one piece.
//
// With Walk::Tiles (raster_tiles.cpp) it looks at every block of the outer tiles and at every quad
// of the blocks that the edges touch, a cycle each, and makes those that are covered.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/in_flight.h"
#include "model/timing/passage.h"
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
    bool starves();
    // The blocks that were walked to; told where each takes the walk a cycle.
    const Passage& blocks() const { return passage_; }

    std::string state() const override;
    const RasterStatistics& statistics() const { return statistics_; }

private:
    // What a token asks for: a primitive of an immediate machine, or a bin.
    struct Record {
        TimedScene* scene = nullptr;
        std::uint32_t number = 0; // of its draw, or of the bin
        bool ends_draw = false;
    };

    Activity step() override;
    Cycle next_work(Activity last) const override;
    bool take();
    void take(const SetupToken& token);
    void take(const BinToken& token);
    void take_pieces(std::uint32_t begin, std::uint32_t end);
    void end_record(const Record& record);
    const work::PreparedPiece& piece() const { return record_.scene->work.pieces[piece_]; }
    bool starves_at(const TimedScene& scene, std::uint32_t quad, std::uint32_t end) const;

    // Walk::Box:
    struct Block {
        Record record;                   // It is of this.
        std::uint32_t quad = 0, end = 0; // the next one to be made, and the piece's end
        Cycle ready_at = 0;              // It was walked to; empty ones: they were passed.
        bool is_empty = false;           // blocks without quads behind a piece's last ones
        bool begins_piece = false;       // None of the piece's quads was made.
        std::uint32_t piece = 0;         // of a block with quads
        bool is_of_last_piece = false;   // of the record, or of one without pieces
    };
    enum class Made : std::uint8_t { Nothing, Something, Refused };
    // The quads of one scene, found again and again at places near each other.
    class Quads {
    public:
        const TimedPart& part_with(const TimedScene& scene, std::uint32_t quad) {
            return scene_ == scene.number && part_->has(quad) ? *part_ : find(scene, quad);
        }

    private:
        const TimedPart& find(const TimedScene& scene, std::uint32_t quad);

        const TimedPart* part_ = nullptr;
        std::uint64_t scene_ = ~std::uint64_t{0};
    };

    Activity step_box();
    void walk();
    void begin_piece();
    const PreparedQuad& first_of_next_block();
    bool begin_block();
    void push_block(const PreparedQuad& quad, Cycle cycles);
    void begin_empty(Cycle cycles);
    Cycle empty_cycles_behind(const work::PreparedPiece& piece) const;
    bool ends_record(const Block& block) const;
    bool begin_free_block(bool made);
    bool find_next_block() { return is_found_ || look_for_next_block(); }
    bool look_for_next_block();
    Cycle cycles_to(const PreparedQuad& quad) const;
    Made make_quads();
    bool make_block(Block& block, std::uint32_t& made);
    void leave_block();
    bool starves_in_box();
    bool starves_in_tiles() const;
    bool next_token_has_come() const;
    bool next_token_starves() const;
    Cycle next_in_box(Activity last) const;

    // Walk::Tiles:
    struct TileWalk {
        bool begun = false;
        Cycle cycles_left = 0;     // of the piece
        Cycle steps = 0;           // tiles and blocks that were stepped to
        std::uint32_t scanned = 0; // quads of the block
        std::uint64_t empty = 0;   // blocks of the box without quads,
        std::uint64_t touched = 0; // and those of them that the edges touch
        std::uint64_t passed_empty = 0, passed_touched = 0;
        std::uint32_t quad = 0; // that is looked for, among the scene's
        bool is_found = false;
    };
    void begin_tiles();
    Cycle steps_to(const PieceBox& box, const PreparedQuad& quad) const;
    Cycle scan_to(const PieceBox& box, const PreparedQuad& quad);
    bool last_quad_has_left() const;
    Activity step_tiles();
    Activity walk_tiles();
    void end_tiles();
    Cycle next_in_tiles(Activity last) const;

    const RasterConfig config_;
    const Ports ports_;
    InFlight& in_flight_;
    RasterStatistics statistics_;
    Record record_;                           // that is walked, up to its last piece
    std::uint32_t piece_ = 0, end_piece_ = 0; // that is walked
    Cycle walked_at_ = 0;                     // the first cycle after the steps under way
    // Walk::Box:
    std::uint32_t next_ = 0; // quad: none between the last block's first and this begins one,
    bool is_found_ = false;  // but this does, or is the piece's end
    Quads walked_, made_;
    Ring<Block> blocks_;
    Passage passage_;
    // Walk::Tiles:
    TileWalk walk_;
};

} // namespace ffgpu::timing
