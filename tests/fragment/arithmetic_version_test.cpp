// Ties the fragment units' arithmetic to its version: for each a hash over what its scalar form
// gives for seeded inputs and for corners stands in docs/arithmetic.md. A change of results is a
// new version. What is right, the units' own tests say.

#include "model/fragment/alpha_test.h"
#include "model/fragment/color_sum.h"
#include "model/fragment/color_target.h"
#include "model/fragment/fog.h"
#include "model/fragment/stencil_depth.h"
#include "model/fragment/texture_environment.h"
#include "tests/support/seal.h"

#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using ffgpu::test::Seal;

namespace {

constexpr std::uint8_t Corners[] = {0, 1, 127, 128, 254, 255};

// Raw draws of a seeded generator: the same on every machine.
struct Draw {
    std::mt19937 generator{2};

    std::uint32_t bits() { return static_cast<std::uint32_t>(generator()); }
    std::uint32_t below(std::uint32_t limit) { return bits() % limit; }
    std::uint8_t byte() { return static_cast<std::uint8_t>(bits() >> 8); }
    // Every third one a corner.
    std::uint8_t channel() { return below(3) == 0 ? Corners[below(6)] : byte(); }
    PixelColor color() { return {channel(), channel(), channel(), channel()}; }
    // Of magnitude 2^-12 .. 2^12, or 0.
    float number() {
        if (below(16) == 0) return 0;
        const std::uint32_t exponent = 127 - 12 + below(24);
        return std::bit_cast<float>((bits() & 0x807fffff) | exponent << 23);
    }
    template <class Enum>
    Enum one_of(std::uint32_t count) {
        return static_cast<Enum>(below(count));
    }
};

void add(Seal& seal, const PixelColor& color) {
    for (const std::uint8_t channel : color)
        seal.add(std::uint64_t{channel});
}

CombineHalf half_of(Draw& draw, CombineOp op, unsigned scale_shift, unsigned first_operand) {
    CombineHalf half;
    half.op = op;
    half.scale_shift = static_cast<std::uint8_t>(scale_shift);
    for (CombineArgument& argument : half.arguments) {
        argument.source = draw.one_of<CombineSource>(13);
        argument.operand =
            static_cast<CombineOperand>(first_operand + draw.below(4 - first_operand));
    }
    return half;
}

std::string seal_of_environments() {
    Seal seal;
    Draw draw;
    for (unsigned op = 0; op < 13; ++op)
        for (unsigned scale_shift = 0; scale_shift < 3; ++scale_shift)
            for (unsigned n = 0; n < 500; ++n) {
                const auto alpha_op = draw.one_of<CombineOp>(13);
                const Combiner combiner{
                    .enable = true,
                    .rgb = half_of(draw, static_cast<CombineOp>(op), scale_shift, 0),
                    .alpha = half_of(draw, alpha_op, n % 3, 2),
                    .constant = draw.bits()};
                CombineInputs inputs{};
                inputs.primary = draw.color();
                inputs.previous = draw.color();
                for (PixelColor& texture : inputs.texture)
                    texture = draw.color();
                add(seal, combine(combiner, inputs));
            }
    return seal.text();
}

std::string seal_of_color_sum() {
    Seal seal;
    for (unsigned a = 0; a < 256; ++a)
        for (unsigned b = 0; b < 256; ++b) {
            const auto first = static_cast<std::uint8_t>(a), second = static_cast<std::uint8_t>(b);
            add(seal, add_secondary({first, second, 255, first}, {second, 1, first, second}));
            add(seal, apply_coverage({1, 2, 3, first}, second));
        }
    return seal.text();
}

std::string seal_of_fog() {
    Seal seal;
    Draw draw;
    for (unsigned n = 0; n < 3000; ++n) {
        const Fog fog{.mode = static_cast<FogMode>(1 + n % 3),
                      .color = draw.bits() & 0xffffff,
                      .density = std::abs(draw.number()),
                      .start = draw.number(),
                      .end = n % 17 == 0 ? 0 : draw.number()};
        const FogCurve curve = compile_fog(fog);
        for (unsigned i = 0; i < 16; ++i) {
            // Around the whole fall of the curve, and anywhere.
            const float at =
                i % 2 ? draw.number()
                      : fog.start + (fog.end - fog.start) * static_cast<float>(i) / 14.0f;
            const bool in_range = at == 0 || std::abs(at) >= 0x1p-40f;
            const std::uint8_t factor = fog_factor(curve, in_range ? at : 0);
            seal.add(std::uint64_t{factor});
            add(seal, apply_fog(curve, factor, draw.color()));
        }
    }
    return seal.text();
}

std::string seal_of_alpha_test() {
    Seal seal;
    for (unsigned function = 0; function < 8; ++function)
        for (const std::uint8_t reference : Corners)
            for (std::uint32_t alpha = 0; alpha < 256; ++alpha)
                seal.add(std::uint64_t{
                    passes_alpha_test({.alpha_test = true,
                                       .alpha_compare = static_cast<Compare>(function),
                                       .alpha_reference = reference},
                                      alpha)});
    return seal.text();
}

StencilFace face_of(Draw& draw) {
    return {.compare = draw.one_of<Compare>(8),
            .fail = draw.one_of<StencilOp>(8),
            .depth_fail = draw.one_of<StencilOp>(8),
            .depth_pass = draw.one_of<StencilOp>(8),
            .reference = draw.channel(),
            .compare_mask = draw.channel(),
            .write_mask = draw.channel()};
}

std::string seal_of_stencil_depth() {
    Seal seal;
    Draw draw;
    for (unsigned n = 0; n < 4000; ++n) {
        const Format format = n % 3 ? Format::Depth24Stencil8 : Format::Depth16;
        const std::uint32_t most = n % 3 ? 0xffffff : 0xffff;
        const Stencil stencil{.enable = n % 4 != 0, .front = face_of(draw), .back = face_of(draw)};
        const DepthControl control{.test_enable = n % 5 != 0,
                                   .write_enable = n % 7 != 0,
                                   .compare = draw.one_of<Compare>(8),
                                   .bounds_enable = n % 6 == 0,
                                   .bounds_min = draw.bits() & most / 2,
                                   .bounds_max = most / 2 + (draw.bits() & most / 2)};
        const StencilDepthState state = compile_stencil_depth(stencil, control, format);
        for (unsigned i = 0; i < 16; ++i) {
            const std::uint32_t stored = i == 0 ? 0 : i == 1 ? most : draw.bits() & most;
            const std::uint32_t depth = i % 4 ? draw.bits() & most : stored;
            const StencilDepthResult result =
                test_stencil_depth(state, i % 3 != 0, depth, {stored, draw.channel()});
            seal.add(std::uint64_t{result.passes_stencil} << 1 | result.passes_depth);
            seal.add(std::uint64_t{result.pixel.depth} << 8 | result.pixel.stencil);
        }
    }
    return seal.text();
}

std::string seal_of_blend() {
    Seal seal;
    Draw draw;
    for (unsigned source = 0; source < 15; ++source)
        for (unsigned destination = 0; destination < 15; ++destination)
            for (unsigned n = 0; n < 100; ++n) {
                const Blend state{.enable = true,
                                  .rgb_equation = static_cast<BlendEquation>(n % 5),
                                  .alpha_equation = draw.one_of<BlendEquation>(5),
                                  .rgb_source = static_cast<BlendFactor>(source),
                                  .rgb_destination = static_cast<BlendFactor>(destination),
                                  .alpha_source = draw.one_of<BlendFactor>(15),
                                  .alpha_destination = draw.one_of<BlendFactor>(15),
                                  .constant = draw.bits()};
                const PixelColor from = draw.color();
                add(seal, blend(state, from, draw.color()));
            }
    return seal.text();
}

// Precision of the format, dither, logic operation and write mask.
std::string seal_of_color_write() {
    constexpr Format Formats[] = {
        Format::Rgba8, Format::Rgbx8, Format::Rgb565, Format::Rgba4, Format::Rgb5a1};
    Seal seal;
    Draw draw;
    for (const Format format : Formats)
        for (unsigned n = 0; n < 6000; ++n) {
            Blend state{.enable = n % 5 == 0,
                        .logic_op_enable = n % 3 == 0,
                        .logic_op = static_cast<LogicOp>(n / 3 % 16),
                        .rgb_source = BlendFactor::SourceAlpha,
                        .rgb_destination = BlendFactor::OneMinusSourceAlpha};
            const ColorTarget target{{.format = format, .width = 64, .height = 64, .stride = 256},
                                     static_cast<std::uint8_t>(n % 4 ? 0xf : draw.below(16))};
            const ColoredFragment fragment{draw.below(64), draw.below(64), draw.color()};
            const PixelColor stored = draw.color();
            add(seal,
                written_color(compile_color_stage(state, n % 2 == 0), target, fragment, stored));
        }
    for (unsigned op = 0; op < 16; ++op)
        seal.add(std::uint64_t{apply_logic_op(static_cast<LogicOp>(op), 0x00ff33aa, 0x0f5533cc)});
    return seal.text();
}

} // namespace

TEST_CASE("Each fragment unit gives the results that its version is sealed with") {
    const std::string page = test::arithmetic_page();
    CHECK(page.find("**Version: Arithmetic 3") != std::string::npos);
    const struct {
        const char* unit;
        std::string seal;
    } units[] = {{"texture environments", seal_of_environments()},
                 {"colour sum and coverage", seal_of_color_sum()},
                 {"fog", seal_of_fog()},
                 {"alpha test", seal_of_alpha_test()},
                 {"stencil and depth", seal_of_stencil_depth()},
                 {"blending", seal_of_blend()},
                 {"pack, dither, logic operation", seal_of_color_write()}};
    for (const auto& [unit, seal] : units) {
        const std::string row = std::string("| ") + unit + " | `" + seal + "` |";
        INFO("this build: " << row);
        CHECK(page.find(row) != std::string::npos);
    }
}
