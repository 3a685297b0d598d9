// CommandProcessor: reads draws, clears and copies in order. Draws stream into the pipe one behind
// the other; a clear, a copy, a read by the driver or the end of a frame waits until the pipe is
// empty. Clears, copies, the write-back of caches and what images read go line by line through the
// command processor's own port to memory.

#pragma once

#include "model/base/ring.h"
#include "model/timing/block_states.h"
#include "model/timing/bursts.h"
#include "model/timing/channel.h"
#include "model/timing/host_command.h"
#include "model/timing/in_flight.h"
#include "model/timing/line_cache.h"
#include "model/timing/unit.h"

#include <vector>

namespace ffgpu::timing {

class CommandProcessor final : public Unit {
public:
    struct Ports {
        Channel<CommandToken>& commands_in;
        Channel<DrawToken>& draws_out;
        Channel<Drained>& drained_out;
        RequestPort& requests_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& depth_cache;
        LineCache& color_cache;
        BlockStates* depth_blocks; // null, as below: no values are followed
        BlockStates* color_blocks;
        CommandLedger& ledger;
    };

    CommandProcessor(sc_core::sc_module_name name,
                     const Clock& clock,
                     const TimingConfig& config,
                     const Ports& ports,
                     InFlight& in_flight,
                     InFlight& memory_in_flight);

    std::string state() const override;

private:
    Activity step() override;
    Cycle next_work(Activity last) const override {
        return now() < decoded_at_ ? decoded_at_ : Unit::next_work(last);
    }
    Activity draw(const DrawToken& draw);
    // The pipe is empty.
    Activity begin(TransferCommand& transfer);
    void end_transfer();
    Activity drain(const DrainCommand& drain);
    Activity move_lines();
    Activity read_image();
    void read(const LineCache& cache, std::uint64_t line, std::uint32_t bytes);
    void write_back(const LineCache& cache, const LineWrite& line);
    void write_back(LineCache& cache);
    void clear(const work::PreparedTransfer& transfer);
    bool clear_state(const work::TransferLine& part);
    bool resolve(const work::TransferLine& part, BlockStates::Change change);
    void read(const work::TransferLine& part);
    void overwrite(const work::TransferLine& part);
    Activity take_content(const work::PreparedContent& content);
    Activity let_host_access(const std::vector<work::TransferLine>& lines);
    LineCache& cache_of(const work::TransferLine& part) {
        return part.depth ? ports_.depth_cache : ports_.color_cache;
    }
    BlockStates* blocks_of(const work::TransferLine& part) {
        return part.depth ? ports_.depth_blocks : ports_.color_blocks;
    }

    const TimingConfig& config_;
    const Ports ports_;
    InFlight& in_flight_;
    InFlight& memory_in_flight_;
    bool written_back_ = false;    // for a DrainCommand
    Ring<MemoryRequest> requests_; // of clears, copies and write-backs, a line each
    bool transferring_ = false;    // They are of the first command, which waits for them.
    Bursts image_;                 // that the draw before reads
    bool decoding_ = false;
    Cycle decoded_at_ = 0;                // the last cycle that it takes
    std::uint64_t state_cycles_left_ = 0; // of a fast clear
};

} // namespace ffgpu::timing
