// Quads with anything in them.

#pragma once

#include "rtl/bundles/quad.h"
#include "tests/rtl/bench/random.h"

#include <bit>
#include <cstdint>

namespace ffgpu::rtl {

inline std::uint32_t random_color(Random& random) {
    std::uint32_t color = 0;
    for (unsigned channel = 0; channel < 4; ++channel)
        color |= std::uint32_t{random.byte()} << 8 * channel;
    return color;
}

inline Quad random_quad(Random& random) {
    Quad quad{.draw = random.word(),
              .primitive = random.word(),
              .piece = random.word(),
              .x = static_cast<std::uint16_t>(random.below(4096) * 2),
              .y = static_cast<std::uint16_t>(random.below(4096) * 2),
              .live = static_cast<std::uint8_t>(random.below(16)),
              .front_facing = random.one_in(2)};
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        quad.depth[lane] = random.word() >> 8;
        quad.coverage[lane] = random.byte();
        quad.color[lane] = random_color(random);
    }
    return quad;
}

inline ShadeQuad random_shade_quad(Random& random) {
    ShadeQuad shaded{.quad = random_quad(random)};
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        shaded.primary[lane] = random_color(random);
        shaded.secondary[lane] = random_color(random) & 0xffffff;
        shaded.fog_coordinate[lane] = std::bit_cast<float>(random.word());
    }
    for (std::uint32_t& sample : shaded.samples)
        sample = random_color(random);
    return shaded;
}

} // namespace ffgpu::rtl
