#include "model/timing/memory_waits.h"

#include <algorithm>

namespace ffgpu::timing {
void merge(WaitPaths& paths, Moment& last, const Moment& next) {
    const bool is_later = next.at >= last.at;
    const auto between = static_cast<float>(
        static_cast<std::int64_t>(is_later ? next.at - last.at : last.at - next.at));
    const float last_more = is_later ? between : 0, next_more = is_later ? 0 : between;
    const Saved saved = next.saved;
    for (std::size_t i = 0; i < Saved::Lanes; ++i)
        last.saved.cycles[i] =
            std::min(saved.cycles[i] + next_more, last.saved.cycles[i] + last_more);
    last.path = paths.share(is_later ? next.path : last.path);
    last.at = std::max(last.at, next.at);
}

MemoryWaits::MemoryWaits(const MemoryConfig& config, bool is_ours)
    : config_(config)
    , mapping_(config)
    , is_ours_(is_ours)
    , cycle_(static_cast<float>(16 * config.core_clocks / config.memory_clocks) / 16)
    , channels_(config.channels) {}

// Row and column, and the data.
float MemoryWaits::alone(const MemoryRequest& request) const {
    const std::uint32_t column =
        request.write ? config_.write_column_cycles : config_.column_cycles;
    const std::uint32_t spacing = config_.column_spacing();
    return cycle_ * static_cast<float>(config_.precharge_cycles + config_.row_to_column_cycles +
                                       column + spacing * config_.bursts(request.bytes));
}

// The request was there before the last answer's data had moved.
bool MemoryWaits::stood_behind(const Moment& before, Cycle asked) const {
    return asked + 2 + config_.latency <= before.at;
}

// Where it stood behind that the channel was at work all the time since; else it takes the bus for
// its data.
Dependence MemoryWaits::turn(const Moment& before,
                             const Moment* asked,
                             const MemoryRequest& request,
                             Cycle now) const {
    const auto since = static_cast<float>(now - before.at);
    const std::uint32_t spacing = config_.column_spacing();
    const float bus = cycle_ * static_cast<float>(spacing * config_.bursts(request.bytes));
    const bool behind = stood_behind(before, asked ? asked->at : request.issued);
    const float takes = behind ? since : std::min(bus, since);
    return {&before, takes, {Resource::MemoryBandwidth, takes}};
}

// Where it stood behind no other all its time at the memory is its own.
Dependence MemoryWaits::own(const Moment& before,
                            const Moment& asked,
                            const MemoryRequest& request,
                            Cycle now) const {
    const auto since = static_cast<float>(now - asked.at);
    if (!is_ours_) return {&asked, since, {Resource::MemoryLatency, since}};
    const auto latency = static_cast<float>(config_.latency);
    const float there = std::max(since - latency - 2, 0.0F);
    const float served = stood_behind(before, asked.at) ? std::min(there, alone(request)) : there;
    return {&asked,
            latency + 2 + served,
            {Resource::MemoryLatency, latency},
            {Resource::MemoryBandwidth, std::max(served - 1, 0.0F)}};
}

const Moment& MemoryWaits::answer(WaitPaths& paths,
                                  const MemoryRequest& request,
                                  const Moment* asked,
                                  Cycle now) {
    last_ = mapping_.channel(request.address);
    Channel& channel = channels_[last_];
    found_.begin(now);
    if (asked) found_.add(own(channel.last, *asked, request, now));
    if (is_ours_ || !asked) found_.add(turn(channel.last, asked, request, now));
    if (is_ours_) channel.worked += static_cast<double>(found_[found_.count() - 1].takes);
    const Dependence& last = found_.last_one();
    WaitPaths::Path path = last.moment->path;
    if (found_.last() == 0 && asked)
        path =
            paths.extend(path, Resource::MemoryLatency, now - static_cast<Cycle>(last.then.cycles));
    path = paths.extend(path, is_ours_ ? Resource::MemoryBandwidth : Resource::MemoryLatency, now);
    Saved saved;
    if (asked && is_ours_) {
        saved = channel.turns.answer(found_[0], found_[1], now, found_.has_rare());
    } else {
        found_.save(saved);
        channel.turns.note_answer(asked ? asked->at : request.issued, saved, now);
    }
    channel.last = {now, paths.share(path), saved};
    merge(paths, all_, channel.last);
    return channel.last;
}

const Moment& MemoryWaits::taken(WaitPaths& paths, const Moment& asked, Cycle now) {
    if (taken_.at < now) taken_before_ = taken_;
    const Moment& channel = channels_[last_].last;
    const auto since = static_cast<float>(now - channel.at);
    // One that goes in the cycle behind another waited for its turn, else for a place in the
    // memory. In one that serves at once there is a place, whoever was served here.
    const bool waited = now > asked.at + 1 && is_ours_;
    const Dependence other =
        taken_before_.at + 1 == now
            ? Dependence{&taken_before_, 1, {Resource::MemoryBandwidth, NoTurn}}
            : Dependence{&channel,
                         since,
                         {Resource::MemoryBandwidth, since},
                         {Resource::MemoryBandwidth, NoTurn}};
    found_.begin(now);
    found_.add({&asked, 1});
    if (waited) found_.add(other);
    const Dependence& last = found_.last_one();
    const Resource why =
        found_.last() == 1 && last.moment == &channel ? Resource::MemoryBandwidth : Resource::Links;
    const WaitPaths::Path path = paths.extend(last.moment->path, why, now);
    taken_.at = now;
    taken_.path = paths.share(path);
    found_.save(taken_.saved);
    return taken_;
}

void MemoryWaits::restart() {
    std::fill(channels_.begin(), channels_.end(), Channel{});
    all_ = taken_ = taken_before_ = {};
}

void MemoryWaits::add_heads(std::vector<WaitPaths::Path*>& heads) {
    for (Channel& channel : channels_)
        heads.push_back(&channel.last.path);
    heads.insert(heads.end(), {&all_.path, &taken_.path, &taken_before_.path});
}

} // namespace ffgpu::timing
