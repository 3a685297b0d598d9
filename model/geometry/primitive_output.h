// FeedbackOutput: where primitives go instead of the rasterizer, when the draw's output is
// feedback.

#pragma once

#include "model/packets/window_vertex.h"

#include <span>

namespace ffgpu {

class FeedbackOutput {
public:
    virtual ~FeedbackOutput() = default;
    virtual void point(const WindowVertex& vertex) = 0;
    // reset: the line stipple begins anew with this line.
    virtual void line(const WindowVertex& a, const WindowVertex& b, bool reset) = 0;
    virtual void polygon(std::span<const WindowVertex* const> corners) = 0;
};

} // namespace ffgpu
