// MissKinds: how many of a cache's misses are of which of Hill's kinds (miss_classifier.h). The
// cache writes down what it looked up and what it lost, in order; what kind each miss was is
// reckoned from that when a log is full, or when somebody asks, if need be on another thread.

#pragma once

#include "model/base/cache_lines.h"
#include "model/base/check.h"
#include "model/timing/cache_statistics.h"
#include "model/work/job_thread.h"
#include "model/work/miss_classifier.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::timing {

class MissKinds {
public:
    // Jobs that wait on the thread, at the most.
    static constexpr std::size_t Waiting = 2;

    MissKinds(std::uint32_t sets, std::uint32_t ways);

    // From now on it reckons there; until then at once. `thread`, one for all caches, lets
    // `Waiting` jobs wait at the most, and ends before this.
    void reckon_on(work::JobThread& thread);

    // What the cache did next; lines by number, below 2^62.
    void look_up(std::uint64_t line, bool missed) { note(line, missed ? Miss : Hit); }
    void drop(std::uint64_t line) { note(line, Drop); }
    void flush() { note(0, Flush); }

    // Adds all that was noted since it was last called.
    void settle(CacheStatistics& statistics);

private:
    enum What : std::uint64_t { Hit, Miss, Drop, Flush };
    static constexpr unsigned WhatAt = 62;       // bits of an entry
    static constexpr std::size_t Entries = 4096; // of a log

    using Log = std::vector<std::uint64_t>; // as many entries as there is room for

    void note(std::uint64_t line, What what) {
        check(line >> WhatAt == 0, "a line's number leaves room for what happened to it");
        logs_[written_][noted_++] = line | what << WhatAt;
        if (noted_ == logs_[written_].size()) hand_over();
    }
    void hand_over();
    void reckon(const Log& log, std::size_t entries);
    void reckon(std::uint64_t entry);

    work::JobThread* thread_ = nullptr; // null: at once
    // One is written, one read, and as many as the thread lets wait are between the two.
    std::array<Log, Waiting + 2> logs_;
    std::size_t written_ = 0, noted_ = 0;

    // By the thread alone, until it has done all of its jobs.
    struct alignas(CacheLinePair) Reckoned {
        work::MissClassifier classifier;
        std::uint64_t compulsory = 0, capacity = 0, conflict = 0; // misses
        std::uint64_t beyond_shadow = 0;                          // hits
    };
    Reckoned reckoned_;
};

} // namespace ffgpu::timing
