// RequestPort: a client's way to the memory system. It counts what is under way, so that the end of
// a frame can wait for the last write.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/in_flight.h"
#include "model/timing/memory_request.h"

namespace ffgpu::timing {

class RequestPort {
public:
    RequestPort(const Clock& clock, std::size_t capacity, InFlight& in_flight)
        : clock_(clock)
        , channel_(clock, capacity)
        , in_flight_(in_flight) {}

    bool can_push(std::size_t n = 1) const { return channel_.can_push(n); }
    void push(MemoryRequest request) {
        in_flight_.enter();
        request.issued = clock_.now();
        channel_.push(request);
    }
    // The arbiter's end.
    Channel<MemoryRequest>& channel() { return channel_; }

private:
    const Clock& clock_;
    Channel<MemoryRequest> channel_;
    InFlight& in_flight_;
};

} // namespace ffgpu::timing
