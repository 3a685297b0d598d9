// glBlitFramebuffer's arithmetic (EXT_framebuffer_blit): a rectangle of one surface, scaled and
// perhaps mirrored, into a rectangle of another.

#pragma once

#include "driver/images/read_target.h"

#include <cstdint>

namespace ffgpu::gl {

// Along one axis; an end before the begin mirrors.
struct BlitAxis {
    std::int64_t source_begin = 0, source_end = 0;
    std::int64_t target_begin = 0, target_end = 0;

    bool is_copy() const { // neither scaled nor mirrored
        return source_end - source_begin == target_end - target_begin && source_end > source_begin;
    }

    bool keeps_size() const { // perhaps mirrored
        const std::int64_t source = source_end - source_begin, target = target_end - target_begin;
        return source == target || source == -target;
    }

    // Where the centre of a target pixel comes from.
    double source_of(std::int64_t target) const {
        const double step = static_cast<double>(source_end - source_begin) /
                            static_cast<double>(target_end - target_begin);
        const double centre = static_cast<double>(target - target_begin) + 0.5;
        return static_cast<double>(source_begin) + centre * step;
    }
};

struct Blit {
    BlitAxis x, y;
    bool linear = false;
    PixelRectangle clip; // of the target: its scissor

    PixelRectangle source() const; // the rectangles with their ends in order
    PixelRectangle target() const; // clipped
    bool empty() const;
};

// Which bits of a depth and stencil surface are written.
struct DepthStencilMask {
    bool depth = false;
    bool stencil = false;
};

// Pixels whose source lies outside of its surface are not written.
void blit_colors(Device& device, const Surface& from, const Surface& to, const Blit& blit);
void blit_depth_stencil(Device& device,
                        const Surface& from,
                        const Surface& to,
                        const Blit& blit,
                        DepthStencilMask mask);

} // namespace ffgpu::gl
