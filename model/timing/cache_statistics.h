// What a cache counts. hits + misses = accesses; compulsory + capacity + conflict = misses;
// read bytes = (misses - without fetch + partial fetches) x line.

#pragma once

#include "model/base/statistics.h"

#include <deque>
#include <string>

namespace ffgpu::timing {

// Names carry the cache's: texel_cache_hits ...
class CacheStatistics : public StatisticsGroup {
    std::string prefix_;
    std::deque<std::string> names_;

    Counter& add(const char* name, const char* unit, const char* meaning) {
        return count(names_.emplace_back(prefix_ + '_' + name), unit, meaning);
    }

public:
    explicit CacheStatistics(std::string_view cache)
        : prefix_(cache) {}

    Counter& accesses =
        add("accesses", "lines", "lookups, after a quad's reads of one line are merged");
    Counter& hits = add("hits", "lines", "lookups that found their line");
    Counter& misses = add("misses", "lines", "lookups that did not");
    Counter& compulsory = add("compulsory_misses",
                              "lines",
                              "misses of lines not touched before, or not since they were flushed "
                              "or discarded");
    Counter& capacity = add("capacity_misses",
                            "lines",
                            "misses that a fully associative LRU cache of the size has, too; all "
                            "others of a fully associative cache");
    Counter& conflict = add("conflict_misses", "lines", "all other misses");
    Counter& beyond_shadow = add(
        "hits_beyond_lru", "lines", "hits where a fully associative LRU cache of the size misses");
    Counter& under_miss = add("hits_under_miss", "lines", "hits while a fill was under way");
    Counter& bank_conflicts =
        add("bank_conflicts", "lines", "lookups put off because their bank had no port left");
    Counter& without_fetch =
        add("misses_without_fetch", "lines", "misses whose line is written and not read");
    Counter& partial_fetches =
        add("partial_fetches", "lines", "hits that read bytes which the line did not hold yet");
    Counter& read_bytes =
        add("read_bytes", "bytes", "fetched: (misses - without fetch + partial fetches) x line");
    Counter& dirtied_bytes = add("dirtied_bytes", "bytes", "of lines that became dirty");
    Counter& dropped_bytes =
        add("dropped_bytes", "bytes", "dirty, of lines that a clear, a copy or the host overwrote");
    Counter& written_bytes = add(
        "written_bytes", "bytes", "written back: the pieces of transfer_bytes that were dirtied");
};

} // namespace ffgpu::timing
