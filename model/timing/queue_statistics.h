// QueueStatistics: how full each queue of the machine was, whatever travels through it. An item
// that is on its way to a queue is in it.

#pragma once

#include "model/timing/histogram.h"
#include "model/timing/link.h"
#include "model/timing/memory_statistics.h"

#include <vector>

namespace ffgpu::timing {

class QueueStatistics : public NamedStatistics {
public:
    explicit QueueStatistics(std::vector<const Link*> links);

    std::vector<const Histogram*> histograms() const;

    // Brings all up to date with the end of cycle `now`.
    void settle(Cycle now);

private:
    struct OfLink {
        const Link* link;
        Counter* item_cycles;
        Histogram cycles_at;
    };
    std::vector<OfLink> links_;
};

} // namespace ffgpu::timing
