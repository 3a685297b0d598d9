// MemoryTrace: the requests of the machine in time, in the order in which they go to memory. It
// listens on the machine's thread and writes on one of its own; what waits between is bounded.
//
// What a screen is still reading when the last frame ends is in no statistic, nor in the trace.

#pragma once

#include "model/timing/memory_observer.h"
#include "model/timing/quad_observer.h"
#include "model/work/job_thread.h"
#include "model/work/machine_order.h"
#include "tools/export/memory_format.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace ffgpu::tools {

// Of each client.
struct ClientTraffic {
    std::uint64_t requests = 0, read_bytes = 0, written_bytes = 0;
};
using TrafficByClient = std::array<ClientTraffic, timing::Clients>;

// Where the levels of textures lie in the explored machine's memory, as draws place them; asked
// for by another thread.
class TexturePlaces {
public:
    // Of a command that `order` has carried out.
    void add(const work::WholeCommand& command, work::MachineOrder& order);
    std::optional<TexelPlace> find(std::uint64_t address) const;

private:
    struct Level {
        TexelPlace place;
        std::uint64_t end = 0;
    };

    mutable std::mutex mutex_;
    std::map<std::uint64_t, Level> levels_; // by their begin
};

class MemoryTrace final : public timing::MemoryObserver, public timing::QuadObserver {
public:
    // `line_bytes`: of the texel cache that quads see.
    MemoryTrace(std::unique_ptr<MemoryFormat> format,
                std::uint32_t line_bytes,
                const TexturePlaces& places,
                TextWriter& out);

    void sent(const timing::MemoryRequest& request, std::uint64_t cycle) override;
    void done(const timing::MemoryRequest& request, std::uint64_t cycle) override;
    void texel_line(const timing::QuadName& quad, const timing::CacheLine& line) override;

    // By the machine's thread: a frame has ended.
    void end_frame() { askers_.clear(); }
    // Throws what went wrong with writing.
    void check_failure() { writer_.check_failure(); }
    // Nothing more comes: returns when all is handed to the text writer.
    void finish();

    const TrafficByClient& traffic() const { return traffic_; }

private:
    static constexpr std::size_t Chunk = std::size_t{1} << 12;

    void hand_over(const TracedRequest& traced);
    void hand_over_known();
    void write_chunk();
    void count(const timing::MemoryRequest& request);
    std::optional<timing::QuadName> asker(const timing::MemoryRequest& request);

    std::unique_ptr<MemoryFormat> format_;
    const std::uint32_t line_bytes_;
    const TexturePlaces& places_;
    TextWriter& out_;
    TrafficByClient traffic_;
    std::deque<TracedRequest> waiting_; // from the first on that may not count
    // Whose misses were not sent yet, by address.
    std::multimap<std::uint64_t, timing::QuadName> askers_;
    std::vector<TracedRequest> chunk_;
    work::JobThread writer_; // The last: its thread uses the others.
};

} // namespace ffgpu::tools
