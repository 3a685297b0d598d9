#include "model/timing/texel_l2.h"

#include "model/timing/parked_quads.h"

#include <algorithm>

namespace ffgpu::timing {

TexelL2::TexelL2(sc_core::sc_module_name name,
                 const Clock& clock,
                 const TexelL2Config& config,
                 const Ports& ports,
                 InFlight& memory_in_flight)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , memory_in_flight_(memory_in_flight)
    , queues_(ports.first_level.size()) {}

// The link carries the oldest request's data once they are there, and those of the next ones beside
// them where it is that wide.
bool TexelL2::answer(std::size_t client, Activity& reason) {
    Queue& queue = queues_[client];
    bool worked = false;
    for (std::uint32_t room = config_.bytes_per_cycle; !queue.waiting.empty(); worked = true) {
        const Waiting& oldest = queue.waiting.front();
        if (worked && oldest.bytes > room) break;
        if (queue.transfer_cycles_left == 0) {
            if (!ports_.memory.cache.is_complete(oldest.ticket)) {
                blame(reason, Activity::StalledMemory);
                break;
            }
            const std::uint32_t width = config_.bytes_per_cycle;
            queue.transfer_cycles_left = (oldest.bytes + width - 1) / width;
        }
        queue.passage.worked += !worked; // A cycle of the link, however many it answers.
        room -= std::min(room, oldest.bytes);
        if (--queue.transfer_cycles_left > 0) return true;
        ports_.first_level[client]->responses.push(oldest.request);
        memory_in_flight_.leave();
        queue.passage.leave(oldest.ticket);
        queue.waiting.pop_front();
    }
    return worked;
}

bool TexelL2::look_up(std::size_t client, Activity& reason) {
    Channel<MemoryRequest>& requests = ports_.first_level[client]->requests.channel();
    Queue& queue = queues_[client];
    if (!requests.can_pop()) return false;
    if (queue.waiting.size() == config_.queue) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const MemoryRequest& request = requests.front();
    const LookupResult result =
        ports_.memory.cache.look_up({.number = quotient(request.address, config_.line_bytes)});
    if (!result.accepted) {
        blame(reason, Activity::StalledRequests);
        return false;
    }
    queue.waiting.push_back({result.ticket, request.ticket, request.bytes});
    ++queue.passage.entered;
    ++queue.passage.looked_up;
    requests.pop();
    return true;
}

Activity TexelL2::step() {
    ports_.memory.cache.begin_cycle(ports_.memory.responses);
    Activity reason = Activity::Idle;
    bool worked = false;
    for (std::size_t client = 0; client < queues_.size(); ++client)
        worked |= answer(client, reason);
    // The caches take turns at the tags.
    std::uint32_t lookups_left = config_.lookups_per_cycle;
    for (bool any = true; any && lookups_left > 0;) {
        any = false;
        for (std::size_t i = 0; i < queues_.size() && lookups_left > 0; ++i) {
            if (!look_up((first_ + i) % queues_.size(), reason)) continue;
            any = worked = true;
            --lookups_left;
        }
    }
    if (!worked) return reason;
    first_ = (first_ + 1) % queues_.size();
    return Activity::Busy;
}

} // namespace ffgpu::timing
