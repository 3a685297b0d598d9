// ParkedQuads: quads that looked their lines up and wait, in order, for the data: the fragment
// FIFO.

#pragma once

#include "model/timing/line_cache.h"
#include "model/timing/tokens.h"

#include <deque>

namespace ffgpu::timing {

class ParkedQuads {
public:
    explicit ParkedQuads(std::size_t capacity)
        : capacity_(capacity) {}

    bool is_full() const { return quads_.size() >= capacity_; }
    bool empty() const { return quads_.empty(); }
    void park(const QuadToken& quad, std::uint64_t ticket) { quads_.push_back({quad, ticket}); }

    const QuadToken& front() const { return quads_.front().quad; }
    bool front_has_data(const LineCache& cache) const {
        return cache.is_complete(quads_.front().ticket);
    }
    QuadToken pop() {
        const QuadToken quad = quads_.front().quad;
        quads_.pop_front();
        return quad;
    }

private:
    struct Parked {
        QuadToken quad;
        std::uint64_t ticket = 0;
    };

    std::size_t capacity_;
    std::deque<Parked> quads_;
};

// What a unit says of a cycle in which it did not work: the first reason stands.
inline void blame(Activity& reason, Activity because) {
    if (reason == Activity::Idle) reason = because;
}

} // namespace ffgpu::timing
