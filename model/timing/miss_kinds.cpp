#include "model/timing/miss_kinds.h"

#include <utility>

namespace ffgpu::timing {

using work::MissKind;

MissKinds::MissKinds(std::uint32_t sets, std::uint32_t ways)
    : reckoned_{.classifier = {sets, ways}} {
    logs_.front().resize(1);
}

void MissKinds::reckon_on(work::JobThread& thread) {
    check(noted_ == 0, "nothing is half written");
    thread_ = &thread;
    for (Log& log : logs_)
        log.resize(Entries);
}

// Jobs are done in their order: where no more than `Waiting` wait, that of the log to be written
// next was done before.
void MissKinds::hand_over() {
    const Log& log = logs_[written_];
    const std::size_t entries = std::exchange(noted_, 0);
    if (!thread_) return reckon(log, entries);
    written_ = (written_ + 1) % logs_.size();
    thread_->push(1, [this, &log, entries] { reckon(log, entries); });
}

void MissKinds::reckon(const Log& log, std::size_t entries) {
    for (std::size_t i = 0; i < entries; ++i)
        reckon(log[i]);
}

inline void MissKinds::reckon(std::uint64_t entry) {
    const std::uint64_t line = entry & ((std::uint64_t{1} << WhatAt) - 1);
    switch (static_cast<What>(entry >> WhatAt)) {
    case Hit:
        reckoned_.classifier.access(line);
        reckoned_.beyond_shadow += reckoned_.classifier.shadow_missed();
        break;
    case Miss: {
        const MissKind kind = reckoned_.classifier.access(line);
        ++(kind == MissKind::Compulsory ? reckoned_.compulsory
           : kind == MissKind::Capacity ? reckoned_.capacity
                                        : reckoned_.conflict);
        break;
    }
    case Drop:
        reckoned_.classifier.drop(line);
        break;
    case Flush:
        reckoned_.classifier.flush();
        break;
    }
}

void MissKinds::settle(CacheStatistics& statistics) {
    if (noted_ > 0) hand_over();
    if (thread_) thread_->drain();
    statistics.compulsory += std::exchange(reckoned_.compulsory, 0);
    statistics.capacity += std::exchange(reckoned_.capacity, 0);
    statistics.conflict += std::exchange(reckoned_.conflict, 0);
    statistics.beyond_shadow += std::exchange(reckoned_.beyond_shadow, 0);
}

} // namespace ffgpu::timing
