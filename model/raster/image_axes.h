// How an image's pixels lie in the window along each axis.

#pragma once

#include "model/device/commands.h"

#include <cmath>
#include <cstdint>

namespace ffgpu {

// Along one axis: which of `count` image columns (or rows) covers which point of the window.
class ZoomedAxis {
public:
    static constexpr std::int32_t Outside = -1;

    ZoomedAxis(float origin, float zoom, std::uint32_t count)
        : origin_(origin)
        , zoom_(zoom)
        , count_(count) {}

    bool empty() const {
        return count_ == 0 || zoom_ == 0.0 || !std::isfinite(zoom_) || !std::isfinite(origin_);
    }

    // The image column at the centre of pixel `at`, or `beside` (1/256 pixel) it, or Outside.
    std::int32_t source(int at, std::int32_t beside = 0) const {
        const double u = (at + (0.5 + beside / 256.0) - origin_) / zoom_;
        const double index = zoom_ > 0 ? std::floor(u) : std::ceil(u) - 1.0;
        return index >= 0.0 && index < count_ ? static_cast<std::int32_t>(index) : Outside;
    }

private:
    double origin_, zoom_;
    double count_;
};

struct ImageAxes {
    ZoomedAxis x, y;

    explicit ImageAxes(const DrawImageCommand& image)
        : x(image.x, image.zoom_x, image.width)
        , y(image.y, image.zoom_y, image.height) {}

    bool empty() const { return x.empty() || y.empty(); }
};

} // namespace ffgpu
