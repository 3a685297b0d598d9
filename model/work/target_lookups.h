// TargetLookups: what the quads of a draw ask of the caches of depth and colour: the lines that
// hold their pixels, and what they write of each.

#pragma once

#include "model/work/prepared_work.h"
#include "model/work/surface_lines.h"
#include "model/work/target_access.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

class TargetLookups {
public:
    explicit TargetLookups(const WorkConfig& config);

    // They must outlive this.
    void place_depth(const PlacedLevel& place, const DepthAccess& access) {
        depth_ = &place;
        depth_access_ = access;
    }
    void place_color(const PlacedLevel& place, PixelBytes written) {
        colors_.push_back({.place = &place, .written = written});
    }

    // Depth is read for the fragments that come to its test, `tested`, colour for those that pass
    // it. Its lines are appended to `out`.
    void add(std::uint8_t tested, PreparedQuad& quad, PreparedQuads& out);

private:
    struct Color {
        const PlacedLevel* place = nullptr;
        PixelBytes written{}; // of a sample
        WrittenQuad quad{};   // the one that is added
    };

    void add_depth(std::uint8_t tested, PreparedQuad& quad);
    void add_colors(PreparedQuad& quad);
    // The lines that hold the samples of `lanes`: most quads lie in one.
    void add_lines(const PlacedLevel& place,
                   std::uint32_t line_bytes,
                   const std::array<std::uint64_t, 4>& addresses,
                   std::uint8_t lanes) {
        const std::uint64_t last = addresses[3] + place.layout.element_bytes - 1;
        if (quotient(addresses[0], line_bytes) == quotient(last, line_bytes))
            out_->target_lines.push_back(quotient(last, line_bytes));
        else
            add_spread_lines(place, line_bytes, addresses, lanes);
    }
    void add_spread_lines(const PlacedLevel& place,
                          std::uint32_t line_bytes,
                          const std::array<std::uint64_t, 4>& addresses,
                          std::uint8_t lanes);
    WrittenBytes failed_bytes(std::uint64_t line,
                              const WrittenQuad& passed,
                              std::uint8_t tested,
                              std::uint8_t after_stencil) const;

    PreparedQuads* out_ = nullptr; // where the lines of the quad go that is added
    const bool enabled_;
    const LineGrain depth_grain_, color_grain_;
    const PlacedLevel* depth_ = nullptr;
    DepthAccess depth_access_;
    std::vector<Color> colors_;
};

} // namespace ffgpu::work
