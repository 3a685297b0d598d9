// LostCycles: why a bus carried no data. Every cycle of a channel either carries asked-for data or
// is lost to exactly one cause.
//
// A data cycle is lost where no column command went out one column latency before it, so the cause
// is noted when the command slot passes, and charged when the next data begin.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ffgpu::timing {

using MemoryCycle = std::uint64_t;
inline constexpr MemoryCycle NoCycle = ~MemoryCycle{0};

enum class LostTo : std::uint8_t {
    NoRequest,  // the channel had nothing to do
    Row,        // precharge, activate, write recovery: tRP, tRCD, tRAS, tRTP, tWR
    Activates,  // tRRD, tFAW
    Commands,   // the one command a cycle went, or was left, to another bank
    Turnaround, // between read and write: tWTR, tRTW, different column latencies
    Refresh,    // rows closed for it, and tRFC
    Column,     // tCCD longer than a burst
    Order,      // data could flow but for the order of requests that must be kept
    Burst,      // data that nobody asked for, to the end of a burst
    Count
};
inline constexpr std::size_t LostCauses = static_cast<std::size_t>(LostTo::Count);
inline constexpr std::array<std::string_view, LostCauses> LostToNames{"no_request",
                                                                      "row",
                                                                      "activates",
                                                                      "commands",
                                                                      "turnaround",
                                                                      "refresh",
                                                                      "column",
                                                                      "order",
                                                                      "burst"};

// The causes of the command slots since the last column command, as runs.
class SlotCauses {
public:
    // From slot `from` on.
    void note(MemoryCycle from, LostTo cause) {
        if (!runs_.empty() && runs_.back().cause == cause) return;
        if (!runs_.empty() && runs_.back().from == from)
            runs_.back().cause = cause;
        else
            runs_.push_back({from, cause});
    }

    // Forgets the slots before `from`.
    void restart(MemoryCycle from, LostTo cause) {
        runs_.clear();
        runs_.push_back({from, cause});
    }

    // Calls charge(cause, cycles) for the last `wanted` slots before slot `end`; `before` is the
    // cause of those older than the first noted.
    template <class Charge>
    void charge(MemoryCycle end, MemoryCycle wanted, LostTo before, Charge&& charge) const {
        for (std::size_t i = runs_.size(); i-- > 0 && wanted > 0;) {
            if (runs_[i].from >= end) continue;
            const MemoryCycle slots = end - runs_[i].from;
            const MemoryCycle taken = slots < wanted ? slots : wanted;
            charge(runs_[i].cause, taken);
            wanted -= taken;
            end = runs_[i].from;
        }
        if (wanted > 0) charge(before, wanted);
    }

private:
    struct Run {
        MemoryCycle from = 0;
        LostTo cause = LostTo::NoRequest;
    };
    std::vector<Run> runs_;
};

} // namespace ffgpu::timing
