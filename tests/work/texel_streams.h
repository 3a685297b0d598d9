// The texel-cache look-ups of an analytic scene on a machine of a given shape, without a clock.

#pragma once

#include "model/work/command_assembler.h"
#include "model/work/line_replay.h"
#include "model/work/machine_order.h"
#include "tests/timing/analytic_scenes.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ffgpu::work {

struct TexelStream {
    std::vector<std::uint64_t> lines; // looked up, in order
    std::uint64_t reads = 0;          // of texels

    double
    miss_percent(std::uint32_t sets, std::uint32_t ways, const CachePolicy& policy = {}) const {
        return 100.0 * static_cast<double>(count_misses(lines, sets, ways, policy)) /
               static_cast<double>(reads);
    }
};

class TexelStreamSink final : public MachineSink {
public:
    explicit TexelStreamSink(TexelStream& stream)
        : stream_(stream) {}

    void scene(PreparedScene&& scene) override {
        for (const PreparedQuad& quad : scene.quads) {
            const auto lines = scene.lines_of(quad);
            stream_.lines.insert(stream_.lines.end(), lines.begin(), lines.end());
            stream_.reads += quad.texel_reads;
        }
    }
    void transfer(PreparedTransfer&&) override {}
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

private:
    TexelStream& stream_;
};

inline std::shared_ptr<const WorkBin> bin_of(const timing::Scene& scene) {
    return std::make_shared<const WorkBin>(timing::make_bin(scene));
}

inline TexelStream texel_stream(const std::shared_ptr<const WorkBin>& bin,
                                const WorkConfig& config) {
    TexelStream stream;
    TexelStreamSink sink(stream);
    MachineOrder order(config, sink);
    CommandAssembler assembler(order);
    assembler.bin(bin);
    assembler.end_frame(0);
    return stream;
}

} // namespace ffgpu::work
