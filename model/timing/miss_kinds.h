// MissKinds: how many of a cache's misses are of which of Hill's kinds (miss_classifier.h). The
// cache writes down what it looked up and what it lost, in order; what kind each miss was is
// reckoned from that, many at a time, when the log is full or somebody asks. Most look-ups are of
// the few lines that were looked up last: these the shadow has, and only their order changes, so
// that nothing is written down of them.

#pragma once

#include "model/timing/cache_statistics.h"
#include "model/work/miss_classifier.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::timing {

// The lines that were looked up last, the last first, each in a place that it keeps.
class RecentLines {
public:
    static constexpr std::size_t Places = work::MissClassifier::FirstPlaces;

    // True: it was one of them, and is the first now.
    bool use(std::uint64_t line) {
        for (std::size_t i = 0; i < Places; ++i) {
            if (lines_[i].number != line) continue;
            put_first(i, lines_[i]);
            return true;
        }
        return false;
    }
    // One that is none of them becomes the first, in the place of the last, which is returned.
    std::size_t add(std::uint64_t line) {
        const std::size_t place = lines_.back().place;
        put_first(Places - 1, {line, place});
        return place;
    }
    void drop(std::uint64_t line) {
        for (Line& each : lines_)
            if (each.number == line) each.number = None;
    }
    void clear() {
        for (Line& each : lines_)
            each.number = None;
    }

private:
    static constexpr std::uint64_t None = ~std::uint64_t{0};
    struct Line {
        std::uint64_t number = None;
        std::size_t place = 0;
    };

    // Those before the `at`-th move back.
    void put_first(std::size_t at, Line line) {
        for (; at > 0; --at)
            lines_[at] = lines_[at - 1];
        lines_[0] = line;
    }

    std::array<Line, Places> lines_{{{None, 0}, {None, 1}, {None, 2}, {None, 3}}};
};

class MissKinds {
public:
    // What is reckoned at once, at the most.
    static constexpr std::size_t Entries = 4096;

    // Adds to the statistics' kinds of misses, and to their hits beyond the shadow.
    MissKinds(std::uint32_t sets, std::uint32_t ways, CacheStatistics& statistics)
        : classifier_(sets, ways)
        , statistics_(statistics)
        , keeps_recent_(classifier_.capacity() >= RecentLines::Places) {
        log_.reserve(Entries);
    }

    // What the cache did next; lines by number, below 2^64 - 1.
    void look_up(std::uint64_t line, bool missed) {
        if (keeps_recent_ && recent_.use(line)) {
            if (missed) count(classifier_.kind_beside_shadow());
            return;
        }
        note({line,
              missed ? Miss : Hit,
              static_cast<std::uint32_t>(keeps_recent_ ? recent_.add(line) : 0)});
    }
    void drop(std::uint64_t line) {
        recent_.drop(line);
        note({line, Drop, 0});
    }
    void flush() {
        recent_.clear();
        note({0, Flush, 0});
    }

    // All that was noted is in the statistics.
    void settle();

private:
    enum What : std::uint32_t { Hit, Miss, Drop, Flush };
    struct Entry {
        std::uint64_t line = 0;
        What what = Hit;
        std::uint32_t place = 0; // of RecentLines
    };

    void note(const Entry& entry) {
        log_.push_back(entry);
        if (log_.size() == Entries) settle();
    }
    work::MissKind access(const Entry& entry);
    void reckon(const Entry& entry);
    void count(work::MissKind kind) {
        ++(kind == work::MissKind::Compulsory ? statistics_.compulsory
           : kind == work::MissKind::Capacity ? statistics_.capacity
                                              : statistics_.conflict);
    }

    work::MissClassifier classifier_;
    CacheStatistics& statistics_;
    RecentLines recent_;
    const bool keeps_recent_; // The shadow has all that are.
    std::vector<Entry> log_;
};

} // namespace ffgpu::timing
