#include "model/timing/line_cache.h"

#include "model/base/check.h"

namespace ffgpu::timing {

LineCache::LineCache(std::string_view name,
                     const CacheConfig& config,
                     Client client,
                     RequestPort& requests)
    : config_(config)
    , client_(client)
    , requests_(requests)
    , tags_(config.sets, config.ways)
    , classifier_(std::size_t{config.sets} * config.ways)
    , statistics_(name) {}

bool LineCache::can_look_up() const {
    return outstanding_ < config_.outstanding_lines && requests_.can_push(2);
}

std::uint64_t LineCache::lookup(std::uint64_t number, bool write, bool fetch, bool& missed) {
    ++statistics_.accesses;
    using work::MissKind;
    const MissKind kind = classifier_.access(number);
    if (work::TagArray::Line* line = tags_.find(number)) {
        ++statistics_.hits;
        line->dirty |= write;
        missed = false;
        return line->fill;
    }

    missed = true;
    ++statistics_.misses;
    ++(kind == MissKind::Compulsory ? statistics_.compulsory
       : kind == MissKind::Capacity ? statistics_.capacity
                                    : statistics_.conflict);

    const work::TagArray::Line evicted = tags_.victim(number);
    if (evicted.number != work::TagArray::Line::Empty && evicted.dirty) {
        statistics_.written_bytes += config_.line_bytes;
        requests_.push({.address = evicted.number * config_.line_bytes,
                        .bytes = config_.line_bytes,
                        .write = true,
                        .client = client_});
    }
    work::TagArray::Line& line = tags_.replace(number);
    line.dirty = write;
    if (!fetch) {
        ++statistics_.without_fetch;
        return line.fill = 0; // Complete from the start.
    }
    line.fill = next_ticket_++;
    done_.push_back(false);
    ++outstanding_;
    statistics_.read_bytes += config_.line_bytes;
    requests_.push({.address = number * config_.line_bytes,
                    .bytes = config_.line_bytes,
                    .write = false,
                    .client = client_,
                    .ticket = line.fill});
    return line.fill;
}

void LineCache::complete(std::uint64_t ticket) {
    check(ticket >= first_incomplete_ && ticket < next_ticket_, "a fill that nobody asked for");
    done_[ticket - first_incomplete_] = true;
    --outstanding_;
    while (!done_.empty() && done_.front()) {
        done_.pop_front();
        ++first_incomplete_;
    }
}

std::vector<std::uint64_t> LineCache::flush() {
    std::vector<std::uint64_t> dirty;
    for (work::TagArray::Line& line : tags_.lines()) {
        if (line.number != work::TagArray::Line::Empty && line.dirty) dirty.push_back(line.number);
        line = {};
    }
    statistics_.written_bytes += dirty.size() * config_.line_bytes;
    return dirty;
}

void LineCache::discard(std::uint64_t begin, std::uint64_t end) {
    for (work::TagArray::Line& line : tags_.lines()) {
        if (line.number == work::TagArray::Line::Empty) continue;
        const std::uint64_t address = line.number * config_.line_bytes;
        if (address + config_.line_bytes > begin && address < end) line = {};
    }
}

} // namespace ffgpu::timing
