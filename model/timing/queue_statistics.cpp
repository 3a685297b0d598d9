#include "model/timing/queue_statistics.h"

namespace ffgpu::timing {

QueueStatistics::QueueStatistics(std::vector<const Link*> links) {
    for (const Link* const link : links)
        links_.push_back({link,
                          &add("queue_" + link->name() + "_item_cycles",
                               "item cycles",
                               "sum over the cycles of the items in it"),
                          Histogram("queue_" + link->name() + "_items",
                                    "cycles",
                                    "by the number of items in it at their end")});
}

std::vector<const Histogram*> QueueStatistics::histograms() const {
    std::vector<const Histogram*> histograms;
    for (const OfLink& of : links_)
        histograms.push_back(&of.cycles_at);
    return histograms;
}

void QueueStatistics::settle(Cycle now) {
    for (OfLink& of : links_) {
        of.link->count_before(now + 1);
        *of.item_cycles += of.link->item_cycles() - of.item_cycles->value();
        of.cycles_at.set(of.link->cycles_at());
    }
}

} // namespace ffgpu::timing
