// Where planes are asked.

#pragma once

#include "tests/rtl/bench/random.h"

#include <cstdint>

namespace ffgpu::rtl {

// Pixels from a reference pixel, near or as far as windows go.
inline std::int16_t random_offset(Random& random) {
    const std::uint32_t most = random.one_in(4) ? 16384 : 64;
    return static_cast<std::int16_t>(static_cast<int>(random.below(2 * most)) -
                                     static_cast<int>(most));
}

} // namespace ffgpu::rtl
