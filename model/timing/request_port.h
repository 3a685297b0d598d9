// RequestPort: a client's way to the memory system: the request queue, and before it the miss queue
// of what did not find a place there. It counts what is under way, so that the end of a frame can
// wait for the last write.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/in_flight.h"
#include "model/timing/memory_request.h"

namespace ffgpu::timing {

class RequestPort {
public:
    // `misses`: places of the miss queue.
    RequestPort(const Clock& clock,
                std::size_t requests,
                InFlight& in_flight,
                std::size_t misses = 1)
        : clock_(clock)
        , channel_(clock, requests)
        , in_flight_(in_flight)
        , misses_(misses) {}

    Cycle now() const { return clock_.now(); }
    Pace pace() const { return clock_.pace(); }

    bool can_push(std::size_t n = 1) const { return channel_.can_push(n); }
    void push(MemoryRequest request) {
        in_flight_.enter();
        request.issued = clock_.now();
        channel_.push(request);
    }

    // A miss posts one or two requests; its place is free again when the last has left.
    bool can_post() const { return waiting_misses_ < misses_; }
    void post(MemoryRequest request, bool last_of_miss) {
        in_flight_.enter();
        request.issued = clock_.now();
        if (waiting_.empty() && channel_.can_push()) return channel_.push(request);
        waiting_.push_back({request, last_of_miss});
        waiting_misses_ += last_of_miss;
        advance();
    }
    // Once a cycle, and whenever something was posted.
    void advance() {
        while (!waiting_.empty() && channel_.can_push()) {
            waiting_misses_ -= waiting_.front().last_of_miss;
            channel_.push(waiting_.front().request);
            waiting_.pop_front();
        }
    }
    std::size_t waiting() const { return waiting_.size(); }
    bool nothing_waits() const { return waiting_.empty(); }

    // The arbiter's end.
    Channel<MemoryRequest>& channel() { return channel_; }

private:
    struct Waiting {
        MemoryRequest request;
        bool last_of_miss = true;
    };

    const Clock& clock_;
    Channel<MemoryRequest> channel_;
    InFlight& in_flight_;
    Ring<Waiting> waiting_;
    std::size_t misses_;
    std::size_t waiting_misses_ = 0;
};

} // namespace ffgpu::timing
