#include "model/fragment/blend.h"
#include "tests/fragment/random_fragments.h"

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

// A factor as the specification's table 4.1 has it, in units of 1/255.
int table_factor(BlendFactor factor, unsigned c, PixelColor s, PixelColor d, PixelColor k) {
    const int color[] = {s[c], d[c], k[c]}, alpha[] = {s[3], d[3], k[3]};
    switch (factor) {
    case BlendFactor::Zero:
        return 0;
    case BlendFactor::One:
        return 255;
    case BlendFactor::SourceColor:
        return color[0];
    case BlendFactor::OneMinusSourceColor:
        return 255 - color[0];
    case BlendFactor::DestinationColor:
        return color[1];
    case BlendFactor::OneMinusDestinationColor:
        return 255 - color[1];
    case BlendFactor::SourceAlpha:
        return alpha[0];
    case BlendFactor::OneMinusSourceAlpha:
        return 255 - alpha[0];
    case BlendFactor::DestinationAlpha:
        return alpha[1];
    case BlendFactor::OneMinusDestinationAlpha:
        return 255 - alpha[1];
    case BlendFactor::ConstantColor:
        return color[2];
    case BlendFactor::OneMinusConstantColor:
        return 255 - color[2];
    case BlendFactor::ConstantAlpha:
        return alpha[2];
    case BlendFactor::OneMinusConstantAlpha:
        return 255 - alpha[2];
    case BlendFactor::SourceAlphaSaturate:
        return c == 3 ? 255 : std::min(alpha[0], 255 - alpha[1]);
    }
    return 0;
}

// The exact value, clamped, rounded once.
int exact_blend(BlendEquation equation, int s, int fs, int d, int fd) {
    int numerator = 0;
    switch (equation) {
    case BlendEquation::Add:
        numerator = s * fs + d * fd;
        break;
    case BlendEquation::Subtract:
        numerator = s * fs - d * fd;
        break;
    case BlendEquation::ReverseSubtract:
        numerator = d * fd - s * fs;
        break;
    case BlendEquation::Min:
        return std::min(s, d);
    case BlendEquation::Max:
        return std::max(s, d);
    }
    numerator = std::clamp(numerator, 0, 255 * 255);
    return (2 * numerator + 255) / 510;
}

PixelColor random_color(test::Draws& draws) {
    PixelColor color;
    for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(test::random_channel(draws));
    return color;
}

PixelColor lane_color(const ColorPlanes& planes, unsigned lane) {
    return {static_cast<std::uint8_t>(planes.r[lane]),
            static_cast<std::uint8_t>(planes.g[lane]),
            static_cast<std::uint8_t>(planes.b[lane]),
            static_cast<std::uint8_t>(planes.a[lane])};
}

} // namespace

TEST_CASE("Every pair of factors with every equation is exact and rounded once") {
    test::Draws draws(11);
    Blend state{.enable = true};
    for (unsigned source = 0; source < 15; ++source)
        for (unsigned destination = 0; destination < 15; ++destination)
            for (unsigned equation = 0; equation < 5; ++equation) {
                state.rgb_source = static_cast<BlendFactor>(source);
                state.rgb_destination = static_cast<BlendFactor>(destination);
                state.rgb_equation = static_cast<BlendEquation>(equation);
                state.alpha_source = static_cast<BlendFactor>(destination);
                state.alpha_destination = static_cast<BlendFactor>(source);
                state.alpha_equation = static_cast<BlendEquation>(4 - equation);
                for (unsigned i = 0; i < 50; ++i) {
                    const PixelColor s = random_color(draws), d = random_color(draws),
                                     k = random_color(draws);
                    state.constant = pack_rgba8(k);
                    const PixelColor result = blend(state, s, d);
                    for (unsigned c = 0; c < 4; ++c) {
                        const bool alpha = c == 3;
                        const int expected = exact_blend(
                            alpha ? state.alpha_equation : state.rgb_equation,
                            s[c],
                            table_factor(alpha ? state.alpha_source : state.rgb_source, c, s, d, k),
                            d[c],
                            table_factor(alpha ? state.alpha_destination : state.rgb_destination,
                                         c,
                                         s,
                                         d,
                                         k));
                        if (result[c] != expected) {
                            INFO(source << " " << destination << " " << equation << " " << c);
                            REQUIRE(int(result[c]) == expected);
                        }
                    }
                }
            }
    SUCCEED();
}

TEST_CASE("Each kernel yields the scalar bits for its pair of factors") {
    test::Draws draws(12);
    auto batch = std::make_unique<FragmentBatch>();
    batch->quad_count = BatchQuads;
    for (unsigned source = 0; source < 15; ++source)
        for (unsigned destination = 0; destination < 15; ++destination) {
            Blend state{.enable = true, .constant = draws.bits()};
            state.rgb_source = state.alpha_source = static_cast<BlendFactor>(source);
            state.rgb_destination = state.alpha_destination = static_cast<BlendFactor>(destination);
            test::randomize(draws, batch->color);
            LaneWords stored, colors;
            for (std::uint32_t& word : stored.words)
                word = pack_rgba8(random_color(draws));
            colors = stored;
            choose_blend_kernel(state)(state, *batch, colors);
            for (unsigned lane = 0; lane < BatchFragments; ++lane) {
                const PixelColor expected =
                    blend(state, lane_color(batch->color, lane), unpack_rgba8(stored.words[lane]));
                if (colors.words[lane] != pack_rgba8(expected)) {
                    INFO(source << " " << destination << " lane " << lane);
                    REQUIRE(unpack_rgba8(colors.words[lane]) == expected);
                }
            }
        }
    SUCCEED();
}

TEST_CASE("Translucency is exact for every source, destination and alpha") {
    const Blend state{.enable = true,
                      .rgb_source = BlendFactor::SourceAlpha,
                      .rgb_destination = BlendFactor::OneMinusSourceAlpha,
                      .alpha_source = BlendFactor::SourceAlpha,
                      .alpha_destination = BlendFactor::OneMinusSourceAlpha};
    auto batch = std::make_unique<FragmentBatch>();
    batch->quad_count = BatchQuads;
    LaneWords colors;
    for (unsigned alpha = 0; alpha < 256; ++alpha)
        for (unsigned s = 0; s < 256; ++s) {
            for (unsigned d = 0; d < 256; ++d) { // one lane each
                batch->color.r[d] = batch->color.g[d] = batch->color.b[d] =
                    static_cast<std::uint16_t>(s);
                batch->color.a[d] = static_cast<std::uint16_t>(alpha);
                colors.words[d] = d * 0x01010101u;
            }
            choose_blend_kernel(state)(state, *batch, colors);
            for (unsigned d = 0; d < 256; ++d) {
                const unsigned exact = (2 * (s * alpha + d * (255 - alpha)) + 255) / 510;
                if ((colors.words[d] & 255) != exact) REQUIRE((colors.words[d] & 255) == exact);
            }
        }
    SUCCEED();
}

TEST_CASE("Logic operations are their truth tables") {
    // Bits of source 1100, destination 1010, as in the specification's order.
    constexpr unsigned Table[] = {0b0000,
                                  0b1000,
                                  0b0100,
                                  0b1100,
                                  0b0010,
                                  0b1010,
                                  0b0110,
                                  0b1110,
                                  0b0001,
                                  0b1001,
                                  0b0101,
                                  0b1101,
                                  0b0011,
                                  0b1011,
                                  0b0111,
                                  0b1111};
    for (unsigned op = 0; op < 16; ++op) {
        INFO("operation " << op);
        REQUIRE((apply_logic_op(static_cast<LogicOp>(op), 0b1100, 0b1010) & 0xf) == Table[op]);
    }
}

TEST_CASE("One and Zero with Add need no destination, and a logic copy neither") {
    REQUIRE(color_operation({.enable = false}) == ColorOperation::Replace);
    REQUIRE(color_operation({.enable = true}) == ColorOperation::Replace);
    REQUIRE(color_operation({.enable = true, .rgb_destination = BlendFactor::One}) ==
            ColorOperation::Blend);
    REQUIRE(color_operation({.enable = true, .rgb_equation = BlendEquation::Subtract}) ==
            ColorOperation::Blend);
    REQUIRE(color_operation({.logic_op_enable = true, .logic_op = LogicOp::Copy}) ==
            ColorOperation::Replace);
    REQUIRE(color_operation({.enable = true, .logic_op_enable = true, .logic_op = LogicOp::Xor}) ==
            ColorOperation::Logic);
}
