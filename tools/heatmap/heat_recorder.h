// HeatRecorder: gathers the numbers of heat maps while a frame is drawn: from the work stream of
// the functional GPU, and from the machine in time.

#pragma once

#include "model/packets/work_stream.h"
#include "model/timing/gpu_timing.h"
#include "tools/heatmap/heat_map.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu::tools {

// A number a pixel, the top row first.
struct HeatPlane {
    unsigned width = 0, height = 0;
    std::vector<float> values;
};

// Pixels of other surfaces than the one that is shown do not count.
class HeatRecorder : public WorkSink {
public:
    // WorkSink
    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t) override {}

    // From the timing model.
    void quad_retired(const timing::QuadRetired& quad);
    // What the cycles of the frame that has ended were waited for.
    void frame_waited(std::span<const timing::WaitPaths::Run> waited);

    // The map of the frame that ended with `shown`.
    HeatPlane plane(HeatMap map, const Surface& shown) const;

    // Begins the next frame. Textures keep their numbers.
    void clear();

private:
    struct Pixel {
        std::uint32_t covered = 0, written = 0;
        std::uint32_t depth_killed = 0, stencil_killed = 0, alpha_killed = 0;
        std::uint32_t level_sum = 0, level_count = 0;
        std::uint32_t quads = 0, quad_lanes = 0; // of the quads that it lies in
        std::uint32_t texture = 0;               // of the last fragment that read one
    };
    struct Target { // one surface
        std::uint32_t width = 0, height = 0;
        std::vector<Pixel> pixels;
        Pixel* at(const WorkQuad& quad, unsigned lane);
    };
    struct QuadCost {
        std::uint64_t misses = 0, cycles = 0;
        timing::WaitedCycles waited{};
    };
    struct QuadEnd {
        std::uint32_t place = 0; // as in costs_
        std::uint64_t cycles = 0, end = 0;
    };

    std::uint32_t texture_number(const WorkDraw& draw);
    Target& target_of(const WorkDraw& draw);
    static void add_quad(Target& target, const WorkQuad& quad);
    static void add_accesses(Target& target, const WorkBatch& batch, std::uint32_t texture);
    double value(HeatMap map, const Pixel& pixel) const;
    double cost(HeatMap map, std::uint32_t x, std::uint32_t y) const;
    static double cause(const timing::WaitedCycles& waited);

    std::map<DeviceAddress, Target> targets_;
    std::map<std::uint32_t, QuadCost> costs_; // by y << 16 | x of the quad
    std::vector<QuadEnd> ends_;               // of the frame, in their order
    std::map<DeviceAddress, std::uint32_t> textures_;
};

} // namespace ffgpu::tools
