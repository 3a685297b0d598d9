// PixelPlaces: where in device memory a pixel's history happens. A picture's pixel lies in a
// surface; what a copy brought there was drawn at another place before (the back buffer's, the
// samples of a multisampled one, or the pictures that a supersampled one is the mean of).

#pragma once

#include "tools/explain/frame_tape.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ffgpu::tools {

struct SurfacePixel {
    Surface surface;
    std::uint32_t x = 0, y = 0; // from the lower left

    // Of the first sample.
    std::uint64_t address() const {
        return surface.address + std::uint64_t{y} * surface.stride +
               std::uint64_t{x} * format_info(surface.format).block_bytes;
    }
    bool operator==(const SurfacePixel&) const = default;
};

// The pixel of `surface` whose first sample lies at `address`.
std::optional<SurfacePixel> pixel_at(const Surface& surface, std::uint64_t address);

// Where the copy reads what it writes to the pixel at `address`, of several pictures in the first;
// nothing: it does not write it.
std::optional<SurfacePixel> copied_from(const CopyRectangleCommand& copy, std::uint64_t address);

struct PixelPlace {
    SurfacePixel color;
    std::size_t until = 0; // The steps before this one count; it copied the pixel away, or is the
                           // frame's end.
    std::vector<SurfacePixel> depths{}; // that were drawn to together with the colour
    unsigned picture = 0, pictures = 1; // of those whose mean was copied
};

// What of a frame tells where pixels come from.
class PixelSources {
public:
    explicit PixelSources(const FrameTape& tape);

    // The picture's pixel first; each of the others was copied to one before it.
    std::vector<PixelPlace> places(const SurfacePixel& pixel) const;

private:
    std::vector<std::pair<std::size_t, CopyRectangleCommand>> copies_; // by step
    std::vector<Targets> targets_;                                     // that were drawn to
    std::size_t steps_ = 0;
};

} // namespace ffgpu::tools
