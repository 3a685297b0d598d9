// ParkedQuads: quads that looked their lines up and wait, in order, for the data: the fragment
// FIFO.

#pragma once

#include "model/base/ring.h"
#include "model/timing/line_cache.h"
#include "model/timing/passage.h"
#include "model/timing/tokens.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

class ParkedQuads {
public:
    explicit ParkedQuads(std::size_t capacity)
        : capacity_(capacity) {}

    bool is_full() const { return quads_.size() >= capacity_; }
    bool empty() const { return quads_.empty(); }
    void park(const QuadToken& quad, std::uint64_t ticket) {
        quads_.push_back({quad, ticket});
        ++passage_.entered;
    }
    // The quad that is parked next waited for that one, the `item`-th of all, to be stored.
    void wait_behind(std::uint32_t item) {
        passage_.behind = item + 1;
        ++passage_.waited;
    }
    // Lines of the quad that is parked next.
    void count_look_up(std::uint32_t lines = 1) { passage_.looked_up += lines; }

    std::size_t size() const { return quads_.size(); }
    std::uint64_t front_ticket() const { return quads_.front().ticket; }
    const QuadToken& front() const { return quads_.front().quad; }
    bool front_has_data(const LineCache& cache) const {
        return cache.is_complete(quads_.front().ticket);
    }
    // Until something comes: nothing to send on.
    bool rests(const LineCache& cache) const { return empty() || !front_has_data(cache); }
    QuadToken pop() {
        const QuadToken quad = quads_.front().quad;
        passage_.leave(quads_.front().ticket);
        quads_.pop_front();
        return quad;
    }

    const Passage& passage() const { return passage_; }
    std::size_t capacity() const { return capacity_; }

private:
    struct Parked {
        QuadToken quad;
        std::uint64_t ticket = 0;
    };

    std::size_t capacity_;
    Ring<Parked> quads_;
    Passage passage_;
};

// The way through the lines of one quad, one look-up after the other.
struct LineWalk {
    std::size_t next = 0;     // line to look up
    std::uint64_t ticket = 0; // of the last fill that the quad waits for

    bool missed = false;     // the last look-up
    bool lacks_port = false; // and was refused therefore

    // False where the cache takes no look-up, or not this one, in this cycle.
    bool look_up(LineCache& cache, const LineAccess& access) {
        const LookupResult result = cache.look_up(access);
        lacks_port = result.lacks_port;
        if (!result.accepted) return false;
        missed = result.missed;
        ticket = std::max(ticket, result.ticket);
        ++next;
        return true;
    }

    // The same past the cache.
    bool read(LineCache& cache, std::uint64_t number) {
        const LookupResult result = cache.read_memory(number);
        if (!result.accepted) return false;
        missed = result.missed;
        ticket = std::max(ticket, result.ticket);
        ++next;
        return true;
    }

    // Begins with the next quad; returns the ticket of this one.
    std::uint64_t end() {
        next = 0;
        return std::exchange(ticket, 0);
    }
};

// What a unit says of a cycle in which it did not work: the first reason stands.
inline void blame(Activity& reason, Activity because) {
    if (reason == Activity::Idle) reason = because;
}

} // namespace ffgpu::timing
