// TileMemory: the bins that are on chip. A bin's lines are loaded and its clears done, then the
// rasterizer gets it; when its last quad has ended, its lines are stored and its place is free.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/in_flight.h"
#include "model/timing/request_port.h"
#include "model/timing/tile_tokens.h"
#include "model/timing/unit.h"

#include <deque>

namespace ffgpu::timing {

class TileStatistics : public StatisticsGroup {
public:
    Counter& clears = count("tile_clears", "bins", "cleared on chip, once a clear");
    Counter& color_loaded = count("tile_color_loaded_bytes", "bytes", "of colour, before drawing");
    Counter& color_stored = count("tile_color_stored_bytes", "bytes", "of colour, after drawing");
    Counter& depth_loaded =
        count("tile_depth_loaded_bytes", "bytes", "of depth and stencil, before drawing");
    Counter& depth_stored =
        count("tile_depth_stored_bytes", "bytes", "of depth and stencil, after drawing");
    Counter& needless_stores = count("tile_needless_stores",
                                     "bins",
                                     "of a target, never stored: all that was new was overwritten "
                                     "before anybody read it");
};

class TileMemory final : public Unit {
public:
    struct Ports {
        Channel<BinToken>& bins_in;
        Channel<BinToken>& bins_out;
        Channel<std::uint32_t>& free_buffers_out; // parameter buffers
        RequestPort& requests_out;
        Channel<std::uint64_t>& responses_in;
    };

    TileMemory(sc_core::sc_module_name name,
               const Clock& clock,
               const TilesConfig& config,
               std::uint32_t bin_size,
               const Ports& ports,
               InFlight& in_flight);

    std::string state() const override;
    const TileStatistics& statistics() const { return statistics_; }

private:
    enum class State : std::uint8_t { Loading, Drawing, Storing };
    struct Open {
        BinToken token;
        std::uint64_t ticket = 0;
        State state = State::Loading;
        std::uint32_t next_line = 0; // to load or to store
        std::uint32_t on_their_way = 0;
        std::uint64_t clear_cycles = 0; // left
    };

    Activity step() override;
    bool open_bin();
    Activity move_lines();
    Activity move_line();
    Activity load();
    Activity close();
    void count(const work::PlacedLine& line, bool write);

    const TilesConfig& config_;
    const std::uint64_t clear_cycles_; // of a bin
    const Ports ports_;
    InFlight& in_flight_;
    TileStatistics statistics_;
    std::uint64_t next_ticket_ = 1;
    std::deque<Open> open_; // tickets follow one another
};

} // namespace ffgpu::timing
