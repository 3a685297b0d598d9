// CommandProcessor: reads draws, clears and copies in order. Draws stream into the pipe one behind
// the other; a clear, a copy or the end of a frame waits until the pipe is empty. Clears, copies
// and the write-back of caches go line by line through the command processor's own port to memory.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/in_flight.h"
#include "model/timing/line_cache.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"
#include "model/work/machine_order.h"

#include <deque>
#include <variant>

namespace ffgpu::timing {

class CommandProcessor final : public Unit {
public:
    struct Ports {
        Channel<DrawToken>& draws_out;
        RequestPort& requests_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& depth_cache;
        LineCache& color_cache;
        CommandLedger& ledger;
    };

    CommandProcessor(sc_core::sc_module_name name,
                     const Clock& clock,
                     const TimingConfig& config,
                     const Ports& ports,
                     InFlight& in_flight,
                     InFlight& memory_in_flight);

    // The host's side; called while the simulation is paused.
    void enqueue(TimedScene& scene);
    void enqueue(work::PreparedTransfer&& transfer);
    void enqueue_frame_end();
    // Nothing is left to read: the clock must not go on without the host.
    bool starves() const { return commands_.empty() && requests_.empty(); }

private:
    struct Transfer {
        work::PreparedTransfer work;
        std::size_t entry = 0; // of the ledger
    };
    struct FrameEnd {};
    using Command = std::variant<DrawToken, Transfer, FrameEnd>;

    Activity step() override;
    bool may_sleep() const override { return true; }
    Cycle next_work(Activity last) const override {
        return now() < decoded_at_ ? decoded_at_ : Unit::next_work(last);
    }
    Activity draw(const DrawToken& draw);
    // The pipe is empty.
    Activity begin(const work::PreparedTransfer& transfer);
    void end_transfer();
    Activity end_frame();
    Activity move_line();
    void read(const LineCache& cache, std::uint64_t line);
    void write_back(const LineCache& cache, const LineWrite& line);
    void write_back(LineCache& cache);
    void overwrite(LineCache& cache, const work::WrittenLine& line);

    const TimingConfig& config_;
    const Ports ports_;
    InFlight& in_flight_;
    InFlight& memory_in_flight_;
    bool written_back_ = false; // at the end of a frame: only the memory has to finish
    std::deque<Command> commands_;
    std::deque<MemoryRequest> requests_; // of clears, copies and write-backs, a line each
    Cycle decoded_at_ = 0;
    bool decoding_ = false;
};

} // namespace ffgpu::timing
