// A quad of the work stream of which all covered fragments pass all tests.

#pragma once

#include "model/packets/work_stream.h"

#include <cstdint>

namespace ffgpu {

// `x`, `y`: window pixel of lane 0. It is of primitive 0.
inline WorkQuad drawn_quad(std::uint32_t x, std::uint32_t y, std::uint8_t covered = 15) {
    return {.primitive = 0,
            .x = static_cast<std::uint16_t>(x),
            .y = static_cast<std::uint16_t>(y),
            .covered = covered,
            .after_early_depth = covered,
            .after_coverage = covered,
            .after_alpha = covered,
            .after_stencil = covered,
            .after_depth = covered};
}

} // namespace ffgpu
