// Random states of the fragment pipe, within what it draws: formats, wrap modes, filters,
// environments, tests and blends.

#pragma once

#include "tests/gpu/mixture.h"

#include <random>

namespace ffgpu::test {

class RandomStates {
public:
    explicit RandomStates(unsigned seed)
        : random_(seed) {}

    // Units 0 and up of `textures` have images; the texels are what memory holds.
    void vary(Registers& registers, unsigned textures) {
        vary_tests(registers);
        vary_colors(registers);
        for (unsigned unit = 0; unit < TextureUnits; ++unit) {
            registers.combiners[unit].enable = unit < textures;
            registers.images[unit].shape.kind = TextureKind::None;
            if (unit < textures) vary_texture(registers, unit);
        }
    }

    std::uint32_t bits() { return static_cast<std::uint32_t>(random_()); }
    std::uint32_t below(std::uint32_t limit) { return bits() % limit; }
    bool chance(std::uint32_t of) { return below(of) == 0; }
    template <class Enum>
    Enum any(std::uint32_t count) {
        return static_cast<Enum>(below(count));
    }

private:
    void vary_tests(Registers& registers) {
        registers.depth = {.test_enable = !chance(4),
                           .write_enable = !chance(3),
                           .compare = chance(2) ? Compare::Lequal : any<Compare>(8),
                           .bounds_enable = chance(6),
                           .bounds_min = bits() & 0x7fffff,
                           .bounds_max = 0x7fffff | bits()};
        registers.depth.bounds_max &= 0xffffff;
        registers.stencil.enable = chance(3);
        for (StencilFace* face : {&registers.stencil.front, &registers.stencil.back})
            *face = {.compare = chance(2) ? Compare::Always : any<Compare>(8),
                     .fail = any<StencilOp>(8),
                     .depth_fail = any<StencilOp>(8),
                     .depth_pass = any<StencilOp>(8),
                     .reference = static_cast<std::uint8_t>(bits()),
                     .compare_mask = static_cast<std::uint8_t>(bits()),
                     .write_mask = static_cast<std::uint8_t>(bits())};
        registers.fragment.alpha_test = chance(4);
        registers.fragment.alpha_compare = any<Compare>(8);
        registers.fragment.alpha_reference = static_cast<std::uint8_t>(bits());
    }

    void vary_colors(Registers& registers) {
        registers.fragment.color_sum = chance(4);
        registers.fragment.dither = chance(2);
        registers.fog.mode = chance(2) ? FogMode::Off : any<FogMode>(4);
        registers.fog.source = any<FogCoordinateSource>(4);
        registers.fog.color = bits() & 0xffffff;
        registers.fog.density = 0.7f;
        Blend& blend = registers.blend;
        blend.enable = chance(2);
        blend.logic_op_enable = chance(8);
        blend.logic_op = any<LogicOp>(16);
        blend.rgb_equation = any<BlendEquation>(5);
        blend.alpha_equation = any<BlendEquation>(5);
        blend.rgb_source = any<BlendFactor>(15);
        blend.rgb_destination = any<BlendFactor>(14);
        blend.alpha_source = any<BlendFactor>(15);
        blend.alpha_destination = any<BlendFactor>(14);
        blend.constant = bits();
        blend.write_mask = chance(2) ? 0xf : static_cast<std::uint8_t>(below(16));
    }

    void vary_texture(Registers& registers, unsigned unit) {
        constexpr std::array Kinds{TextureKind::OneD,
                                   TextureKind::TwoD,
                                   TextureKind::TwoD,
                                   TextureKind::ThreeD,
                                   TextureKind::Rectangle};
        TextureImage& image = registers.images[unit];
        image.address = TextureAt + 0x40000 * unit;
        image.srgb = chance(4);
        image.shape = {.kind = Kinds[below(Kinds.size())],
                       .format = static_cast<Format>(1 + below(17))};
        const bool is_one = image.shape.kind == TextureKind::OneD;
        const bool is_three = image.shape.kind == TextureKind::ThreeD;
        image.shape.width = size(5);
        image.shape.height = is_one ? 1 : size(5);
        image.shape.depth = is_three ? size(3) : 1;
        const bool has_levels = image.shape.kind != TextureKind::Rectangle;
        image.shape.levels = has_levels ? 1 + below(3) : 1;
        Sampler& sampler = registers.samplers[unit];
        for (Wrap& wrap : sampler.wrap)
            wrap = chance(3) ? Wrap::Repeat : any<Wrap>(8);
        sampler.magnify_linear = chance(2);
        sampler.minify_linear = chance(2);
        sampler.mip_filter = has_levels ? any<MipFilter>(3) : MipFilter::None;
        sampler.max_anisotropy = chance(3) ? 4 : 1;
        sampler.depth_mode = any<DepthMode>(3);
        sampler.border_color = bits();
        sampler.border_depth = sampler.border_color >> 8;
        vary_combiner(registers.combiners[unit], unit);
    }

    // Of an image's axis, up to 2^bits: a power of two, or any, whose levels are rounded down.
    std::uint32_t size(unsigned bits) {
        return chance(3) ? 1 + below(1u << bits) : 1u << below(bits + 1);
    }

    void vary_combiner(Combiner& combiner, unsigned unit) {
        const auto source = [&] {
            if (chance(2))
                return static_cast<CombineSource>(static_cast<unsigned>(CombineSource::Texture0) +
                                                  unit);
            return chance(2) ? CombineSource::Previous : CombineSource::Primary;
        };
        for (CombineHalf* half : {&combiner.rgb, &combiner.alpha}) {
            half->op = any<CombineOp>(6);
            for (auto& argument : half->arguments)
                argument.source = source();
            half->scale_shift = static_cast<std::uint8_t>(below(3));
        }
        combiner.constant = bits();
    }

    std::mt19937 random_;
};

} // namespace ffgpu::test
