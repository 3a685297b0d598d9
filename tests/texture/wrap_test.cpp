// Every wrap mode against the formulas of the specification (GL 1.5, 3.8.7 and 3.8.8), restated
// here in real numbers.

#include "tests/texture/texture_fixture.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

constexpr std::uint32_t BorderColor = 0x80c01040;

struct Row {
    int size;
    bool stored_border;
    std::vector<std::uint32_t> texels; // -1 .. size, stored or border colour at the ends

    double value(int i, unsigned channel) const {
        const int clamped = std::clamp(i, -1, size); // Weight 0 beyond.
        return texels[static_cast<std::size_t>(clamped) + 1] >> (8 * channel) & 0xff;
    }
};

Row random_row(Random& random, int size, bool stored_border) {
    Row row{size, stored_border, {}};
    for (int i = -1; i <= size; ++i) {
        const bool border = i == -1 || i == size;
        row.texels.push_back(border && !stored_border ? BorderColor
                                                      : static_cast<std::uint32_t>(random()));
    }
    return row;
}

TextureMemory make_texture(const Row& row) {
    TextureShape shape;
    shape.kind = TextureKind::OneD;
    shape.format = Format::Rgba8;
    shape.width = static_cast<std::uint32_t>(row.size);
    shape.border = row.stored_border ? 1 : 0;
    TextureMemory memory(shape);
    const int first = row.stored_border ? -1 : 0;
    for (int i = first; i < row.size - first; ++i)
        memory.put_rgba8(
            0, 0, static_cast<unsigned>(i - first), 0, row.texels[static_cast<std::size_t>(i) + 1]);
    return memory;
}

// s after the mode, in real numbers.
double wrapped(Wrap wrap, double s, double n) {
    const double half = 1 / (2 * n);
    const double fraction = s - std::floor(s);
    switch (wrap) {
    case Wrap::Repeat:
        return fraction;
    case Wrap::MirroredRepeat: {
        const bool odd = std::fmod(std::abs(std::floor(s)), 2.0) == 1;
        return std::clamp(odd ? 1 - fraction : fraction, half, 1 - half);
    }
    case Wrap::Clamp:
        return std::clamp(s, 0.0, 1.0);
    case Wrap::ClampToEdge:
        return std::clamp(s, half, 1 - half);
    case Wrap::ClampToBorder:
        return std::clamp(s, -half, 1 + half);
    case Wrap::MirrorClamp: // The image meets itself at 0: no border there.
        return std::clamp(std::abs(s), half, 1.0);
    case Wrap::MirrorClampToEdge:
        return std::clamp(std::abs(s), half, 1 - half);
    case Wrap::MirrorClampToBorder:
        return std::clamp(std::abs(s), half, 1 + half);
    }
    return 0;
}

double nearest_value(const Row& row, Wrap wrap, double s, unsigned channel) {
    const double at = wrapped(wrap, s, row.size);
    int i = static_cast<int>(std::floor(at * row.size));
    const bool clamps_to_one = wrap == Wrap::Clamp || wrap == Wrap::MirrorClamp;
    if (at == 1 && clamps_to_one) i = row.size - 1;
    return row.value(i, channel);
}

double linear_value(const Row& row, Wrap wrap, double s, unsigned channel) {
    const double u = wrapped(wrap, s, row.size) * row.size - 0.5;
    int i0 = static_cast<int>(std::floor(u)), i1 = i0 + 1;
    const double alpha = u - i0;
    if (wrap == Wrap::Repeat) {
        i0 = (i0 + row.size) % row.size;
        i1 = (i1 + row.size) % row.size;
    }
    return (1 - alpha) * row.value(i0, channel) + alpha * row.value(i1, channel);
}

// With `s` such that the texel coordinate is a multiple of 1/256, the unit's weight is exact and
// its result the real one rounded to nearest, halves up. Else the weight is off by up to 1/512.
unsigned count_errors(const Row& row, Wrap wrap, bool linear, double step, double tolerance) {
    const TextureMemory memory = make_texture(row);
    Sampler sampler = linear ? linear_sampler(wrap) : nearest_sampler(wrap);
    sampler.border_color = BorderColor;
    const TextureUnit unit = memory.compile(sampler);
    unsigned errors = 0;
    for (int k = -700; k < 700; ++k) {
        const auto s = static_cast<float>((2 * k + 1) * step);
        const Color color = sample_point(unit, {s});
        for (unsigned channel = 0; channel < 4; ++channel) {
            const double expected =
                linear ? linear_value(row, wrap, s, channel) : nearest_value(row, wrap, s, channel);
            errors += std::abs(color[channel] - std::floor(expected + 0.5)) > tolerance;
        }
    }
    return errors;
}

TEST_CASE("every wrap mode follows the specification exactly on power-of-two sizes") {
    Random random(1);
    for (const int size : {1, 2, 8, 64})
        for (const bool stored : {false, true})
            for (unsigned wrap = 0; wrap < 8; ++wrap)
                for (const bool linear : {false, true}) {
                    INFO("size " << size << " stored border " << stored << " wrap " << wrap
                                 << " linear " << linear);
                    const Row row = random_row(random, size, stored);
                    const double step = linear ? 0.00390625 / size : 0.0078125 / size;
                    CHECK(count_errors(row, static_cast<Wrap>(wrap), linear, step, 0) == 0);
                }
}

TEST_CASE("every wrap mode follows the specification on other sizes") {
    Random random(2);
    for (const int size : {3, 5, 12, 100})
        for (unsigned wrap = 0; wrap < 8; ++wrap) {
            INFO("size " << size << " wrap " << wrap);
            const Row row = random_row(random, size, wrap % 2 == 0);
            const double step = 0.0078125 / size; // Texel edges are never near.
            CHECK(count_errors(row, static_cast<Wrap>(wrap), false, step, 0) == 0);
            CHECK(count_errors(row, static_cast<Wrap>(wrap), true, step, 1) == 0);
        }
}

TEST_CASE("GL_CLAMP mixes in half of the border at the edge, clamp to border only the border") {
    Random random(3);
    Row row = random_row(random, 4, false);
    for (std::uint32_t& texel : row.texels)
        texel = 0;
    const TextureMemory memory = make_texture(row);
    Sampler sampler = linear_sampler(Wrap::Clamp);
    sampler.border_color = 0xc8c8c8c8;
    CHECK(sample_point(memory.compile(sampler), {1.5f}) == Color{100, 100, 100, 100});
    sampler.wrap[0] = Wrap::ClampToBorder;
    CHECK(sample_point(memory.compile(sampler), {1.5f}) == Color{200, 200, 200, 200});
    sampler.wrap[0] = Wrap::ClampToEdge;
    CHECK(sample_point(memory.compile(sampler), {1.5f}) == Color{0, 0, 0, 0});
}

} // namespace
} // namespace ffgpu::test
