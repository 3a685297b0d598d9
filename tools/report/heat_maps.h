// Heat maps: pictures of numbers. Overdraw and level of detail come from the functional work
// stream, texture misses and cycles from the timing model. docs/command_line.md gives the scales.

#pragma once

#include "model/packets/work_stream.h"
#include "model/timing/gpu_timing.h"
#include "tools/image/image.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

enum class HeatMap : std::uint8_t { Overdraw, Level, TextureMisses, Cycles, Count };

struct HeatMapInfo {
    std::string_view name;
    double full_scale; // the value at the ramp's hot end
    bool needs_timing;
};
constexpr std::array<HeatMapInfo, static_cast<std::size_t>(HeatMap::Count)> HeatMapTable{{
    {"overdraw", 8, false},
    {"level", 8, false},
    {"texture_misses", 16, true},
    {"cycles", 32, true},
}};
constexpr const HeatMapInfo& info(HeatMap map) {
    return HeatMapTable[static_cast<std::size_t>(map)];
}

// "overdraw,level" -> the maps. Throws InputError for an unknown name, with the nearest one.
std::set<HeatMap> parse_heat_maps(const std::string& names);

// Black, blue, cyan, green, yellow, red, white in equal steps for 0 to 1; beyond 1 white.
std::array<std::uint8_t, 3> heat_color(double value);

// Gathers a frame's numbers. Pixels of other surfaces than the one that is shown do not count.
class HeatMapRecorder : public WorkSink {
public:
    // WorkSink
    void bin(std::shared_ptr<const WorkBin> bin) override;
    void end_frame(std::uint32_t) override {}

    // From the timing model.
    void quad_retired(const timing::QuadRetired& quad);

    // The map of the frame that ended with `shown`, its top row first.
    Image image(HeatMap map, const Surface& shown) const;

    // Begins the next frame.
    void clear();

private:
    struct Pixel {
        std::uint32_t fragments = 0;
        std::uint32_t level_sum = 0, level_count = 0;
    };
    struct Plane { // of one surface
        std::uint32_t width = 0, height = 0;
        std::vector<Pixel> pixels;
    };
    struct QuadCost {
        std::uint64_t misses = 0, cycles = 0;
    };

    Plane& plane_of(const WorkDraw& draw);
    void add(Plane& plane, const WorkBatch& batch);
    double value(HeatMap map, const Plane& plane, std::uint32_t x, std::uint32_t y) const;

    std::map<DeviceAddress, Plane> planes_;
    std::map<std::uint32_t, QuadCost> costs_; // by y << 16 | x of the quad
};

} // namespace ffgpu::tools
