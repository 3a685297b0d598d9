// LineCache: tags, miss kinds and outstanding fills of one cache. The unit that owns it looks lines
// up ahead of use and parks its work in a FIFO until the fill it needs has come: misses are
// hidden, not waited for (H. Igehy, M. Eldridge, K. Proudfoot, Prefetching in a Texture Cache
// Architecture, 1998).

#pragma once

#include "model/base/statistics.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/memory_request.h"
#include "model/timing/request_port.h"
#include "model/work/miss_classifier.h"
#include "model/work/tag_array.h"

#include <deque>
#include <string>
#include <vector>

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
    Counter& compulsory = add("compulsory_misses", "lines", "misses of lines never touched before");
    Counter& capacity =
        add("capacity_misses", "lines", "misses that a fully associative cache has, too");
    Counter& conflict = add("conflict_misses", "lines", "all other misses");
    Counter& without_fetch =
        add("misses_without_fetch", "lines", "misses whose line is overwritten, not read");
    Counter& read_bytes =
        add("read_bytes", "bytes", "fetched from memory: (misses - without fetch) x line");
    Counter& written_bytes = add("written_bytes", "bytes", "written back to memory");
};

class LineCache {
public:
    LineCache(std::string_view name,
              const CacheConfig& config,
              Client client,
              RequestPort& requests);

    // Whether lookup() may be called in this cycle: its requests (a write-back and a fill) find
    // room in the channel and fewer than outstanding_lines fills are under way.
    bool can_look_up() const;

    // Looks line `number` (address / line bytes) up; a miss takes its place at once and asks for
    // the data, unless the whole line will be overwritten (`fetch` false). Returns the ticket of
    // the fill whose data the caller needs: usable once is_complete(ticket). `missed` tells.
    std::uint64_t lookup(std::uint64_t number, bool write, bool fetch, bool& missed);

    bool is_complete(std::uint64_t ticket) const { return ticket < first_incomplete_; }

    // The memory delivered the data of `ticket`.
    void complete(std::uint64_t ticket);

    // Forgets everything. Returns the numbers of the dirty lines, which the caller writes to
    // memory.
    std::vector<std::uint64_t> flush();
    // Forgets without writing back the lines of [begin, end) bytes: they are overwritten elsewhere.
    void discard(std::uint64_t begin, std::uint64_t end);

    bool all_complete() const { return first_incomplete_ == next_ticket_; }
    const CacheStatistics& statistics() const { return statistics_; }
    std::uint32_t line_bytes() const { return config_.line_bytes; }
    Client client() const { return client_; }

private:
    const CacheConfig config_;
    Client client_;
    RequestPort& requests_;
    work::TagArray tags_;
    work::MissClassifier classifier_;
    CacheStatistics statistics_;

    // Fills are numbered from 1; they may come back in any order and count in theirs (the reorder
    // buffer of the paper).
    std::uint64_t next_ticket_ = 1;
    std::uint64_t first_incomplete_ = 1;
    std::uint32_t outstanding_ = 0;
    std::deque<bool> done_; // of tickets first_incomplete_ ...
};

} // namespace ffgpu::timing
