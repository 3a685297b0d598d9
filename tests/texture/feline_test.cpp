// Feline against the paper's formulas in double precision, probe by probe, and what it reads.

#include "tests/texture/texture_fixture.h"
#include "tests/texture/wrapped_picture.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

constexpr int Width = 64, Height = 32;
constexpr unsigned Levels = 7;
constexpr double Pi = 3.14159265358979323846;

// Levels of their own, so that a wrong one cannot go unseen.
struct Pyramid {
    explicit Pyramid(Random& random)
        : memory({TextureKind::TwoD, Format::Rgba8, Width, Height, 1, Levels, 0}) {
        for (unsigned level = 0; level < Levels; ++level) {
            levels.push_back(
                random_picture(random, std::max(Width >> level, 1), std::max(Height >> level, 1)));
            put(levels.back(), {level, 0, 0}, memory);
        }
    }

    TextureUnit unit(Wrap wrap, unsigned probes) const {
        Sampler sampler = linear_sampler(wrap);
        sampler.filter = TextureFilter::Feline;
        sampler.border_color = rgba8(Picture{}.border);
        sampler.mip_filter = MipFilter::Linear;
        sampler.max_anisotropy = static_cast<std::uint8_t>(probes);
        return memory.compile(sampler);
    }

    // At texels (u, v) of level 0.
    double bilinear(Wrap wrap, unsigned level, double u, double v, unsigned channel) const {
        const Picture& picture = levels[level];
        const auto place = [&](double at, int size) { return held(wrap, at * size, size) - 0.5; };
        const double s = place(u / Width, picture.width), t = place(v / Height, picture.height);
        const int x = int(std::floor(s)), y = int(std::floor(t));
        const double a = s - x, b = t - y;
        const auto texel = [&](int i, int j) { return picture.at(wrap, x + i, y + j, channel); };
        return (texel(0, 0) * (1 - a) + texel(1, 0) * a) * (1 - b) +
               (texel(0, 1) * (1 - a) + texel(1, 1) * a) * b;
    }

    double trilinear(Wrap wrap, double lambda, double u, double v, unsigned channel) const {
        const double held = std::clamp(lambda, 0.0, Levels - 1.0);
        const auto level = std::min(unsigned(held), Levels - 2);
        const double next = held - level;
        return bilinear(wrap, level, u, v, channel) * (1 - next) +
               bilinear(wrap, level + 1, u, v, channel) * next;
    }

    std::vector<Picture> levels;
    TextureMemory memory;
};

// The paper's section 3, in its own terms.
struct Line {
    double major = 1, minor = 1, theta = 0, wanted = 1;
    int probes = 1;

    Line(const Pixel& p, unsigned most) {
        const double a_nn = p.vx * p.vx + p.vy * p.vy;
        const double b_nn = -2 * (p.ux * p.vx + p.uy * p.vy);
        const double c_nn = p.ux * p.ux + p.uy * p.uy;
        const double f_nn = a_nn * c_nn - b_nn * b_nn / 4;
        const double a = a_nn / f_nn, b = b_nn / f_nn, c = c_nn / f_nn;
        const double root = std::hypot(a - c, b);
        major = std::max(std::sqrt(2 / (a + c - root)), 1.0);
        minor = std::max(std::sqrt(2 / (a + c + root)), 1.0);
        theta = std::atan(b / (a - c)) / 2 + (a > c ? Pi / 2 : 0);
        wanted = 2 * major / minor - 1;
        probes = std::min(int(std::floor(wanted + 0.5)), int(most));
        if (probes < wanted) minor = 2 * major / (probes + 1);
    }

    // Whether rounding may choose another number of probes than exact arithmetic.
    bool is_near_a_choice() const {
        const double rest = wanted + 0.5 - std::floor(wanted + 0.5);
        return rest < 1e-3 || rest > 1 - 1e-3;
    }
};

double expected(
    const Pyramid& pyramid, Wrap wrap, const Pixel& pixel, const Line& line, unsigned channel) {
    double sum = 0, weights = 0;
    const double step = line.probes > 1 ? 2 * (line.major - line.minor) / (line.probes - 1) : 0;
    for (int n = 1 - line.probes; n < line.probes; n += 2) {
        const double along = n / 2.0 * step, d = along / line.major;
        const double weight = std::exp2(-6 * d * d);
        sum += weight * pyramid.trilinear(wrap,
                                          std::log2(line.minor),
                                          pixel.u + along * std::cos(line.theta),
                                          pixel.v + along * std::sin(line.theta),
                                          channel);
        weights += weight;
    }
    return sum / weights;
}

Pixel minified(Random& random) {
    const auto step = [&] { return (below(random, 4096) - 2047.5) / 256; };
    Pixel pixel{place(random, Width), place(random, Height), step(), step(), step(), step()};
    pixel.ux = std::copysign(std::max(std::fabs(pixel.ux), 1.5), pixel.ux);
    return pixel;
}

} // namespace

TEST_CASE("Feline's probes are the paper's") {
    Random random(31);
    const Pyramid pyramid(random);
    for (const Wrap wrap : {Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge, Wrap::Clamp})
        for (const unsigned most : {16u, 5u, 2u}) {
            const TextureUnit unit = pyramid.unit(wrap, most);
            double worst = 0, squares = 0;
            int compared = 0;
            for (int n = 0; n < 400; ++n) {
                const Pixel pixel = minified(random);
                const Line line(pixel, most);
                if (line.is_near_a_choice()) continue;
                const Color color = sample_pixel(unit, pixel, nullptr);
                for (unsigned channel = 0; channel < 4; ++channel) {
                    const double error =
                        expected(pyramid, wrap, pixel, line, channel) - color[channel];
                    worst = std::max(worst, std::fabs(error));
                    squares += error * error;
                    ++compared;
                }
            }
            INFO(static_cast<int>(wrap) << ", " << most << " probes");
            REQUIRE(compared > 1500);
            // A logarithm of 8 bits between levels that have nothing in common, places within
            // 2^-9 texel of the level.
            CHECK(worst < 5);
            CHECK(std::sqrt(squares / compared) < 1.2);
        }
}

TEST_CASE("Feline reads a trilinear sample a probe, and magnifies as ever") {
    Random random(32);
    const Pyramid pyramid(random);
    const TextureUnit unit = pyramid.unit(Wrap::Repeat, 16);
    const auto reads = [&](const Pixel& pixel) {
        TexelFootprints footprints;
        sample_pixel(unit, pixel, &footprints);
        return footprints.accesses().size() / 4; // of the quad's four fragments
    };
    CHECK(reads({8, 8, 12, 0, 0, 3}) == 2 * 7);  // 2 12/3 - 1 probes between levels 1 and 2
    CHECK(reads({8, 8, 0, 12, 3, 0}) == 2 * 7);  // turned
    CHECK(reads({8, 8, 12, 0, 0, 4}) == 5);      // all of level 2
    CHECK(reads({8, 8, 2, 0, 0, 2}) == 1);       // a circle
    CHECK(reads({8, 8, 3, 0, 0, 0.25}) == 5);    // The shorter axis counts as a texel.
    CHECK(reads({8, 8, 0.5, 0, 0, 0.5}) == 1);   // magnified
    CHECK(reads({8, 8, 60, 0, 0, 1}) == 2 * 16); // as many as there may be
    CHECK(pyramid.unit(Wrap::Repeat, 1).max_probes == 16);
}

} // namespace ffgpu::test
