// DirectMemory: the way of a request to a memory of ours and back past the TLM-2.0 socket. What
// BEGIN_REQ, END_REQ and BEGIN_RESP say there is a call here, about the same request in the same
// cycle; nobody fills in or reads the attributes of a payload. Memories of the user's know the
// socket alone, and so does a machine that takes the plain form of all that has a fast one
// (Pace::EveryCycle).

#pragma once

#include <cstdint>

namespace ffgpu::timing {

struct RequestTag; // memory_payload.h

class DirectMemory {
public:
    // False: the channel has no place, and tells when it takes the request.
    virtual bool take(RequestTag& request, std::uint32_t channel) = 0;

protected:
    ~DirectMemory() = default;
};

// Who asks.
class DirectClient {
public:
    // What had found no place.
    virtual void taken(const RequestTag& request) = 0;
    virtual void done(RequestTag& request) = 0;

protected:
    ~DirectClient() = default;
};

} // namespace ffgpu::timing
