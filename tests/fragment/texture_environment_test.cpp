#include "model/fragment/fragment_pipe.h"
#include "model/fragment/lane_access.h"
#include "model/fragment/texture_environment.h"
#include "tests/fragment/random_fragments.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

// An exact fraction; denominators here are small.
struct Rational {
    std::int64_t numerator, denominator;
};

Rational operator+(Rational a, Rational b) {
    return {a.numerator * b.denominator + b.numerator * a.denominator,
            a.denominator * b.denominator};
}
Rational operator-(Rational a, Rational b) {
    return a + Rational{-b.numerator, b.denominator};
}
Rational operator*(Rational a, Rational b) {
    return {a.numerator * b.numerator, a.denominator * b.denominator};
}

constexpr Rational One{1, 1}, Half{1, 2};

// The table of the specification, as it stands there.
Rational formula(CombineOp op, const std::array<Rational, 4>& a) {
    switch (op) {
    case CombineOp::Replace:
        return a[0];
    case CombineOp::Modulate:
        return a[0] * a[1];
    case CombineOp::Add:
        return a[0] + a[1];
    case CombineOp::AddSigned:
        return a[0] + a[1] - Half;
    case CombineOp::Interpolate:
        return a[0] * a[2] + a[1] * (One - a[2]);
    case CombineOp::Subtract:
        return a[0] - a[1];
    case CombineOp::ModulateAdd:
        return a[0] * a[2] + a[1];
    case CombineOp::ModulateSignedAdd:
        return a[0] * a[2] + a[1] - Half;
    case CombineOp::ModulateSubtract:
        return a[0] * a[2] - a[1];
    case CombineOp::AddProducts:
        return a[0] * a[1] + a[2] * a[3];
    case CombineOp::AddProductsSigned:
        return a[0] * a[1] + a[2] * a[3] - Half;
    default:
        return a[0];
    }
}

// Clamped to [0, 1], times 255, rounded to nearest, ties up.
std::uint8_t to_unorm8(Rational value) {
    if (value.numerator <= 0) return 0;
    if (value.numerator >= value.denominator) return 255;
    return static_cast<std::uint8_t>((2 * 255 * value.numerator + value.denominator) /
                                     (2 * value.denominator));
}

constexpr CombineSource Sources[] = {CombineSource::Texture0,
                                     static_cast<CombineSource>(1),
                                     CombineSource::Primary,
                                     CombineSource::Constant};

// A combiner with its four arguments from four sources, in order.
Combiner four_sources(CombineOp op, unsigned shift) {
    Combiner combiner;
    combiner.enable = true;
    for (CombineHalf* half : {&combiner.rgb, &combiner.alpha}) {
        half->op = op;
        half->scale_shift = static_cast<std::uint8_t>(shift);
        for (unsigned i = 0; i < 4; ++i)
            half->arguments[i] = {Sources[i],
                                  half == &combiner.alpha ? CombineOperand::Alpha
                                                          : CombineOperand::Color};
    }
    return combiner;
}

CombineInputs inputs_of(const std::array<PixelColor, 4>& colors) {
    CombineInputs inputs{};
    inputs.texture[0] = colors[0];
    inputs.texture[1] = colors[1];
    inputs.primary = colors[2];
    return inputs;
}

constexpr CombineOp Ops[] = {CombineOp::Replace,
                             CombineOp::Modulate,
                             CombineOp::Add,
                             CombineOp::AddSigned,
                             CombineOp::Interpolate,
                             CombineOp::Subtract,
                             CombineOp::ModulateAdd,
                             CombineOp::ModulateSignedAdd,
                             CombineOp::ModulateSubtract,
                             CombineOp::AddProducts,
                             CombineOp::AddProductsSigned};

PixelColor random_color(test::Draws& draws) {
    PixelColor color;
    for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(test::random_channel(draws));
    return color;
}

Rational unorm(std::uint8_t value) {
    return {value, 255};
}

} // namespace

TEST_CASE("Each combiner operation is the exact value, scaled, clamped and rounded once") {
    test::Draws draws(1);
    for (const CombineOp op : Ops)
        for (unsigned shift = 0; shift < 3; ++shift)
            for (unsigned i = 0; i < 3000; ++i) {
                std::array<PixelColor, 4> colors;
                for (PixelColor& color : colors)
                    color = random_color(draws);
                Combiner combiner = four_sources(op, shift);
                combiner.constant = pack_rgba8(colors[3]);
                const PixelColor result = combine(combiner, inputs_of(colors));
                for (unsigned c = 0; c < 4; ++c) {
                    const Rational exact = formula(op,
                                                   {unorm(colors[0][c]),
                                                    unorm(colors[1][c]),
                                                    unorm(colors[2][c]),
                                                    unorm(colors[3][c])});
                    const Rational scaled = exact * Rational{1 << shift, 1};
                    if (result[c] != to_unorm8(scaled)) {
                        INFO("op " << int(op) << " shift " << shift << " channel " << c);
                        REQUIRE(int(result[c]) == int(to_unorm8(scaled)));
                    }
                }
            }
}

TEST_CASE("Modulation of two values is round(a b / 255), for all of them and every scale") {
    for (unsigned shift = 0; shift < 3; ++shift) {
        const Combiner combiner = four_sources(CombineOp::Modulate, shift);
        for (unsigned a = 0; a < 256; ++a)
            for (unsigned b = 0; b < 256; ++b) {
                const auto x = static_cast<std::uint8_t>(a), y = static_cast<std::uint8_t>(b);
                const PixelColor result =
                    combine(combiner, inputs_of({{{x, x, x, x}, {y, y, y, y}, {}, {}}}));
                const Rational exact = unorm(x) * unorm(y) * Rational{1 << shift, 1};
                if (result[0] != to_unorm8(exact)) REQUIRE(int(result[0]) == to_unorm8(exact));
                if (result[3] != result[0]) REQUIRE(int(result[3]) == int(result[0]));
            }
    }
}

TEST_CASE("Interpolation reaches both ends exactly and never leaves the two colours") {
    const Combiner combiner = four_sources(CombineOp::Interpolate, 0);
    const auto lerp = [&](unsigned a, unsigned b, unsigned t) {
        const auto byte = [](unsigned v) { return static_cast<std::uint8_t>(v); };
        return combine(
            combiner,
            inputs_of({{{byte(a), 0, 0, 0}, {byte(b), 0, 0, 0}, {byte(t), 0, 0, 0}, {}}}))[0];
    };
    for (unsigned a = 0; a < 256; a += 5)
        for (unsigned b = 0; b < 256; ++b) {
            REQUIRE(lerp(a, b, 255) == a);
            REQUIRE(lerp(a, b, 0) == b);
            const unsigned mixed = lerp(a, b, 100);
            REQUIRE(mixed >= std::min(a, b));
            REQUIRE(mixed <= std::max(a, b));
        }
}

TEST_CASE("A dot product is 4 sum((a - 1/2)(b - 1/2)), into r g b alone or into alpha too") {
    test::Draws draws(2);
    for (unsigned i = 0; i < 20000; ++i) {
        const PixelColor a = random_color(draws), b = random_color(draws);
        Combiner combiner =
            four_sources(draws.coin() ? CombineOp::Dot3Rgb : CombineOp::Dot3Rgba, draws.below(3));
        combiner.alpha.op = CombineOp::Add;
        combiner.alpha.scale_shift = static_cast<std::uint8_t>(draws.below(3));
        const PixelColor result = combine(combiner, inputs_of({{a, b, {}, {}}}));
        Rational sum{0, 1};
        for (unsigned c = 0; c < 3; ++c)
            sum = sum + (unorm(a[c]) - Half) * (unorm(b[c]) - Half);
        const std::uint8_t dot = to_unorm8(sum * Rational{4 << combiner.rgb.scale_shift, 1});
        const unsigned scale = combiner.alpha.scale_shift; // RGB_SCALE is for colour alone.
        const std::uint8_t alpha =
            combiner.rgb.op == CombineOp::Dot3Rgba
                ? to_unorm8(sum * Rational{4 << scale, 1})
                : static_cast<std::uint8_t>(std::min(255, (a[3] + b[3]) << scale));
        if (result != PixelColor{dot, dot, dot, alpha})
            REQUIRE(result == PixelColor{dot, dot, dot, alpha});
    }
    SUCCEED();
}

TEST_CASE("Operands choose colour or alpha, complemented or not") {
    CombineInputs inputs{};
    inputs.texture[0] = {10, 20, 30, 40};
    Combiner combiner;
    combiner.enable = true;
    CombineArgument& argument = combiner.rgb.arguments[0];
    argument.source = CombineSource::Texture0;
    const auto rgb = [&](CombineOperand operand) {
        argument.operand = operand;
        const PixelColor result = combine(combiner, inputs);
        return std::array<int, 3>{result[0], result[1], result[2]};
    };
    REQUIRE(rgb(CombineOperand::Color) == std::array<int, 3>{10, 20, 30});
    REQUIRE(rgb(CombineOperand::OneMinusColor) == std::array<int, 3>{245, 235, 225});
    REQUIRE(rgb(CombineOperand::Alpha) == std::array<int, 3>{40, 40, 40});
    REQUIRE(rgb(CombineOperand::OneMinusAlpha) == std::array<int, 3>{215, 215, 215});
}

namespace {

// A batch with one random colour a lane, in every plane.
std::unique_ptr<FragmentBatch> random_batch(std::uint32_t seed) {
    auto batch = std::make_unique<FragmentBatch>();
    test::Draws draws(seed);
    batch->quad_count = BatchQuads;
    test::randomize(draws, batch->primary);
    for (ColorPlanes& samples : batch->texture)
        test::randomize(draws, samples);
    return batch;
}

Combiner replace_by(CombineSource source) {
    Combiner combiner;
    combiner.enable = true;
    combiner.rgb.arguments[0].source = source;
    combiner.alpha.arguments[0] = {source, CombineOperand::Alpha};
    return combiner;
}

// The pipe's shading with the environments alone.
void run_environments(const EnvironmentProgram& program, FragmentBatch& batch) {
    FragmentPipe pipe;
    pipe.registers = std::make_shared<const Registers>();
    pipe.environments = program;
    shade(pipe, batch);
}

} // namespace

TEST_CASE("Without an enabled combiner the colour is the primary colour") {
    auto batch = random_batch(3);
    std::array<Combiner, TextureUnits> combiners{};
    run_environments(compile_environments(combiners, 0xff), *batch);
    REQUIRE(lane_color(batch->color, 77) == lane_color(batch->primary, 77));
}

TEST_CASE("Previous of the first enabled unit is the primary colour, and units off pass it on") {
    auto batch = random_batch(4);
    std::array<Combiner, TextureUnits> combiners{};
    combiners[2] = replace_by(CombineSource::Previous);
    combiners[5] = replace_by(CombineSource::Previous);
    run_environments(compile_environments(combiners, 0xff), *batch);
    for (unsigned lane = 0; lane < BatchFragments; ++lane)
        REQUIRE(lane_color(batch->color, lane) == lane_color(batch->primary, lane));
}

TEST_CASE("A unit may read any unit's sample, and one that is not sampled reads as opaque black") {
    auto batch = random_batch(5);
    std::array<Combiner, TextureUnits> combiners{};
    combiners[0] = replace_by(static_cast<CombineSource>(6));
    run_environments(compile_environments(combiners, 1u << 6), *batch);
    REQUIRE(lane_color(batch->color, 9) == lane_color(batch->texture[6], 9));
    run_environments(compile_environments(combiners, 0), *batch);
    REQUIRE(lane_color(batch->color, 9) == UnsampledTexture);
}
