// A picture in which most of the pipe has a part.

#pragma once

#include "tests/gpu/scene.h"

#include <random>
#include <vector>

namespace ffgpu::test {

// Depth-tested triangles in perspective, smooth colours, a texture, blending for every other.
//
// Before each draw vary(number) may change the registers further; it gives the primitives' type.
template <class AnyScene, class Vary>
void draw_mixture(AnyScene& scene, Vary&& vary) {
    std::vector<std::uint32_t> texels;
    for (std::uint32_t i = 0; i < 64 * 64; ++i)
        texels.push_back(((i / 8 + i / 512) % 2 ? 0xff80ffffu : 0x80402010u) + i % 8);
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0xff402000);
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
    for (int draw = 0; draw < 40; ++draw) {
        std::vector<Vertex> vertices;
        const float size = draw % 4 == 0 ? 1.5f : 0.2f;
        for (int triangle = 0; triangle < 8; ++triangle) {
            const float x = unit(), y = unit();
            for (int i = 0; i < 3; ++i) {
                const float w = 1.5f + unit();
                vertices.push_back({(x + size * unit()) * w,
                                    (y + size * unit()) * w,
                                    unit() * w * 0.5f,
                                    w,
                                    unit(),
                                    unit(),
                                    unit(),
                                    0.5f + 0.5f * unit(),
                                    unit() * 4,
                                    unit() * 4});
            }
        }
        if (draw == 10) scene.texture(64, texels);
        scene.registers.blend.enable = draw % 2 == 1;
        scene.registers.blend.rgb_source = BlendFactor::SourceAlpha;
        scene.registers.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
        scene.registers.depth.write_enable = draw % 2 == 0;
        scene.registers.fragment.alpha_test = draw % 5 == 0;
        scene.registers.fragment.alpha_compare = Compare::Greater;
        scene.registers.fragment.alpha_reference = 40;
        const PrimitiveType type = vary(draw);
        scene.draw(type, vertices);
    }
}

} // namespace ffgpu::test
