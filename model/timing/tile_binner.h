// TileBinner: puts each primitive that was set up into the lists of the bins that it touches, and
// writes records, lists and headers to the parameter buffer. A pass ends with its scene, or where
// the buffer is full; the next one begins in another parameter buffer, once one is free.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/in_flight.h"
#include "model/timing/parameter_buffer.h"
#include "model/timing/request_port.h"
#include "model/timing/unit.h"

#include <deque>
#include <optional>
#include <vector>

namespace ffgpu::timing {

class BinnerStatistics : public StatisticsGroup {
public:
    Counter& scenes = count("tile_scenes", "scenes", "that were binned and drawn");
    Counter& overflows =
        count("tile_overflows", "passes", "drawn because the parameter buffer was full");
    Counter& records =
        count("tile_records", "primitives", "written to the parameter buffer, clears among them");
    Counter& entries = count("tile_entries", "entries", "of primitives in the lists of bins");
    Counter& bins = count("tile_bins", "bins", "that are drawn, of all passes");
};

class TileBinner final : public Unit {
public:
    struct Ports {
        Channel<SetupToken>& setups_in;
        Channel<PassToken>& passes_out;
        Channel<std::uint32_t>& free_buffers_in;
        RequestPort& requests_out;
    };

    TileBinner(sc_core::sc_module_name name,
               const Clock& clock,
               const TilesConfig& config,
               const Ports& ports,
               InFlight& in_flight);

    std::string state() const override;
    const BinnerStatistics& statistics() const { return statistics_; }

private:
    // What became of the pass in hand.
    struct Pass {
        PassToken token;
        ParameterBuffer buffer;
        std::vector<std::uint32_t> entries; // a bin: in its list
        std::vector<std::uint32_t> written; // of which so many are on their way to memory
        std::uint32_t next_flush = 0;       // bin, once all records are in
    };

    Activity step() override;
    Activity work();
    bool take_primitive();
    bool begin_pass();
    void put_into_lists();
    Activity end_pass();
    void end_primitive();
    void write_list(std::uint32_t bin);
    void write_record(const ParameterBytes& bytes);
    const work::TilePlan& plan() const { return token_.draw.scene->work.tiles; }

    const TilesConfig& config_;
    const Ports ports_;
    InFlight& in_flight_;
    BinnerStatistics statistics_;
    std::deque<MemoryRequest> writes_;
    std::optional<MemoryRequest> record_tail_; // a piece that the next record goes on with
    std::deque<std::uint32_t> free_buffers_;

    bool has_primitive_ = false;
    SetupToken token_;              // the primitive in hand
    std::uint32_t next_record_ = 0; // of the scene
    std::uint32_t end_record_ = 0;  // of the primitive
    std::uint32_t next_bin_ = 0;    // of the record
    std::uint32_t draws_taken_ = 0; // of the scene
    std::uint32_t next_pass_ = 0;   // of the scene
    std::optional<Pass> pass_;
};

} // namespace ffgpu::timing
