// MissKinds: how many of a cache's misses are of which of Hill's kinds (miss_classifier.h). The
// cache writes down what it looked up and what it lost, in order; what kind each miss was is
// reckoned from that, many at a time, when the log is full or somebody asks.

#pragma once

#include "model/base/check.h"
#include "model/timing/cache_statistics.h"
#include "model/work/miss_classifier.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::timing {

class MissKinds {
public:
    // Look-ups that are reckoned at once, at the most.
    static constexpr std::size_t Entries = 4096;

    // Adds to the statistics' kinds of misses, and to their hits beyond the shadow.
    MissKinds(std::uint32_t sets, std::uint32_t ways, CacheStatistics& statistics)
        : classifier_(sets, ways)
        , statistics_(statistics) {
        log_.reserve(Entries);
    }

    // What the cache did next; lines by number, below 2^62.
    void look_up(std::uint64_t line, bool missed) { note(line, missed ? Miss : Hit); }
    void drop(std::uint64_t line) { note(line, Drop); }
    void flush() { note(0, Flush); }

    // All that was noted is in the statistics.
    void settle();

private:
    enum What : std::uint64_t { Hit, Miss, Drop, Flush };
    static constexpr unsigned WhatAt = 62; // bits of an entry

    void note(std::uint64_t line, What what) {
        check(line >> WhatAt == 0, "a line's number leaves room for what happened to it");
        log_.push_back(line | what << WhatAt);
        if (log_.size() == Entries) settle();
    }
    void reckon(std::uint64_t entry);
    void count(work::MissKind kind);

    work::MissClassifier classifier_;
    CacheStatistics& statistics_;
    std::vector<std::uint64_t> log_;
};

} // namespace ffgpu::timing
