// How many fragments a line makes along its major axis: geometry counts the line stipple on with
// it from segment to segment, rasterization begins with the same columns.
//
// The diamond-exit rule (GL 1.5, 3.4.1) with its perturbation of end points by (-e, -e^2): a column
// counts where the line crosses its centre, or where it only leaves the diamond after it.

#pragma once

#include "model/device/layout/limits.h"
#include "model/packets/window_vertex.h"

#include <cstdint>
#include <cstdlib>

namespace ffgpu {

// A line in axes along (u) and across (v) its major direction, 24.8.
struct MajorLine {
    bool x_major;
    std::int32_t from_u, from_v, to_u, to_v;

    int direction() const { return to_u >= from_u ? 1 : -1; }
};

inline MajorLine major_line(const WindowVertex& a, const WindowVertex& b) {
    const bool x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    return x_major ? MajorLine{true, a.x, a.y, b.x, b.y} : MajorLine{false, a.y, a.x, b.y, b.x};
}

// The pixel of a coordinate that the perturbation moved down by next to nothing.
inline int perturbed_pixel(std::int32_t at) {
    return (at - 1) >> SubPixelBits;
}

// Position inside the perturbed pixel relative to its centre, in 1/256: -127 to 128.
inline std::int32_t from_pixel_centre(std::int32_t at) {
    constexpr std::int32_t Half = 1 << (SubPixelBits - 1);
    return at - ((perturbed_pixel(at) * (1 << SubPixelBits)) + Half);
}

// Inside the open diamond |u| + |v| < 1/2 around the centre of the point's own pixel. On its
// boundary the perturbation decides, that of x first.
inline bool inside_diamond(bool x_major, std::int32_t at_u, std::int32_t at_v) {
    constexpr std::int32_t Half = 1 << (SubPixelBits - 1);
    const std::int32_t u = from_pixel_centre(at_u), v = from_pixel_centre(at_v);
    const std::int32_t distance = std::abs(u) + std::abs(v);
    if (distance != Half) return distance < Half;
    const std::int32_t x = x_major ? u : v, y = x_major ? v : u;
    return x != 0 ? x > 0 : y > 0;
}

struct LineColumns {
    int first, last; // in the line's direction
    int count;       // 0: none
};

inline LineColumns line_columns(const MajorLine& line) {
    const int direction = line.direction();
    const auto before_centre = [direction](std::int32_t u) {
        return direction > 0 ? from_pixel_centre(u) <= 0 : from_pixel_centre(u) > 0;
    };
    const bool misses_first =
        !before_centre(line.from_u) && !inside_diamond(line.x_major, line.from_u, line.from_v);
    const bool misses_last =
        before_centre(line.to_u) || inside_diamond(line.x_major, line.to_u, line.to_v);
    const int first = perturbed_pixel(line.from_u) + (misses_first ? direction : 0);
    const int last = perturbed_pixel(line.to_u) - (misses_last ? direction : 0);
    const int count = (last - first) * direction + 1;
    return {first, last, count > 0 ? count : 0};
}

// The whole width of a line that is not smooth, in pixels.
inline int line_pixels_across(float width) {
    constexpr float Largest = 1024;
    if (!(width > 1)) return 1;
    return static_cast<int>((width < Largest ? width : Largest) + 0.5f);
}

} // namespace ffgpu
