#include "model/timing/line_cache.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu::timing {

using work::TagArray;

LineCache::LineCache(std::string_view name,
                     const CacheConfig& config,
                     Client client,
                     RequestPort& requests)
    : config_(config)
    , grain_(config.line_bytes)
    , client_(client)
    , requests_(requests)
    , tags_(config.sets, config.ways, config)
    , keeps_last_(config.ports == 0 && requests.pace() != Pace::EveryCycle)
    , may_hit_at_once_(keeps_last_ && config.replacement != work::Replacement::Optimal)
    , bank_lookups_(config.banks)
    , statistics_(name)
    , kinds_(config.sets, config.ways, statistics_) {
    if (config.replacement == work::Replacement::Optimal)
        optimal_.emplace(config.sets, config.ways, config.index_hash);
}

void LineCache::begin_busy_cycle(Channel<std::uint64_t>& responses) {
    if (config_.ports > 0) std::fill(bank_lookups_.begin(), bank_lookups_.end(), 0);
    while (responses.can_pop())
        complete(responses.pop());
    while (!expanding_.empty() && expanding_.front().done_at <= requests_.now()) {
        finish(expanding_.front().ticket);
        expanding_.pop_front();
    }
    requests_.advance();
}

LookupResult LineCache::look_up_any(const LineAccess& access) {
    if (!may_hit_at_once_) return look_up_plainly(access);
    TagArray::Line* const line = tags_.find(access.number);
    if (!line || (needed(access) & ~line->valid) != 0) return look_up_plainly(access);
    tags_.use(*line);
    if (access.written != 0) write(access, *line);
    keep_last(access.number, line);
    count_look_up(access.number, false);
    return {.accepted = true, .missed = false, .ticket = line->fill};
}

LookupResult LineCache::look_up_plainly(const LineAccess& access) {
    if (config_.ports > 0 && !has_port(access.number)) return {.lacks_port = true};
    TagArray::Line* line = optimal_ ? nullptr : tags_.find(access.number);
    const LookupResult result = optimal_ ? look_up_optimal(access)
                                : line   ? look_up_present(access, *line)
                                         : look_up_absent(access, line);
    if (!result.accepted) return {};
    if (line) keep_last(access.number, line);
    if (config_.ports > 0) ++bank_lookups_[access.number & (config_.banks - 1)];
    count_look_up(access.number, result.missed);
    return result;
}

bool LineCache::has_port(std::uint64_t number) {
    if (bank_lookups_[number & (config_.banks - 1)] < config_.ports) return true;
    ++statistics_.bank_conflicts;
    return false;
}

LookupResult LineCache::look_up_present(const LineAccess& access, TagArray::Line& line) {
    const bool fetches = (needed(access) & ~line.valid) != 0;
    if (fetches && is_in_memory(access.number) && !can_fetch()) return {};
    tags_.use(line);
    if (fetches) {
        ++statistics_.partial_fetches;
        fill(access.number, line);
    }
    write(access, line);
    return {.accepted = true, .missed = false, .ticket = line.fill};
}

// `placed`: where the line is now.
LookupResult LineCache::look_up_absent(const LineAccess& access, TagArray::Line*& placed) {
    const bool fetches = needed(access) != 0;
    const bool reads = fetches && is_in_memory(access.number);
    if (reads ? !can_fetch() : !requests_.can_post()) return {};
    TagArray::Evicted evicted;
    TagArray::Line& line = tags_.replace(access.number, evicted);
    placed = &line;
    if (evicted.line.dirty != 0) post(written_back(evicted.number, evicted.line), !reads);
    if (fetches) {
        fill(access.number, line);
    } else {
        ++statistics_.without_fetch; // Complete from the start.
        lacks_bytes_ = true;
    }
    write(access, line);
    return {.accepted = true, .missed = true, .ticket = line.fill};
}

LookupResult LineCache::read_memory(std::uint64_t number) {
    if (!can_fetch()) return {};
    count_look_up(number, true);
    if (tells_kinds_) kinds_.drop(number);
    return {.accepted = true, .missed = true, .ticket = fetch(number)};
}

void LineCache::write_memory(std::uint64_t number, LineMask written) {
    const std::uint32_t bytes = moved_bytes(written & grain_.all());
    if (bytes == 0) return;
    statistics_.dirtied_bytes += grain_.count_bytes(written & grain_.all());
    statistics_.written_bytes += bytes;
    post({number, bytes, 0}, true);
}

LookupResult LineCache::look_up_optimal(const LineAccess& access) {
    check(access.written == 0, "a cache with optimal replacement is only read");
    if (const std::uint64_t* const found = optimal_->find(access.number)) {
        const std::uint64_t ticket = *found;
        optimal_->use(access.number);
        return {.accepted = true, .missed = false, .ticket = ticket};
    }
    if (!can_fetch()) return {};
    const std::uint64_t ticket = fetch(access.number);
    optimal_->replace(access.number, ticket);
    return {.accepted = true, .missed = true, .ticket = ticket};
}

// What has no bytes in memory is there at once.
void LineCache::fill(std::uint64_t number, TagArray::Line& line) {
    if (store_) store_->fetched(number, line.dirty);
    if (is_in_memory(number)) line.fill = fetch(number);
    line.valid = grain_.all();
}

// Returns the ticket.
std::uint64_t LineCache::fetch(std::uint64_t number) {
    const work::LineSource source = work::line_source(number, config_.line_bytes);
    const std::uint32_t bytes = store_ ? store_->stored_bytes(number) : source.bytes;
    fills_.push_back({.done = false, .expands = work::expansion_of(number) != 0});
    ++outstanding_;
    statistics_.read_bytes += bytes;
    requests_.post({.address = source.address,
                    .bytes = bytes,
                    .write = false,
                    .client = client_,
                    .ticket = next_ticket_},
                   true);
    return next_ticket_++;
}

void LineCache::write(const LineAccess& access, TagArray::Line& line) {
    const LineMask written = access.written & grain_.all();
    if (written == 0) return;
    if ((written & ~line.dirty) != 0)
        statistics_.dirtied_bytes += grain_.count_bytes(written & ~line.dirty);
    line.valid |= written;
    line.dirty |= written;
}

LineWrite LineCache::written_back(std::uint64_t number, const TagArray::Line& line) {
    const LineWrite back = store_ ? store_->write_back({number, line.valid, line.dirty})
                                  : LineWrite{number, moved_bytes(line.dirty), 0};
    statistics_.written_bytes += back.bytes;
    return back;
}

void LineCache::post(const LineWrite& back, bool last_of_miss) {
    MemoryRequest request{.address = back.number * config_.line_bytes,
                          .bytes = back.read_bytes,
                          .write = false,
                          .client = client_,
                          .ticket = NobodyWaits};
    if (back.read_bytes > 0) requests_.post(request, false);
    request.bytes = back.bytes;
    request.write = true;
    requests_.post(request, last_of_miss);
}

void LineCache::complete(std::uint64_t ticket) {
    if (ticket == NobodyWaits) return;
    check(ticket >= first_incomplete_ && ticket < next_ticket_, "a fill that nobody asked for");
    --outstanding_;
    if (config_.expand_cycles > 0 && fills_[ticket - first_incomplete_].expands)
        expanding_.push_back({ticket, requests_.now() + config_.expand_cycles});
    else
        finish(ticket);
}

void LineCache::finish(std::uint64_t ticket) {
    fills_[ticket - first_incomplete_].done = true;
    while (!fills_.empty() && fills_.front().done) {
        fills_.pop_front();
        ++first_incomplete_;
    }
}

std::vector<LineWrite> LineCache::flush() {
    std::vector<LineWrite> dirty;
    tags_.for_each([&](std::uint64_t number, TagArray::Line& line) {
        if (line.dirty != 0) dirty.push_back(written_back(number, line));
        tags_.drop(line);
    });
    forget_last();
    if (optimal_) optimal_->clear();
    if (tells_kinds_) kinds_.flush();
    return dirty;
}

LineWrite LineCache::overwrite(std::uint64_t number, LineMask overwritten) {
    forget_last();
    if (tells_kinds_) kinds_.drop(number);
    if (optimal_) { // It is only read.
        optimal_->drop(number);
        return {};
    }
    TagArray::Line* const line = tags_.find(number);
    if (!line) return {};
    const TagArray::Line dropped = *line;
    tags_.drop(*line);
    if (dropped.dirty == 0) return {};
    if ((overwritten & grain_.all()) != grain_.all()) return written_back(number, dropped);
    statistics_.dropped_bytes += grain_.count_bytes(dropped.dirty);
    return {};
}

std::vector<LineWrite> LineCache::invalidate(std::uint64_t begin, std::uint64_t end) {
    std::vector<LineWrite> dirty;
    if (begin >= end) return dirty;
    const std::uint64_t bytes = config_.line_bytes;
    const std::uint64_t first = begin / bytes, last = (end - 1) / bytes;
    for (std::uint64_t number = first; number <= last; ++number) {
        const auto from = static_cast<std::uint32_t>(number == first ? begin % bytes : 0);
        const auto to = static_cast<std::uint32_t>(number == last ? (end - 1) % bytes + 1 : bytes);
        const LineWrite back = overwrite(number, grain_.covered(from, to));
        if (back.bytes > 0) dirty.push_back(back);
    }
    return dirty;
}

} // namespace ffgpu::timing
