// CallLog: which call of a trace gave the device a draw. Vertices between glBegin and glEnd wait in
// the driver, and primitives that follow each other are drawn together, by a later call: the log
// notes how many vertices waited behind each call.

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

struct CallName {
    std::uint64_t number = 0;
    std::string name; // empty: there is no call, as in a capture
};

// Calls in their order, each with the vertices that waited behind it.
struct VertexCalls {
    struct Entry {
        CallName call;
        std::uint32_t vertices = 0;
    };
    std::vector<Entry> entries;

    // The call that brought vertex `vertex`; null: none of these.
    const CallName* call_of(std::uint32_t vertex) const;
};

class CallLog {
public:
    // A call is about to be played: what waits now, those before it left.
    void begin(std::uint64_t number, std::string_view name);

    const CallName& call() const { return call_; }
    // The calls of the vertices that are being drawn; null where they do not come from calls before
    // this one.
    std::shared_ptr<const VertexCalls> waiting() const;

private:
    CallName call_;
    VertexCalls waiting_;
};

} // namespace ffgpu::tools
