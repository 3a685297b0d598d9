// MemoryWaits: moments of the memory: when it took a request, and when it had answered. An answer
// depends on its request, with the way there and back and what the DRAM takes for it alone, and on
// the answer before it on the same channel: behind that it has waited for its turn, or not.

#pragma once

#include "model/timing/memory/address_mapping.h"
#include "model/timing/memory/config.h"
#include "model/timing/memory_request.h"
#include "model/timing/memory_turns.h"
#include "model/timing/moment.h"

#include <vector>

namespace ffgpu::timing {

class MemoryWaits {
public:
    // Of a memory that is not ours only latency is known.
    MemoryWaits(const MemoryConfig& config, bool is_ours);

    void leave_out_rare() { found_.leave_out_rare(); }

    // The answer in this cycle to a request of this moment; null: nobody of the pipe's asked.
    const Moment&
    answer(WaitPaths& paths, const MemoryRequest& request, const Moment* asked, Cycle now);
    // The arbiter takes a request of this moment: without a wait, or when the memory had a place.
    const Moment& taken(WaitPaths& paths, const Moment& asked, Cycle now);

    // All that was answered.
    const Moment& all() const { return all_; }
    // Cycles that each channel was at work since the start: whatever came sooner, it had all of
    // that to do. None of a memory that is not ours.
    template <class Add>
    void for_each_channel_work(const Add& add) const {
        for (const Channel& channel : channels_)
            add(static_cast<float>(channel.worked));
    }
    void restart();
    void add_heads(std::vector<WaitPaths::Path*>& heads);

private:
    struct Channel {
        Moment last{}; // answer
        MemoryTurns turns{};
        double worked = 0; // cycles, whole sixteenths
    };

    float alone(const MemoryRequest& request) const;
    bool stood_behind(const Moment& before, Cycle asked) const;
    Dependence
    own(const Moment& before, const Moment& asked, const MemoryRequest& request, Cycle now) const;
    Dependence
    turn(const Moment& before, const Moment* asked, const MemoryRequest& request, Cycle now) const;

    const MemoryConfig config_;
    const AddressMapping mapping_;
    const bool is_ours_;
    const float cycle_; // of the memory's clock, in the machine's, in whole sixteenths
    std::vector<Channel> channels_;
    std::size_t last_ = 0; // channel that answered
    Dependences found_;
    Moment all_;
    Moment taken_, taken_before_; // the last that was, in this cycle, and in one before
};

// Both are over.
void merge(WaitPaths& paths, Moment& last, const Moment& next);

} // namespace ffgpu::timing
