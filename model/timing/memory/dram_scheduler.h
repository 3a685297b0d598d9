// DramScheduler: which command goes out in a cycle. First-ready, first-come first-served (S. Rixner
// et al., Memory Access Scheduling, ISCA 2000): the oldest request whose column may go out; else
// the oldest whose bank can be made ready. A request that reorder_limit younger ones have passed is
// passed no more. In order is the same with a limit of zero: data in the order of the requests,
// rows opened ahead.

#pragma once

#include "model/timing/memory/dram_device.h"

#include <vector>

namespace ffgpu::timing {

struct WaitingRequest {
    DramRequest request;
    RowResult result = RowResult::Hit; // so far: what had to be done for it
    std::uint32_t passed = 0;          // younger requests that were served before
};

struct DramCommand {
    enum class Kind : std::uint8_t { None, Column, Activate, Precharge };
    Kind kind = Kind::None;
    std::size_t index = 0;            // of the waiting request
    MemoryCycle again_at = 0;         // None: nothing can go out before
    LostTo cause = LostTo::NoRequest; // None: why not now
};

class DramScheduler {
public:
    explicit DramScheduler(const MemoryConfig& config)
        : limit_(config.scheduler == SchedulerKind::InOrder ? 0 : config.reorder_limit) {}

    // `waiting` is in the order of arrival.
    DramCommand choose(const std::vector<WaitingRequest>& waiting,
                       const DramDevice& device,
                       MemoryCycle now) const;

    // Takes the request out; those before it have been passed.
    static void remove(std::vector<WaitingRequest>& waiting, std::size_t index);

private:
    struct Search;
    void find_column(Search& search) const;
    void find_row(Search& search) const;
    static LostTo why_oldest_waits(const Search& search);

    const std::uint32_t limit_;
};

} // namespace ffgpu::timing
