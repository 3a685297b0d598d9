// Filters against what they stand for: the mean of the texels under a pixel, by brute force, over a
// family of pictures and of footprints as a floor has them.

#include "tests/texture/texture_fixture.h"
#include "tests/texture/wrapped_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

constexpr int Side = 128;
constexpr unsigned Levels = 8;
constexpr double Pi = 3.14159265358979323846;

using Grey = std::function<int(int x, int y)>;

// The picture and its levels, each texel the mean of four.
struct Floor {
    explicit Floor(const Grey& grey)
        : memory({TextureKind::TwoD, Format::Rgba8, Side, Side, 1, Levels, 0}) {
        Picture picture{.width = Side, .height = Side, .texels = {}};
        for (int i = 0; i < Side * Side; ++i)
            picture.texels.push_back({grey(i % Side, i / Side), 0, 0, 255});
        base = picture;
        for (unsigned level = 0; level < Levels; ++level) {
            put(picture, {level, 0, 0}, memory);
            picture = halved(picture);
        }
    }

    static Picture halved(const Picture& picture) {
        Picture half{.width = picture.width / 2, .height = picture.height / 2, .texels = {}};
        for (int i = 0; i < half.width * half.height; ++i) {
            const int x = 2 * (i % half.width), y = 2 * (i / half.width);
            const auto red = [&](int dx, int dy) { return picture.texel(x + dx, y + dy)[0]; };
            half.texels.push_back({(red(0, 0) + red(1, 0) + red(0, 1) + red(1, 1) + 2) / 4, 0, 0});
        }
        return half;
    }

    // Of the parallelogram of the pixel's sides, by 32 x 32 points.
    double average(const Pixel& pixel) const {
        constexpr int Points = 32;
        double sum = 0;
        for (int i = 0; i < Points * Points; ++i) {
            const double x = (i % Points + 0.5) / Points - 0.5;
            const double y = (int(i / Points) + 0.5) / Points - 0.5;
            const double u = pixel.u + x * pixel.ux + y * pixel.uy;
            const double v = pixel.v + x * pixel.vx + y * pixel.vy;
            // u and v are not far below 0.
            const auto texel = [](double at) {
                return static_cast<std::size_t>(std::floor(at) + 16 * Side) % Side;
            };
            sum += base.texels[texel(v) * Side + texel(u)][0];
        }
        return sum / (Points * Points);
    }

    Picture base;
    TextureMemory memory;
};

// Any direction, 1 to 4 texels wide and up to 2^slant times as long.
Pixel footprint(Random& random, double slant) {
    const auto unit = [&] { return below(random, 65536) / 65536.0; };
    const double angle = unit() * 2 * Pi;
    const double shorter = std::exp2(2 * unit()), longer = shorter * std::exp2(slant * unit());
    return {place(random, Side) / 3,
            place(random, Side) / 3,
            shorter * std::cos(angle),
            shorter * std::sin(angle),
            -longer * std::sin(angle),
            longer * std::cos(angle)};
}

struct Filter {
    TextureFilter filter = TextureFilter::Standard;
    unsigned probes = 1;
};

double error_of(const Floor& floor, const Filter& filter, double slant) {
    Sampler sampler = linear_sampler(Wrap::Repeat);
    sampler.mip_filter = MipFilter::Linear;
    sampler.filter = filter.filter;
    sampler.max_anisotropy = static_cast<std::uint8_t>(filter.probes);
    const TextureUnit unit = floor.memory.compile(sampler);
    Random random(41);
    constexpr int Pixels = 300;
    double squares = 0;
    for (int n = 0; n < Pixels; ++n) {
        const Pixel pixel = footprint(random, slant);
        const double error = sample_pixel(unit, pixel, nullptr)[0] - floor.average(pixel);
        squares += error * error;
    }
    return std::sqrt(squares / Pixels);
}

int checker(int x, int y, int size) {
    return (x / size + y / size) % 2 * 255;
}

} // namespace

TEST_CASE("Elliptic samples are nearer to the area average than Feline and trilinear") {
    Random random(42);
    std::array<std::array<int, Side>, Side> noise{};
    for (auto& row : noise)
        for (int& texel : row)
            texel = static_cast<int>(below(random, 256));
    std::vector<std::pair<std::string, Grey>> pictures{
        {"noise", [&](int x, int y) { return noise.at(unsigned(y)).at(unsigned(x)); }}};
    for (const int size : {2, 4, 8, 16, 32, 64})
        pictures.emplace_back("checkers of " + std::to_string(size),
                              [size](int x, int y) { return checker(x, y, size); });
    for (const int size : {3, 5, 8})
        pictures.emplace_back("stripes of " + std::to_string(size),
                              [size](int x, int) { return x % (3 * size) < size ? 20 : 235; });
    // A slant of 1.5 is a floor that is seen from above, one of 4 a grazing one.
    for (const double slant : {1.5, 4.0})
        for (const auto& [name, grey] : pictures) {
            const Floor floor(grey);
            const auto error = [&](const Filter& filter) { return error_of(floor, filter, slant); };
            const double trilinear = error({});
            const double elliptic = error({TextureFilter::Elliptic});
            const double feline = error({TextureFilter::Feline, 16});
            INFO(name << ", slant " << slant << ": trilinear " << trilinear << ", elliptic "
                      << elliptic << ", Feline " << feline);
            CHECK(elliptic < trilinear);
            CHECK(feline < trilinear);
            CHECK(elliptic < feline);
        }
}

} // namespace ffgpu::test
