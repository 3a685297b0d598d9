// The formats of timelines: what each unit of the machine did in every cycle, and what else is told
// along. Times are cycles of the core: the cycles (begin, end] are the time from begin to end.

#pragma once

#include "model/timing/account.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/memory_request.h"
#include "tools/export/text_writer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::tools {

// Bytes that each client moved in an interval.
struct TrafficInterval {
    std::uint64_t begin = 0; // time
    std::array<std::uint64_t, timing::Clients> bytes{};
};

// Items in each queue, or on their way to it, in the mean over an interval.
struct QueueInterval {
    std::uint64_t begin = 0; // time
    std::vector<double> items;
};

class TimelineFormat {
public:
    virtual ~TimelineFormat() = default;
    // All units are idle at time 0.
    virtual void begin(const std::vector<std::string>& units) = 0;
    // By rising time.
    virtual void change(std::size_t unit, timing::Activity activity, std::uint64_t time) = 0;
    virtual void traffic(const TrafficInterval&) {}
    // Names of queues, before their first interval, and intervals behind each other.
    virtual void queues(const std::vector<std::string>&) {}
    virtual void queue_items(const QueueInterval&) {}
    virtual void frame(const timing::FrameTiming&) {}
    // Throws InputError where it cannot be written.
    virtual void end(std::uint64_t time) = 0;
};

std::unique_ptr<TimelineFormat> make_vcd(TextWriter& out);
std::unique_ptr<TimelineFormat> make_perfetto(TextWriter& out);
// To a file of its own. Throws InputError, too, where the build has no writer of FST.
std::unique_ptr<TimelineFormat> make_fst(const std::string& path);

} // namespace ffgpu::tools
