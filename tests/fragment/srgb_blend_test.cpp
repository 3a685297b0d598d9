// Blending into targets of sRGB codes against EXT_framebuffer_sRGB's formulas in double precision.

#include "model/fragment/color_target.h"
#include "tests/fragment/random_fragments.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

double light_of(unsigned code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double code_of(double light) {
    return 255 * (light < 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

struct BlendedLight {
    double source, destination, constant;
    double source_alpha, destination_alpha, constant_alpha;
};

double factor_of(BlendFactor factor, const BlendedLight& in) {
    switch (factor) {
    case BlendFactor::Zero:
        return 0;
    case BlendFactor::One:
        return 1;
    case BlendFactor::SourceColor:
        return in.source;
    case BlendFactor::OneMinusSourceColor:
        return 1 - in.source;
    case BlendFactor::DestinationColor:
        return in.destination;
    case BlendFactor::OneMinusDestinationColor:
        return 1 - in.destination;
    case BlendFactor::SourceAlpha:
        return in.source_alpha;
    case BlendFactor::OneMinusSourceAlpha:
        return 1 - in.source_alpha;
    case BlendFactor::DestinationAlpha:
        return in.destination_alpha;
    case BlendFactor::OneMinusDestinationAlpha:
        return 1 - in.destination_alpha;
    case BlendFactor::ConstantColor:
        return in.constant;
    case BlendFactor::OneMinusConstantColor:
        return 1 - in.constant;
    case BlendFactor::ConstantAlpha:
        return in.constant_alpha;
    case BlendFactor::OneMinusConstantAlpha:
        return 1 - in.constant_alpha;
    case BlendFactor::SourceAlphaSaturate:
        return std::min(in.source_alpha, 1 - in.destination_alpha);
    }
    return 0;
}

double blended(const Blend& state, const BlendedLight& in) {
    const double s = in.source * factor_of(state.rgb_source, in);
    const double d = in.destination * factor_of(state.rgb_destination, in);
    switch (state.rgb_equation) {
    case BlendEquation::Add:
        return std::min(s + d, 1.0);
    case BlendEquation::Subtract:
        return std::max(s - d, 0.0);
    case BlendEquation::ReverseSubtract:
        return std::max(d - s, 0.0);
    case BlendEquation::Min:
        return std::min(in.source, in.destination);
    case BlendEquation::Max:
        return std::max(in.source, in.destination);
    }
    return 0;
}

BlendedLight
light_in(PixelColor source, PixelColor destination, PixelColor constant, unsigned channel) {
    return {.source = source[channel] / 255.0,
            .destination = light_of(destination[channel]),
            .constant = constant[channel] / 255.0,
            .source_alpha = source[3] / 255.0,
            .destination_alpha = destination[3] / 255.0,
            .constant_alpha = constant[3] / 255.0};
}

constexpr unsigned Factors = 15, Equations = 5;

} // namespace

// The destination and the result are rounded to 16 bits of light: 12.92 * 255 / 65535 of a code a
// unit where codes lie densest.
TEST_CASE("sRGB targets are blended as light, within 0.1 of a code before rounding") {
    std::mt19937 random(1);
    const auto byte = [&random] { return static_cast<std::uint8_t>(random()); };
    const auto color = [&] {
        PixelColor made{};
        // Dark ones often: there a step of light is many codes.
        const unsigned shift = random() % 3 == 0 ? 5u : 0u;
        for (std::uint8_t& channel : made)
            channel = static_cast<std::uint8_t>(byte() >> shift);
        return made;
    };
    for (unsigned n = 0; n < Factors * Factors * Equations * 100; ++n) {
        const PixelColor source = color(), destination = color(), constant = color();
        Blend state{.enable = true, .constant = pack_rgba8(constant)};
        state.rgb_source = state.alpha_source = static_cast<BlendFactor>(n % Factors);
        state.rgb_destination = state.alpha_destination =
            static_cast<BlendFactor>(n / Factors % Factors);
        state.rgb_equation = state.alpha_equation =
            static_cast<BlendEquation>(n / Factors / Factors % Equations);
        const PixelColor result = blend_srgb(state, source, destination);
        for (unsigned channel = 0; channel < 3; ++channel) {
            const BlendedLight in = light_in(source, destination, constant, channel);
            REQUIRE(std::abs(result[channel] - code_of(blended(state, in))) < 0.6);
        }
        REQUIRE(result[3] == blend(state, source, destination)[3]);
        const ColorTarget target{{.format = Format::Rgba8}, 0xf, true};
        REQUIRE(
            written_color(compile_color_stage(state, false), target, {0, 0, source}, destination) ==
            result);
    }
}

TEST_CASE("what is blended with nothing stays, in every code") {
    const Blend keep{.enable = true,
                     .rgb_source = BlendFactor::Zero,
                     .rgb_destination = BlendFactor::One,
                     .alpha_source = BlendFactor::Zero,
                     .alpha_destination = BlendFactor::One};
    for (unsigned code = 0; code < 256; ++code) {
        const auto level = static_cast<std::uint8_t>(code);
        const PixelColor stored{level, level, level, level};
        REQUIRE(blend_srgb(keep, {200, 100, 50, 25}, stored) == stored);
    }
}

TEST_CASE("an sRGB target takes encoded colours, and no logic operation") {
    const ColorTarget target{{.format = Format::Rgba8}, 0xf, true};
    const PixelColor stored{1, 2, 3, 4};
    Blend state;
    for (const bool logic : {false, true}) {
        state.logic_op_enable = logic;
        state.logic_op = LogicOp::Xor;
        const ColorStage stage = compile_color_stage(state, false);
        for (unsigned level = 0; level < 256; ++level) {
            const auto n = static_cast<std::uint8_t>(level);
            const auto code = static_cast<std::uint8_t>(std::floor(code_of(level / 255.0) + 0.5));
            const PixelColor written = written_color(stage, target, {0, 0, {n, 0, 255, n}}, stored);
            REQUIRE(written == PixelColor{code, 0, 255, n});
        }
    }
}

TEST_CASE("an sRGB target's write mask keeps codes as they are") {
    const ColorTarget target{{.format = Format::Rgba8}, 0x9, true};
    const ColorStage stage = compile_color_stage({}, false);
    const PixelColor written =
        written_color(stage, target, {0, 0, {55, 55, 55, 55}}, {10, 20, 30, 40});
    // 128 is 0.2158 of full light, as 55 of 255 is.
    CHECK(written == PixelColor{128, 20, 30, 55});
}
