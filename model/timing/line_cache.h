// LineCache: tags, counts and outstanding fills of one cache. The unit that owns it looks lines
// up ahead of use and parks its work in a FIFO until the fill it needs has come: misses are
// hidden, not waited for (H. Igehy, M. Eldridge, K. Proudfoot, Prefetching in a Texture Cache
// Architecture, 1998).
//
// A line knows which of its bytes are valid and which are dirty. A write without fetch makes valid
// what it writes; a read of other bytes fetches the line, which keeps its dirty bytes. What is
// written back are the dirty bytes, in pieces of transfer_bytes.

#pragma once

#include "model/base/ring.h"
#include "model/timing/cache_statistics.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/line_store.h"
#include "model/timing/memory_request.h"
#include "model/timing/miss_kinds.h"
#include "model/timing/request_port.h"
#include "model/work/line_mask.h"
#include "model/work/optimal_tags.h"
#include "model/work/tag_array.h"
#include "model/work/texel_line.h"

#include <optional>
#include <vector>

namespace ffgpu::timing {

using work::LineMask;

// One look-up: the line's number (address / line bytes) and what of it is read and written.
struct LineAccess {
    static constexpr LineMask Whole = ~LineMask{0};

    std::uint64_t number = 0;
    LineMask read = Whole;
    LineMask written = 0; // bits of which a byte is written
    LineMask covered = 0; // bits of which all bytes are
};

struct LookupResult {
    bool accepted = false; // false: nothing happened; ask again in a later cycle
    bool missed = false;
    bool lacks_port = false;  // which is why it was not accepted
    std::uint64_t ticket = 0; // of the fill that brings what is read
};

class LineCache {
public:
    LineCache(std::string_view name,
              const CacheConfig& config,
              Client client,
              RequestPort& requests);

    // From now on `store` says what a line's way from and to memory costs; null: its bytes.
    void set_store(LineStore* store) { store_ = store; }

    // Misses are only counted, not by kind.
    void leave_out_kinds() { tells_kinds_ = false; }

    // The owner calls it first in each cycle: ports are free again, fills have come, requests that
    // waited go out.
    void begin_cycle(Channel<std::uint64_t>& responses) {
        if (config_.ports == 0 && !responses.can_pop() && rests()) return;
        begin_busy_cycle(responses);
    }

    // Looks a line up. A miss takes its place at once and asks for the data if bytes are needed
    // that the access does not write. A hit needs only a port of its bank; what fetches needs a
    // place in the miss queue and fewer than outstanding_lines fills under way, too. The data are
    // usable once is_complete(ticket).
    LookupResult look_up(const LineAccess& access) {
        return repeats_last(access) ? look_up_last(access) : look_up_any(access);
    }

    // Past the cache (CacheConfig::enable is off): a read of the line's bytes, and the store of
    // some of them, which waits for nobody.
    LookupResult read_memory(std::uint64_t number);
    void write_memory(std::uint64_t number, LineMask written);
    bool is_enabled() const { return config_.enable; }

    bool is_complete(std::uint64_t ticket) const { return ticket < first_incomplete_; }

    // Until an answer comes begin_cycle() does nothing.
    bool rests() const { return expanding_.empty() && requests_.nothing_waits(); }

    // Lines have come that take some cycles to expand.
    bool expands_lines() const { return !expanding_.empty(); }

    // The memory delivered the data of `ticket`.
    void complete(std::uint64_t ticket);

    // Some line came without a fetch: what is read of it may have to be.
    bool lacks_bytes() const { return lacks_bytes_; }

    // Forgets everything. Returns the dirty lines, which the caller writes to memory.
    std::vector<LineWrite> flush();

    // Bytes `overwritten` of a line change in memory behind the cache's back: the line is
    // forgotten. Returns what of it has to be written first: nothing (no bytes) where it was clean
    // or is overwritten from end to end.
    LineWrite overwrite(std::uint64_t number, LineMask overwritten);
    // The same for the lines of [begin, end) bytes of memory.
    std::vector<LineWrite> invalidate(std::uint64_t begin, std::uint64_t end);

    // Nothing is on its way to or from memory.
    bool all_complete() const {
        return first_incomplete_ == next_ticket_ && requests_.nothing_waits();
    }
    // What is under way, for people.
    std::string state() const;
    // Of all look-ups up to now.
    const CacheStatistics& statistics() const {
        kinds_.settle();
        return statistics_;
    }
    std::uint32_t line_bytes() const { return config_.line_bytes; }
    const work::LineGrain& grain() const { return grain_; }
    std::uint32_t moved_bytes(LineMask bytes) const {
        return grain_.moved_bytes(bytes, config_.transfer_bytes);
    }
    Client client() const { return client_; }

private:
    void begin_busy_cycle(Channel<std::uint64_t>& responses);
    // Often a look-up is of the line of the one before, which has all that is wanted. It moves no
    // line in any order, so that what is left of it are counters and bytes. look_up_any() would do
    // the same.
    bool repeats_last(const LineAccess& access) const {
        return access.number == last_number_ && (needed(access) & ~last_line_->valid) == 0;
    }
    LookupResult look_up_last(const LineAccess& access) {
        ++statistics_.accesses;
        ++statistics_.hits;
        if (outstanding_ > 0) ++statistics_.under_miss;
        if (access.written != 0) write(access, *last_line_);
        return {.accepted = true, .missed = false, .ticket = last_line_->fill};
    }
    // A hit that costs no port by the shortest way, all else plainly.
    LookupResult look_up_any(const LineAccess& access);
    LookupResult look_up_plainly(const LineAccess& access);
    void keep_last(std::uint64_t number, work::TagArray::Line* line) {
        if (!keeps_last_) return;
        last_number_ = number;
        last_line_ = line;
    }
    void forget_last() { last_number_ = work::TagArray::Empty; }

    void finish(std::uint64_t ticket);
    bool has_port(std::uint64_t number);
    bool can_fetch() const {
        return outstanding_ < config_.outstanding_lines && requests_.can_post();
    }
    // Bytes that the line must hold: what is read, what a write covers in part, and with fetch on
    // write the whole line.
    LineMask needed(const LineAccess& access) const {
        if (access.written == 0) return access.read & grain_.all();
        const bool fetches =
            config_.write_miss == WriteMiss::FetchOnWrite && access.covered != grain_.all();
        const LineMask needed = access.read | (access.written & ~access.covered);
        return fetches ? grain_.all() : needed & grain_.all();
    }
    LookupResult look_up_present(const LineAccess& access, work::TagArray::Line& line);
    LookupResult look_up_absent(const LineAccess& access, work::TagArray::Line*& placed);
    LookupResult look_up_optimal(const LineAccess& access);
    void fill(std::uint64_t number, work::TagArray::Line& line);
    std::uint64_t fetch(std::uint64_t number);
    void write(const LineAccess& access, work::TagArray::Line& line);
    void count_look_up(std::uint64_t number, bool missed) {
        ++statistics_.accesses;
        ++(missed ? statistics_.misses : statistics_.hits);
        if (!missed && outstanding_ > 0) ++statistics_.under_miss;
        if (tells_kinds_) kinds_.look_up(number, missed);
    }
    LineWrite written_back(std::uint64_t number, const work::TagArray::Line& line);
    void post(const LineWrite& back, bool last_of_miss);
    bool is_in_memory(std::uint64_t number) const {
        return !store_ || store_->stored_bytes(number) > 0;
    }

    const CacheConfig config_;
    const work::LineGrain grain_;
    Client client_;
    RequestPort& requests_;
    LineStore* store_ = nullptr;
    work::TagArray tags_;
    std::optional<work::OptimalTags> optimal_; // in the place of tags_
    bool tells_kinds_ = true;
    // Of the last look-up that was accepted, while the line is there. Kept where a look-up costs no
    // port, and the cache has its lines in tags_.
    const bool keeps_last_;
    bool lacks_bytes_ = false;
    const bool may_hit_at_once_;
    std::uint64_t last_number_ = work::TagArray::Empty;
    work::TagArray::Line* last_line_ = nullptr;
    std::vector<std::uint32_t> bank_lookups_; // in this cycle
    CacheStatistics statistics_;
    mutable MissKinds kinds_; // in the statistics when somebody asks

    static constexpr std::uint64_t NobodyWaits = 0; // the ticket of a read that completes a write

    // Fills are numbered from 1; they may come back in any order and count in theirs (the reorder
    // buffer of the paper).
    std::uint64_t next_ticket_ = 1;
    std::uint64_t first_incomplete_ = 1;
    std::uint32_t outstanding_ = 0;
    struct Fill {
        bool done = false;
        bool expands = false; // blocks to texels, which takes expand_cycles
    };
    struct Expanding {
        std::uint64_t ticket = 0;
        Cycle done_at = 0;
    };
    Ring<Fill> fills_; // of tickets first_incomplete_ ...
    Ring<Expanding> expanding_;
};

} // namespace ffgpu::timing
