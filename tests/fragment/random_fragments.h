// Random register states, batches and memories for the fragment tests: raw draws of a seeded
// generator, so that every machine tests the same cases.

#pragma once

#include "model/fragment/fragment_pipe.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

namespace ffgpu::test {

class Draws {
public:
    explicit Draws(std::uint32_t seed)
        : generator_(seed) {}

    std::uint32_t bits() { return static_cast<std::uint32_t>(generator_()); }
    std::uint32_t below(std::uint32_t limit) { return bits() % limit; }
    bool coin() { return (bits() >> 13 & 1) != 0; }
    bool one_in(std::uint32_t n) { return below(n) == 0; }

    template <class Enum>
    Enum value_below(std::uint32_t limit) {
        return static_cast<Enum>(below(limit));
    }

private:
    std::mt19937 generator_;
};

// 0 and 255 come up more often than by chance: the edges are where rounding goes wrong.
inline std::uint16_t random_channel(Draws& draws) {
    const std::uint32_t bits = draws.bits();
    if (bits >> 29 == 0) return 0;
    if (bits >> 29 == 1) return 255;
    return static_cast<std::uint16_t>(bits & 255);
}

inline void randomize(Draws& draws, ColorPlanes& planes) {
    for (auto* plane : {&planes.r, &planes.g, &planes.b, &planes.a})
        for (std::uint16_t& value : *plane)
            value = random_channel(draws);
}

inline float random_coordinate(Draws& draws) {
    switch (draws.below(16)) {
    case 0:
        return 0.0f;
    case 1:
        return std::bit_cast<float>(draws.bits()); // anything, NaN and infinity included
    default:
        return static_cast<float>(draws.below(1u << 16)) / 4096.0f - 2.0f;
    }
}

// --- Surfaces and their memory ------------------------------------------------------------------

constexpr std::uint16_t TileSize = 32;

struct Scene {
    std::vector<std::byte> memory;
    std::shared_ptr<Registers> registers = std::make_shared<Registers>();
    DrawState state;
    std::shared_ptr<const SampleDepths> sample_depths; // of the batch

    FragmentPipe compile(const FragmentStages& stages = FastFragmentStages) {
        state.registers = registers;
        return compile_fragment_pipe(state, memory, stages);
    }
};

inline Surface
place_surface(Draws& draws, Format format, std::uint8_t samples, std::uint32_t& end) {
    Surface surface{.format = format,
                    .width = static_cast<std::uint16_t>(TileSize - 1 + draws.below(3)),
                    .height = static_cast<std::uint16_t>(TileSize - 1 + draws.below(3))};
    surface.address = end + draws.below(8) * 4;
    surface.stride = row_bytes(format, surface.width) + draws.below(4) * 4;
    surface.samples = samples;
    end = surface.address + static_cast<std::uint32_t>(surface.bytes()) + 64;
    return surface;
}

inline Format random_color_format(Draws& draws) {
    if (draws.coin()) return Format::Rgba8;
    return draws.value_below<Format>(static_cast<std::uint32_t>(Format::Rgb5a1) + 1); // or None
}

inline void place_targets(Draws& draws, Scene& scene) {
    constexpr Format DepthFormats[] = {Format::Depth24Stencil8, Format::Depth16, Format::None};
    Targets& targets = scene.registers->targets;
    std::uint32_t end = 64;
    const std::uint8_t samples = draws.one_in(3) ? MaxSamples : 1;
    const auto place = [&](Format format) { return place_surface(draws, format, samples, end); };
    targets.color[0] = place(random_color_format(draws));
    targets.color[1] = draws.one_in(4) ? place(random_color_format(draws)) : Surface{};
    targets.depth = place(DepthFormats[draws.below(3)]);
    scene.state.samples = samples;
    std::uint16_t width = TileSize, height = TileSize;
    Targets::for_each(targets, [&](const Surface& surface) {
        if (surface.format == Format::None) return;
        width = std::min(width, surface.width);
        height = std::min(height, surface.height);
    });
    scene.registers->scissor = {.x = 0, .y = 0, .width = width, .height = height};
    scene.memory.resize(end);
    for (std::byte& byte : scene.memory)
        byte = static_cast<std::byte>(draws.bits() >> 11);
}

// --- Registers ----------------------------------------------------------------------------------

inline CombineHalf random_half(Draws& draws, bool alpha) {
    CombineHalf half;
    half.op = draws.value_below<CombineOp>(13);
    half.scale_shift = static_cast<std::uint8_t>(draws.below(3));
    for (CombineArgument& argument : half.arguments) {
        argument.source = draws.value_below<CombineSource>(13);
        argument.operand =
            alpha ? (draws.coin() ? CombineOperand::Alpha : CombineOperand::OneMinusAlpha)
                  : draws.value_below<CombineOperand>(4);
    }
    return half;
}

inline Combiner random_combiner(Draws& draws) {
    Combiner combiner{.enable = true,
                      .rgb = random_half(draws, false),
                      .alpha = random_half(draws, true),
                      .constant = draws.bits()};
    return combiner;
}

inline StencilFace random_face(Draws& draws) {
    return {.compare = draws.value_below<Compare>(8),
            .fail = draws.value_below<StencilOp>(8),
            .depth_fail = draws.value_below<StencilOp>(8),
            .depth_pass = draws.value_below<StencilOp>(8),
            .reference = static_cast<std::uint8_t>(draws.bits()),
            .compare_mask = static_cast<std::uint8_t>(draws.bits()),
            .write_mask = static_cast<std::uint8_t>(draws.bits())};
}

inline Blend random_blend(Draws& draws) {
    Blend blend;
    blend.enable = draws.coin();
    blend.logic_op_enable = draws.one_in(6);
    blend.logic_op = draws.value_below<LogicOp>(16);
    if (draws.one_in(3)) {
        blend.rgb_equation = draws.value_below<BlendEquation>(5);
        blend.alpha_equation = draws.value_below<BlendEquation>(5);
    }
    blend.rgb_source = blend.alpha_source = draws.value_below<BlendFactor>(15);
    blend.rgb_destination = blend.alpha_destination = draws.value_below<BlendFactor>(15);
    if (draws.coin()) {
        blend.alpha_source = draws.value_below<BlendFactor>(15);
        blend.alpha_destination = draws.value_below<BlendFactor>(15);
    }
    blend.constant = draws.bits();
    blend.write_mask = draws.coin() ? 0xf : static_cast<std::uint8_t>(draws.below(16));
    return blend;
}

inline void randomize(Draws& draws, Scene& scene) {
    place_targets(draws, scene);
    Registers& r = *scene.registers;
    for (Combiner& combiner : r.combiners)
        if (draws.one_in(3)) combiner = random_combiner(draws);
    r.fog = {.mode = draws.value_below<FogMode>(4),
             .color = draws.bits() & 0xffffff,
             .density = static_cast<float>(draws.below(1024)) / 512.0f,
             .start = static_cast<float>(draws.below(16)),
             .end = static_cast<float>(draws.below(16))};
    r.fragment = {.color_sum = draws.coin(),
                  .alpha_test = draws.one_in(3),
                  .alpha_compare = draws.value_below<Compare>(8),
                  .alpha_reference = static_cast<std::uint8_t>(random_channel(draws)),
                  .dither = draws.coin()};
    r.stencil = {.enable = draws.coin(), .front = random_face(draws), .back = random_face(draws)};
    r.depth = {.test_enable = draws.coin(),
               .write_enable = draws.coin(),
               .compare = draws.value_below<Compare>(8),
               .bounds_enable = draws.one_in(4),
               .bounds_min = draws.below(1u << 23),
               .bounds_max = (1u << 23) + draws.below(1u << 23)};
    r.blend = random_blend(draws);
    r.multisample = {.enable = draws.below(4) != 0,
                     .alpha_to_coverage = draws.one_in(3),
                     .alpha_to_one = draws.one_in(3),
                     .sample_mask = draws.coin() ? std::uint8_t{0xf}
                                                 : static_cast<std::uint8_t>(draws.below(16))};
    scene.state.multisample = scene.state.samples > 1 && r.multisample.enable;
    scene.state.units = static_cast<std::uint8_t>(draws.bits());
    scene.state.early_depth = draws.one_in(3);
    scene.state.antialias = draws.one_in(3);
}

// --- Batches ------------------------------------------------------------------------------------

// Quads at distinct places of a tile, their fragments within the scissor live as `live` says.
template <class Live>
void place_quads(
    Draws& draws, const Scissor& scissor, unsigned count, FragmentBatch& batch, Live&& live) {
    constexpr unsigned Across = TileSize / 2;
    std::vector<unsigned> places(std::size_t{Across} * Across);
    for (unsigned i = 0; i < places.size(); ++i)
        places[i] = i;
    batch.quad_count = count;
    batch.live = {};
    for (unsigned q = 0; q < count; ++q) {
        std::swap(places[q], places[q + draws.below(static_cast<unsigned>(places.size()) - q)]);
        batch.x[q] = static_cast<std::uint16_t>(2 * (places[q] % Across));
        batch.y[q] = static_cast<std::uint16_t>(2 * (places[q] / Across));
        for (unsigned i = 0; i < 4; ++i) {
            const bool inside =
                batch.x[q] + (i & 1u) < scissor.width && batch.y[q] + (i >> 1u) < scissor.height;
            if (inside && live()) batch.live.set(4 * q + i);
        }
    }
}

// Which samples the fragments cover; one fragment in a few covers all, some none.
inline void random_samples(Draws& draws, FragmentBatch& batch) {
    const FragmentMask candidates = batch.live;
    batch.samples = {};
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        if (!candidates.test(lane)) continue;
        const unsigned covered = draws.coin() ? 0xf : draws.below(16);
        for (unsigned i = 0; i < MaxSamples; ++i)
            if ((covered >> i & 1) != 0) batch.samples[i].set(lane);
    }
    batch.live = any_sample(batch.samples);
}

// Depths around what the target holds, so that each comparison goes both ways.
inline void random_depths(Draws& draws,
                          const Scene& scene,
                          const Surface& target,
                          FragmentBatch& batch,
                          std::array<std::uint32_t, BatchFragments>& depths) {
    const bool narrow = target.format == Format::Depth16;
    for (unsigned lane = 0; lane < BatchFragments; ++lane) {
        depths[lane] = draws.bits() >> (narrow ? 16 : 8);
        if (target.format == Format::None || !batch.live.test(lane) || draws.coin()) continue;
        const std::size_t x = batch.x[lane / 4] + (lane & 1u),
                          y = batch.y[lane / 4] + (lane >> 1 & 1u);
        const std::byte* at = scene.memory.data() + target.address + y * target.stride;
        if (narrow)
            depths[lane] = load_word<std::uint16_t>(at + 2 * x);
        else
            depths[lane] = load_word<std::uint32_t>(at + 4 * x) >> 8;
    }
}

inline void randomize(Draws& draws, Scene& scene, FragmentBatch& batch) {
    const unsigned density = draws.below(4);
    place_quads(draws, scene.registers->scissor, draws.below(BatchQuads + 1), batch, [&] {
        return density == 3 || draws.below(3) <= density;
    });
    for (std::uint64_t& word : batch.front_facing)
        word = std::uint64_t{draws.bits()} << 32 | draws.bits();
    if (draws.one_in(3)) batch.front_facing.fill(draws.coin() ? ~std::uint64_t{0} : 0);
    const Surface& target = scene.registers->targets.depth;
    random_depths(draws, scene, target.plane(0), batch, batch.depth);
    if (scene.state.samples > 1) {
        random_samples(draws, batch);
        const auto depths = std::make_shared<SampleDepths>();
        for (unsigned i = 0; i < MaxSamples; ++i)
            random_depths(draws, scene, target.plane(i), batch, depths->of[i]);
        scene.sample_depths = depths;
        batch.sample_depths = draws.coin() ? depths.get() : nullptr;
    }
    for (float& coordinate : batch.fog_coordinate)
        coordinate = random_coordinate(draws);
    for (std::uint16_t& coverage : batch.antialias)
        coverage = random_channel(draws);
    randomize(draws, batch.primary);
    batch.full_channels = draws.coin() ? 0 : static_cast<std::uint8_t>(draws.below(16));
    unsigned channel = 0;
    for (auto* plane : {&batch.primary.r, &batch.primary.g, &batch.primary.b, &batch.primary.a})
        if ((batch.full_channels >> channel++ & 1) != 0) plane->fill(255);
    randomize(draws, batch.secondary);
    for (ColorPlanes& samples : batch.texture)
        randomize(draws, samples);
}

} // namespace ffgpu::test
