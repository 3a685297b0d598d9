// A mean of colours with integer weights, rounded once.

#pragma once

#include "model/base/check.h"
#include "model/texture/filter.h"

#include <array>
#include <cstdint>

namespace ffgpu {

class WeightedMean {
public:
    void add(const Rgba& color, std::uint32_t by) {
        for (unsigned channel = 0; channel < 4; ++channel)
            sums_[channel] += by * color[channel];
        weight_ += by;
    }

    // Halves up. Something has been added, with a weight.
    Rgba mean() const {
        check(weight_ > 0, "a mean of something");
        Rgba color{};
        for (unsigned channel = 0; channel < 4; ++channel)
            color[channel] = static_cast<std::uint8_t>((sums_[channel] + weight_ / 2) / weight_);
        return color;
    }

private:
    std::array<std::uint32_t, 4> sums_{};
    std::uint32_t weight_ = 0;
};

} // namespace ffgpu
