// FragmentTiming: texture environments, colour sum, fog and alpha test in time, of all fragment
// pipes. A quad takes its pipe for combiner_cycles for each enabled environment, at least one
// cycle.

#pragma once

#include "model/base/ring.h"
#include "model/timing/fragment_pipes.h"
#include "model/timing/unit.h"

#include <algorithm>
#include <vector>

namespace ffgpu::timing {

class FragmentTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& quads_in;
        Channel<QuadToken>& quads_out; // with the unit's latency
    };

    FragmentTiming(sc_core::sc_module_name name,
                   const Clock& clock,
                   const TimingConfig& config,
                   const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports)
        , exit_(config, ports.quads_out)
        , pipes_(config.raster.quads_per_cycle) {
        go_on_while_busy();
    }

    std::string state() const override;

    // To each pipe, and behind them.
    const Passage& to_pipe(std::size_t pipe) const { return pipes_[pipe].passage; }
    const PipeExit& exit() const { return exit_; }

private:
    struct Pipe {
        Ring<QuadToken> waiting;
        Passage passage{};             // through them
        std::uint32_t cycles_left = 0; // before it takes a quad again
        bool inside = false;           // with entry_cycles: the first that waits
    };

    Activity step() override;
    Cycle next_work(Activity last) const override {
        const bool works = last == Activity::Busy || can_distribute();
        return works ? now() + 1 : Unit::next_work(last);
    }
    bool has_backlog() const override {
        return Unit::has_backlog() ||
               std::any_of(pipes_.begin(), pipes_.end(), [](const Pipe& pipe) {
                   return !pipe.waiting.empty();
               });
    }
    bool can_distribute() const;
    // What goes round comes when the one before it has left: it waits with its samples.
    bool has_place(const Pipe& pipe) const {
        const std::size_t places =
            config_.fragment.entry_cycles > 0 ? 1 : config_.fragment.pipe_queue;
        return pipe.waiting.size() < places;
    }
    bool is_empty() const; // No pipe has anything to do.
    void distribute();
    Activity step(std::size_t number);
    Activity go_round(std::size_t number);
    void send(std::size_t number);

    const TimingConfig& config_;
    const Ports ports_;
    PipeExit exit_;
    std::vector<Pipe> pipes_;
    std::size_t first_ = 0; // pipe at the way out
};

} // namespace ffgpu::timing
