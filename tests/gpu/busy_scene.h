// Two pictures in which every stage has a part that is seen: with one sample a pixel and with four.

#pragma once

#include "tests/gpu/mixture.h"

#include <array>
#include <map>

namespace ffgpu::test {

struct BusyPicture {
    std::array<std::uint64_t, 2> color{}, depth{};
    std::map<std::string, std::uint64_t> counters; // of both, as far as they are the machine's

    bool operator==(const BusyPicture&) const = default;
};

inline PrimitiveType vary_busily(Registers& registers, int draw) {
    registers.fragment.color_sum = draw % 7 == 2;
    registers.current.values[static_cast<unsigned>(Attribute::SecondaryColor)] = {
        0.3f, 0.1f, 0.4f, 0};
    registers.fog.mode = static_cast<FogMode>(draw % 4);
    registers.fog.color = 0x80c0ff;
    registers.fog.density = 0.7f;
    registers.stencil.enable = draw % 6 == 1;
    registers.stencil.front.compare_mask = 3;
    registers.stencil.front.compare = Compare::Lequal;
    registers.stencil.front.reference = 1;
    registers.stencil.front.depth_pass = StencilOp::Increment;
    registers.blend.logic_op_enable = draw == 21;
    registers.blend.logic_op = LogicOp::Xor;
    registers.primitive.polygon_smooth = draw % 9 == 4;
    registers.primitive.line_smooth = registers.primitive.point_smooth = draw % 2 == 0;
    registers.primitive.line_width = 3;
    registers.primitive.point_size = 9;
    registers.samplers[0].minify_linear = registers.samplers[0].magnify_linear = draw % 3 == 0;
    if (registers.images[0].shape.kind != TextureKind::None)
        registers.images[0].shape.kind = draw % 6 == 4 ? TextureKind::Cube : TextureKind::TwoD;
    registers.multisample.alpha_to_coverage = draw % 10 == 3;
    return draw % 11 == 5   ? PrimitiveType::Points
           : draw % 11 == 7 ? PrimitiveType::Lines
                            : PrimitiveType::Triangles;
}

// Calls watch(gpu) before anything is drawn, and finished(gpu) behind it.
template <class Watch, class Finished>
BusyPicture
draw_busy_scene(const FunctionalGpu::Config& config, Watch&& watch, Finished&& finished) {
    BusyPicture picture;
    for (unsigned sampled = 0; sampled < 2; ++sampled) {
        Scene scene(96, 80, config);
        watch(scene.gpu);
        if (sampled) {
            scene.registers.targets.color[0].samples = MaxSamples;
            scene.registers.targets.depth.samples = MaxSamples;
            scene.registers.multisample.enable = true;
        }
        draw_mixture(scene, [&](int draw) { return vary_busily(scene.registers, draw); });
        const Targets& targets = scene.registers.targets;
        const auto hash_of = [&](const Surface& surface) {
            std::vector<std::uint32_t> words(surface.bytes() / 4);
            scene.gpu.read_memory(surface.address, std::as_writable_bytes(std::span(words)));
            return hash(words);
        };
        picture.color[sampled] = hash_of(targets.color[0]);
        picture.depth[sampled] = hash_of(targets.depth);
        for (const auto& [name, value] : counters(scene.gpu))
            if (name != "batches" && name != "bins" && name != "tiles_visited")
                picture.counters[name] += value;
        finished(scene.gpu);
    }
    return picture;
}

inline BusyPicture draw_busy_scene(const FunctionalGpu::Config& config) {
    const auto nothing = [](FunctionalGpu&) {};
    return draw_busy_scene(config, nothing, nothing);
}

} // namespace ffgpu::test
