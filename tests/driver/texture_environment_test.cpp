// The lowered combiners, evaluated on sample colours, against the formulas of GL 1.5, tables 3.22
// to 3.24, written out.

#include "driver/lower/combiner.h"

#include <algorithm>
#include <array>
#include <functional>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;

namespace {

using Color = std::array<double, 4>;

// What the combiner reads.
struct Inputs {
    Color primary{0.9, 0.8, 0.7, 0.6};
    Color previous{0.25, 0.5, 0.75, 0.4};
    Color constant{0.1, 0.2, 0.3, 0.8};
    std::array<Color, TextureUnits> samples{{{0.6, 0.3, 0.2, 0.7}, {0.5, 0.9, 0.1, 0.2}}};
};

double clamped(double value) {
    return std::clamp(value, 0.0, 1.0);
}

Color source_of(const CombineArgument& argument, const Inputs& inputs) {
    switch (argument.source) {
    case CombineSource::Constant:
        return inputs.constant;
    case CombineSource::Primary:
        return inputs.primary;
    case CombineSource::Previous:
        return inputs.previous;
    case CombineSource::Zero:
        return {0, 0, 0, 0};
    case CombineSource::One:
        return {1, 1, 1, 1};
    default:
        return inputs.samples[static_cast<std::size_t>(argument.source)];
    }
}

double argument_of(const CombineArgument& argument, const Inputs& inputs, std::size_t channel) {
    const Color color = source_of(argument, inputs);
    switch (argument.operand) {
    case CombineOperand::Color:
        return color[channel];
    case CombineOperand::OneMinusColor:
        return 1 - color[channel];
    case CombineOperand::Alpha:
        return color[3];
    default:
        return 1 - color[3];
    }
}

double combine(const CombineHalf& half, const Inputs& inputs, std::size_t channel) {
    const auto a = [&](std::size_t i, std::size_t c) {
        return argument_of(half.arguments[i], inputs, c);
    };
    const auto arg = [&](std::size_t i) { return a(i, channel); };
    double result = 0;
    switch (half.op) {
    case CombineOp::Replace:
        result = arg(0);
        break;
    case CombineOp::Modulate:
        result = arg(0) * arg(1);
        break;
    case CombineOp::Add:
        result = arg(0) + arg(1);
        break;
    case CombineOp::AddSigned:
        result = arg(0) + arg(1) - 0.5;
        break;
    case CombineOp::Interpolate:
        result = arg(0) * arg(2) + arg(1) * (1 - arg(2));
        break;
    case CombineOp::Subtract:
        result = arg(0) - arg(1);
        break;
    case CombineOp::Dot3Rgb:
    case CombineOp::Dot3Rgba:
        for (std::size_t c = 0; c < 3; ++c)
            result += 4 * (a(0, c) - 0.5) * (a(1, c) - 0.5);
        break;
    case CombineOp::ModulateAdd:
        result = arg(0) * arg(2) + arg(1);
        break;
    case CombineOp::ModulateSignedAdd:
        result = arg(0) * arg(2) + arg(1) - 0.5;
        break;
    case CombineOp::ModulateSubtract:
        result = arg(0) * arg(2) - arg(1);
        break;
    case CombineOp::AddProducts:
        result = arg(0) * arg(1) + arg(2) * arg(3);
        break;
    case CombineOp::AddProductsSigned:
        result = arg(0) * arg(1) + arg(2) * arg(3) - 0.5;
        break;
    }
    return clamped(result * (1 << half.scale_shift));
}

Color evaluate(const Combiner& combiner, const Inputs& inputs) {
    if (!combiner.enable) return inputs.previous;
    Color result;
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = combine(combiner.rgb, inputs, c);
    CombineHalf alpha = combiner.alpha;
    if (combiner.rgb.op == CombineOp::Dot3Rgba) { // the dot product, by ALPHA_SCALE
        alpha = combiner.rgb;
        alpha.scale_shift = combiner.alpha.scale_shift;
    }
    result[3] = combine(alpha, inputs, 3);
    return result;
}

// A sample as the device gives it for a base format.
Color sample_as(BaseFormat format, const Color& stored) {
    const auto [r, g, b, a] = stored;
    switch (format) {
    case BaseFormat::Alpha:
        return {0, 0, 0, a};
    case BaseFormat::Luminance:
        return {r, r, r, 1};
    case BaseFormat::LuminanceAlpha:
        return {r, r, r, a};
    case BaseFormat::Intensity:
        return {r, r, r, r};
    case BaseFormat::Rgb:
        return {r, g, b, 1};
    default:
        return stored;
    }
}

void check_equal(const Color& actual, const Color& expected) {
    for (std::size_t c = 0; c < 4; ++c) {
        INFO("channel " << c);
        CHECK(actual[c] == Approx(clamped(expected[c])).margin(1e-12));
    }
}

constexpr std::array Formats{BaseFormat::Alpha,
                             BaseFormat::Luminance,
                             BaseFormat::LuminanceAlpha,
                             BaseFormat::Intensity,
                             BaseFormat::Rgb,
                             BaseFormat::Rgba};

// Entries of the tables: colour and alpha from f (previous), t (texture), c (constant).
using Entry = std::function<double(double f, double t, double c, double texture_alpha)>;
struct Row {
    Entry color, alpha;
};

void check_mode(GLenum mode, const std::array<Row, 6>& table) {
    for (std::size_t i = 0; i < Formats.size(); ++i) {
        INFO("format " << i);
        if (!table[i].color) continue; // The specification leaves it undefined.
        Inputs inputs;
        inputs.samples[0] = sample_as(Formats[i], inputs.samples[0]);
        TextureEnvironment environment;
        environment.mode = mode;
        const Combiner combiner = lower_combiner(environment, 0, {Formats[i]});
        REQUIRE(combiner.enable);
        const Color &f = inputs.previous, &t = inputs.samples[0], &c = inputs.constant;
        Color expected;
        for (std::size_t k = 0; k < 3; ++k)
            expected[k] = table[i].color(f[k], t[k], c[k], t[3]);
        expected[3] = table[i].alpha(f[3], t[3], c[3], t[3]);
        check_equal(evaluate(combiner, inputs), expected);
    }
}

const Entry Keep = [](double f, double, double, double) { return f; };
const Entry Take = [](double, double t, double, double) { return t; };
const Entry Product = [](double f, double t, double, double) { return f * t; };
const Entry Sum = [](double f, double t, double, double) { return f + t; };
const Entry Mix = [](double f, double t, double c, double) { return f * (1 - t) + c * t; };
const Entry Over = [](double f, double t, double, double a) { return f * (1 - a) + t * a; };

// Shorthand for a combine environment of one function.
TextureEnvironment combine_environment(GLenum function) {
    TextureEnvironment environment;
    environment.mode = GL_COMBINE;
    environment.combine_rgb = function;
    environment.source_rgb = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_ZERO};
    environment.operand_rgb = {
        GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_COLOR};
    return environment;
}

void check_function(const TextureEnvironment& environment,
                    const std::function<double(double, double, double)>& formula) {
    const Inputs inputs;
    const Combiner combiner = lower_combiner(environment, 0, {BaseFormat::Rgba});
    const Color result = evaluate(combiner, inputs);
    for (std::size_t c = 0; c < 3; ++c) {
        const double expected =
            formula(inputs.samples[0][c], 1 - inputs.previous[c], inputs.constant[3]);
        CHECK(result[c] == Approx(clamped(expected)));
    }
}

} // namespace

TEST_CASE("GL_REPLACE is as the tables say for each base format") {
    check_mode(
        GL_REPLACE,
        {{{Keep, Take}, {Take, Keep}, {Take, Take}, {Take, Take}, {Take, Keep}, {Take, Take}}});
}

TEST_CASE("GL_MODULATE is as the tables say for each base format") {
    check_mode(GL_MODULATE,
               {{{Keep, Product},
                 {Product, Keep},
                 {Product, Product},
                 {Product, Product},
                 {Product, Keep},
                 {Product, Product}}});
}

TEST_CASE("GL_DECAL is as the tables say where they define it") {
    check_mode(GL_DECAL, {{{}, {}, {}, {}, {Take, Keep}, {Over, Keep}}});
}

TEST_CASE("GL_BLEND is as the tables say for each base format") {
    check_mode(
        GL_BLEND,
        {{{Keep, Product}, {Mix, Keep}, {Mix, Product}, {Mix, Mix}, {Mix, Keep}, {Mix, Product}}});
}

TEST_CASE("GL_ADD is as the tables say for each base format") {
    check_mode(
        GL_ADD,
        {{{Keep, Product}, {Sum, Keep}, {Sum, Product}, {Sum, Sum}, {Sum, Keep}, {Sum, Product}}});
}

TEST_CASE("each combine function is its formula of table 3.24") {
    check_function(combine_environment(GL_REPLACE), [](double a, double, double) { return a; });
    check_function(combine_environment(GL_MODULATE),
                   [](double a, double b, double) { return a * b; });
    check_function(combine_environment(GL_ADD), [](double a, double b, double) { return a + b; });
    check_function(combine_environment(GL_ADD_SIGNED),
                   [](double a, double b, double) { return a + b - 0.5; });
    check_function(combine_environment(GL_INTERPOLATE),
                   [](double a, double b, double c) { return a * c + b * (1 - c); });
    check_function(combine_environment(GL_SUBTRACT),
                   [](double a, double b, double) { return a - b; });
    check_function(combine_environment(GL_MODULATE_ADD_ATI),
                   [](double a, double b, double c) { return a * c + b; });
    check_function(combine_environment(GL_MODULATE_SIGNED_ADD_ATI),
                   [](double a, double b, double c) { return a * c + b - 0.5; });
    check_function(combine_environment(GL_MODULATE_SUBTRACT_ATI),
                   [](double a, double b, double c) { return a * c - b; });
}

TEST_CASE("GL_COMBINE4_NV adds two products; its fourth argument is one by default") {
    TextureEnvironment environment = combine_environment(GL_ADD);
    environment.mode = GL_COMBINE4_NV;
    check_function(environment, [](double a, double b, double c) { return a * b + c; });
    environment.combine_rgb = GL_ADD_SIGNED;
    check_function(environment, [](double a, double b, double c) { return a * b + c - 0.5; });
}

TEST_CASE("results are scaled, but for EXT_texture_env_dot3's") {
    TextureEnvironment environment = combine_environment(GL_MODULATE);
    environment.rgb_scale = 2;
    environment.alpha_scale = 4;
    const SampledFormats formats{BaseFormat::Rgba};
    CHECK(lower_combiner(environment, 0, formats).rgb.scale_shift == 1);
    CHECK(lower_combiner(environment, 0, formats).alpha.scale_shift == 2);
    environment.combine_rgb = GL_DOT3_RGB;
    CHECK(lower_combiner(environment, 0, formats).rgb.scale_shift == 1);
    environment.combine_rgb = GL_DOT3_RGB_EXT;
    CHECK(lower_combiner(environment, 0, formats).rgb.scale_shift == 0);
}

TEST_CASE("a dot product goes to alpha as well only as GL_DOT3_RGBA") {
    TextureEnvironment environment = combine_environment(GL_DOT3_RGBA);
    environment.combine_alpha = GL_REPLACE;
    environment.source_alpha[0] = GL_PREVIOUS;
    const Inputs inputs;
    double dot = 0;
    for (std::size_t c = 0; c < 3; ++c)
        dot += 4 * (inputs.samples[0][c] - 0.5) * (0.5 - inputs.previous[c]);
    Color result = evaluate(lower_combiner(environment, 0, {BaseFormat::Rgba}), inputs);
    check_equal(result, {dot, dot, dot, dot});
    environment.alpha_scale = 2;
    result = evaluate(lower_combiner(environment, 0, {BaseFormat::Rgba}), inputs);
    check_equal(result, {dot, dot, dot, clamped(2 * dot)});
    environment.combine_rgb = GL_DOT3_RGBA_EXT;
    result = evaluate(lower_combiner(environment, 0, {BaseFormat::Rgba}), inputs);
    check_equal(result, {dot, dot, dot, dot});
    environment.alpha_scale = 1;
    environment.combine_rgb = GL_DOT3_RGB;
    result = evaluate(lower_combiner(environment, 0, {BaseFormat::Rgba}), inputs);
    check_equal(result, {dot, dot, dot, inputs.previous[3]});
}

TEST_CASE("a crossbar source is the sample of the unit it names") {
    TextureEnvironment environment;
    environment.mode = GL_COMBINE;
    environment.combine_rgb = environment.combine_alpha = GL_REPLACE;
    environment.source_rgb[0] = environment.source_alpha[0] = GL_TEXTURE1;
    const Inputs inputs;
    const SampledFormats both{BaseFormat::Rgba, BaseFormat::Rgba};
    check_equal(evaluate(lower_combiner(environment, 0, both), inputs), inputs.samples[1]);
    CHECK_FALSE(lower_combiner(environment, 0, {BaseFormat::Rgba}).enable); // Unit 1 is off.
}

TEST_CASE("a unit that is off passes its input, and arguments that no function reads do not show") {
    TextureEnvironment environment;
    CHECK(lower_combiner(environment, 3, {}) == Combiner{});
    environment.mode = GL_COMBINE;
    TextureEnvironment other = environment;
    other.source_rgb[2] = GL_PRIMARY_COLOR; // GL_MODULATE has two arguments.
    const SampledFormats formats{BaseFormat::Rgba};
    CHECK(lower_combiner(environment, 0, formats) == lower_combiner(other, 0, formats));
}

TEST_CASE("the environment's colour is rounded to 8 bits a channel") {
    TextureEnvironment environment;
    environment.color = {1, 0.5f, 0, 0.25f};
    CHECK(lower_combiner(environment, 0, {BaseFormat::Rgb}).constant == 0x400080ff);
}
