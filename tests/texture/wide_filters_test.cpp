// The filters of FFGPU_texture_filter against their formulas in double precision, over every texel.

#include "model/device/filter_tables.h"
#include "model/texture/wide_filters.h"
#include "model/texture/wide_texels.h"
#include "tests/texture/texture_fixture.h"
#include "tests/texture/wrapped_picture.h"

#include <cmath>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

constexpr Wrap Wraps[] = {Wrap::Repeat,
                          Wrap::MirroredRepeat,
                          Wrap::Clamp,
                          Wrap::ClampToEdge,
                          Wrap::ClampToBorder,
                          Wrap::MirrorClamp,
                          Wrap::MirrorClampToEdge,
                          Wrap::MirrorClampToBorder};

TextureShape shape_of(std::uint32_t width, std::uint32_t height) {
    return {TextureKind::TwoD, Format::Rgba8, width, height, 1, 1, 0};
}

Sampler sampler_of(TextureFilter filter, Wrap wrap) {
    Sampler sampler = linear_sampler(wrap);
    sampler.filter = filter;
    sampler.border_color = rgba8(Picture{}.border);
    return sampler;
}

double keys(double x) {
    const double d = std::fabs(x);
    if (d < 1) return 1.5 * d * d * d - 2.5 * d * d + 1;
    if (d < 2) return -0.5 * d * d * d + 2.5 * d * d - 4 * d + 2;
    return 0;
}

TEST_CASE("Bicubic magnification is Keys' convolution") {
    Random random(1);
    const Picture picture = random_picture(random, 32, 16);
    TextureMemory memory(shape_of(32, 16));
    put(picture, {}, memory);
    for (const Wrap wrap : Wraps) {
        const TextureUnit unit = memory.compile(sampler_of(TextureFilter::Bicubic, wrap));
        double worst = 0, sum_of_errors = 0;
        for (int n = 0; n < 2000; ++n) {
            const Pixel pixel{place(random, 32), place(random, 16)};
            const Color color = sample_pixel(unit, pixel, nullptr);
            const double u = held(wrap, pixel.u, 32) - 0.5, v = held(wrap, pixel.v, 16) - 0.5;
            for (unsigned channel = 0; channel < 4; ++channel) {
                double sum = 0;
                for (int y = int(std::floor(v)) - 1; y <= int(std::floor(v)) + 2; ++y)
                    for (int x = int(std::floor(u)) - 1; x <= int(std::floor(u)) + 2; ++x)
                        sum += keys(u - x) * keys(v - y) * picture.at(wrap, x, y, channel);
                const double error = std::clamp(sum, 0.0, 255.0) - color[channel];
                worst = std::max(worst, std::fabs(error));
                sum_of_errors += error;
            }
        }
        INFO(static_cast<int>(wrap));
        CHECK(worst < 1.7); // Four weights an axis within half of 2^-10, and the rounding.
        CHECK(std::fabs(sum_of_errors / 8000) < 0.1); // Rounded, not cut.
    }
    for (std::uint32_t weight = 0; weight < 256; ++weight) {
        const auto weights = bicubic_weights(weight);
        for (int i = 0; i < 4; ++i)
            CHECK(std::fabs(weights[static_cast<unsigned>(i)] -
                            1024 * keys(weight / 256.0 - (i - 1))) <= 1.51);
    }
}

TEST_CASE("A bicubic filter takes sixteen texels by four accesses, and only to magnify") {
    Random random(2);
    TextureMemory memory(shape_of(32, 16));
    memory.fill_random(random);
    const TextureUnit unit =
        memory.compile(sampler_of(TextureFilter::Bicubic, Wrap::ClampToBorder));
    TexelFootprints footprints;
    sample_pixel(unit, {8, 8, 0.5, 0, 0, 0.5}, &footprints);
    REQUIRE(footprints.accesses().size() == 4 * 4);
    std::set<std::pair<int, int>> texels;
    for (unsigned i = 0; i < 4; ++i) {
        const TexelAccess access = footprints.accesses()[i];
        for (const auto x : {access.x0, access.x1})
            for (const auto y : {access.y0, access.y1})
                texels.insert({x, y});
    }
    CHECK(texels.size() == 16);
    CHECK(*texels.begin() == std::pair{6, 6});
    CHECK(*texels.rbegin() == std::pair{9, 9});

    footprints = {};
    sample_pixel(unit, {8, 8, 4, 0, 0, 4}, &footprints);
    CHECK(footprints.accesses().size() == 4);

    // GL_NEAREST magnifies as it says.
    Sampler nearest = sampler_of(TextureFilter::Bicubic, Wrap::Repeat);
    nearest.magnify_linear = false;
    const Color texel = sample_pixel(memory.compile(nearest), {8.25, 8.75, 0.5, 0, 0, 0.5}, {});
    for (unsigned channel = 0; channel < 4; ++channel)
        CHECK(texel[channel] == static_cast<unsigned>(memory.at(0, 0, 8, 8)[channel]));
}

// Every image of a rip-map has texels of its own here, so that a wrong image cannot go unseen.
TEST_CASE("A rip-map's sample mixes the four images around the pixel's two sides") {
    constexpr std::uint32_t Width = 32, Height = 16;
    Random random(3);
    TextureMemory memory(shape_of(2 * Width, 2 * Height));
    std::vector<std::vector<Picture>> images(6);
    for (unsigned i = 0; i < 6; ++i)
        for (unsigned j = 0; j < 5; ++j) {
            images[i].push_back(random_picture(random, int(Width >> i), int(Height >> j)));
            put(images[i][j],
                {0, 2 * Width - (2 * Width >> i), 2 * Height - (2 * Height >> j)},
                memory);
        }
    struct Variant {
        bool linear = true;
        double bias = 0, least = 0, most = 20; // levels
    };
    const auto check = [&](Wrap wrap, const Variant& variant) {
        Sampler sampler = sampler_of(TextureFilter::RipMap, wrap);
        sampler.source_width = Width;
        sampler.source_height = Height;
        sampler.minify_linear = sampler.magnify_linear = variant.linear;
        const auto fixed = [](double level) { return static_cast<std::int16_t>(256 * level); };
        sampler.bias = fixed(variant.bias);
        sampler.min_lod = fixed(variant.least);
        sampler.max_lod = fixed(variant.most);
        const TextureUnit unit = memory.compile(sampler);
        REQUIRE(unit.filter == TextureFilter::RipMap);
        const auto sampled = [&](unsigned i, unsigned j, const Pixel& pixel, unsigned channel) {
            const auto place_along = [&](double at, unsigned level, int size) {
                return held(wrap, std::ldexp(at, -int(level)), size) - 0.5;
            };
            const double u = place_along(pixel.u, i, int(Width >> i));
            const double v = place_along(pixel.v, j, int(Height >> j));
            const int x = int(std::floor(u)), y = int(std::floor(v));
            const auto texel = [&](int dx, int dy) {
                return images[i][j].at(wrap, x + dx, y + dy, channel);
            };
            const double a = u - x, b = v - y;
            if (!variant.linear) return texel(a >= 0.5, b >= 0.5);
            return (texel(0, 0) * (1 - a) + texel(1, 0) * a) * (1 - b) +
                   (texel(0, 1) * (1 - a) + texel(1, 1) * a) * b;
        };
        // Coordinates have 8 fraction bits: which texel is the nearest may be in doubt.
        const auto is_doubtful = [&](double at, unsigned level) {
            const double texels = std::ldexp(at, -int(level));
            return !variant.linear && std::fabs(texels - std::round(texels)) < 1.0 / 256;
        };
        double worst = 0;
        for (int n = 0; n < 1000; ++n) {
            // Not so large that the lambdas are clamped; the shorter step decides nothing.
            const double ux = std::exp2(below(random, 4000) / 1000.0);
            const double vy = std::exp2(below(random, 3000) / 1000.0);
            const Pixel pixel{place(random, 32), place(random, 16), ux, 0.75 * vy, 0.75 * ux, vy};
            const Color color = sample_pixel(unit, pixel, nullptr);
            const auto level_of = [&](double step, unsigned last) {
                const double level =
                    std::clamp(std::log2(step) + variant.bias, variant.least, variant.most);
                return std::clamp(level, 0.0, double(last));
            };
            const double level_u = level_of(ux, 5), level_v = level_of(vy, 4);
            const auto i = std::min(unsigned(level_u), 4u), j = std::min(unsigned(level_v), 3u);
            const double a = level_u - i, b = level_v - j;
            if (is_doubtful(pixel.u, i) || is_doubtful(pixel.u, i + 1) || is_doubtful(pixel.v, j) ||
                is_doubtful(pixel.v, j + 1))
                continue;
            for (unsigned channel = 0; channel < 4; ++channel) {
                const auto mixed = [&](unsigned row) {
                    return sampled(i, row, pixel, channel) * (1 - a) +
                           sampled(i + 1, row, pixel, channel) * a;
                };
                worst = std::max(worst,
                                 std::fabs(mixed(j) * (1 - b) + mixed(j + 1) * b - color[channel]));
            }
        }
        INFO(static_cast<int>(wrap) << ", bias " << variant.bias << ", linear " << variant.linear);
        // Places within 2^-9 texel of small images, weights of 8 bits from a logarithm of 8 bits.
        CHECK(worst < 6);
    };
    for (const Wrap wrap : Wraps)
        check(wrap, {});
    check(Wrap::Repeat, {.bias = 0.5, .least = 1.25, .most = 2.25});
    check(Wrap::Repeat, {.linear = false});
}

// The mean over a box: 1 / 256 of a texel after the other.
double covered(double from, double to, int texel) {
    return std::max(0.0, std::min(to, texel + 1.0) - std::max(from, double(texel)));
}

TEST_CASE("A summed-area table gives the mean over the pixel's box") {
    constexpr int Width = 32, Height = 16;
    Random random(4);
    const Picture picture = random_picture(random, Width, Height);
    TextureMemory memory(shape_of(4 * Width, Height));
    for (int y = 0; y < Height; ++y)
        for (int x = 0; x < Width; ++x)
            for (unsigned channel = 0; channel < 4; ++channel) {
                std::uint32_t sum = 0;
                for (int j = 0; j <= y; ++j)
                    for (int i = 0; i <= x; ++i)
                        sum += static_cast<std::uint32_t>(picture.texel(i, j)[channel]);
                memory.put_rgba8(
                    0, 0, 4 * static_cast<unsigned>(x) + channel, static_cast<unsigned>(y), sum);
            }
    for (const Wrap wrap : Wraps) {
        Sampler sampler = sampler_of(TextureFilter::SummedArea, wrap);
        sampler.source_width = Width;
        sampler.source_height = Height;
        const TextureUnit unit = memory.compile(sampler);
        REQUIRE(unit.filter == TextureFilter::SummedArea);
        double worst = 0;
        for (int n = 0; n < 1000; ++n) {
            const double ux = (4 * below(random, 64 * Width) + 4) / 256.0;
            const double vy = (4 * below(random, 64 * Height) + 4) / 256.0;
            const Pixel pixel{place(random, Width), place(random, Height), ux, vy / 2, ux / 2, vy};
            const Color color = sample_pixel(unit, pixel, nullptr);
            const double u = held(wrap, pixel.u, Width), v = held(wrap, pixel.v, Height);
            const double half_u = std::max(1.0, pixel.ux) / 2, half_v = std::max(1.0, pixel.vy) / 2;
            for (unsigned channel = 0; channel < 4; ++channel) {
                double sum = 0, area = 0;
                for (int y = int(std::floor(v - half_v)); y < v + half_v; ++y)
                    for (int x = int(std::floor(u - half_u)); x < u + half_u; ++x) {
                        const double part =
                            covered(u - half_u, u + half_u, x) * covered(v - half_v, v + half_v, y);
                        sum += part * picture.at(wrap, x, y, channel);
                        area += part;
                    }
                worst = std::max(worst, std::fabs(sum / area - color[channel]));
            }
        }
        INFO(static_cast<int>(wrap));
        CHECK(worst < 0.5001); // Exact, but for the last rounding.
    }
}

TEST_CASE("The elliptic filter is Heckbert's weighted average") {
    constexpr int Width = 32, Height = 16;
    Random random(5);
    const Picture picture = random_picture(random, Width, Height);
    TextureMemory memory(shape_of(Width, Height));
    put(picture, {}, memory);
    for (const Wrap wrap : Wraps) {
        const TextureUnit unit = memory.compile(sampler_of(TextureFilter::Elliptic, wrap));
        double worst = 0;
        for (int n = 0; n < 500; ++n) {
            const auto step = [&] { return (below(random, 4096) - 2048.0) / 256; };
            Pixel pixel{
                place(random, Width), place(random, Height), step(), step(), step(), step()};
            pixel.ux = std::copysign(std::max(std::fabs(pixel.ux), 1.5), pixel.ux); // minified
            const Color color = sample_pixel(unit, pixel, nullptr);
            const double a = pixel.vx * pixel.vx + pixel.vy * pixel.vy + 1;
            const double b = -2 * (pixel.ux * pixel.vx + pixel.uy * pixel.vy);
            const double c = pixel.ux * pixel.ux + pixel.uy * pixel.uy + 1;
            const double f = a * c - b * b / 4;
            const double at_u = held(wrap, pixel.u, Width), at_v = held(wrap, pixel.v, Height);
            for (unsigned channel = 0; channel < 4; ++channel) {
                double sum = 0, total = 0;
                for (int y = int(at_v) - 20; y <= int(at_v) + 20; ++y)
                    for (int x = int(at_u) - 20; x <= int(at_u) + 20; ++x) {
                        const double u = x + 0.5 - at_u, v = y + 0.5 - at_v;
                        const double q = (a * u * u + b * u * v + c * v * v) / f;
                        if (q >= 1) continue;
                        sum += std::exp2(-6 * q) * picture.at(wrap, x, y, channel);
                        total += std::exp2(-6 * q);
                    }
                worst = std::max(worst, std::fabs(sum / total - color[channel]));
            }
        }
        INFO(static_cast<int>(wrap));
        CHECK(worst < 2); // Weights of 8 bits for steps of 1/128.
    }
}

TEST_CASE("Every access of a wide filter is what it reads") {
    class Reads final : public TexelObserver {
    public:
        void level(const TexelAccess& access, const std::array<AxisTexels, 3>&) override {
            for (unsigned corner = 0; corner < 4; ++corner)
                if ((corner & ~unsigned{access.linear}) == 0)
                    promised.insert(
                        {corner & 1 ? access.x1 : access.x0, corner & 2 ? access.y1 : access.y0});
        }
        void read(unsigned, unsigned, unsigned x, unsigned y) override { made.insert({x, y}); }
        std::multiset<std::pair<unsigned, unsigned>> promised, made;
    };
    Random random(6);
    TextureMemory memory(shape_of(128, 32));
    memory.fill_random(random);
    for (const TextureFilter filter : {TextureFilter::Bicubic,
                                       TextureFilter::RipMap,
                                       TextureFilter::SummedArea,
                                       TextureFilter::Elliptic,
                                       TextureFilter::Feline})
        for (const Wrap wrap : {Wrap::Repeat, Wrap::ClampToBorder, Wrap::MirroredRepeat}) {
            Sampler sampler = sampler_of(filter, wrap);
            sampler.source_width = 32;
            sampler.source_height = 16;
            const TextureUnit unit = memory.compile(sampler);
            for (int n = 0; n < 200; ++n) {
                const auto planes = make_planes(1, [&](unsigned) {
                    const auto anywhere = [&] {
                        return static_cast<float>(below(random, 4096)) / 1024 - 2;
                    };
                    return Coordinates{anywhere(), anywhere()};
                });
                ColorPlanes out;
                Reads reads;
                sample_scalar(unit, *planes, all_quads(1), out, nullptr, &reads);
                REQUIRE(reads.promised == reads.made);
                REQUIRE(!reads.made.empty());
            }
        }
}

TEST_CASE("A table that the image cannot hold is not read") {
    TextureMemory memory(shape_of(64, 32));
    Sampler sampler = sampler_of(TextureFilter::RipMap, Wrap::Repeat);
    sampler.source_width = 32;
    sampler.source_height = 16;
    CHECK(memory.compile(sampler).filter == TextureFilter::RipMap);
    sampler.source_width = 34; // 34 + 17 + 8 + 4 + 2 + 1 columns
    CHECK(memory.compile(sampler).filter == TextureFilter::Standard);
    sampler.source_width = 0;
    CHECK(memory.compile(sampler).filter == TextureFilter::Standard);
    sampler = sampler_of(TextureFilter::SummedArea, Wrap::Repeat);
    sampler.source_width = 16;
    sampler.source_height = 32;
    CHECK(memory.compile(sampler).filter == TextureFilter::SummedArea);
    sampler.source_height = 33;
    CHECK(memory.compile(sampler).filter == TextureFilter::Standard);
}

} // namespace
} // namespace ffgpu::test
