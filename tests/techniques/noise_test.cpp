// Noise, grown textures and cuts against closed forms and exhaustive search.

#include "techniques/noise.h"
#include "techniques/quilting.h"
#include "techniques/random.h"
#include "techniques/reaction_diffusion.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

namespace ffgpu::techniques {
namespace {

TEST_CASE("SplitMix64 draws its published numbers") {
    // The reference implementation's first outputs for seed 1234567 (Vigna's splitmix64.c).
    Random random(1234567);
    CHECK(random.next() == 6457827717110365317u);
    CHECK(random.next() == 3203168211198807973u);
    CHECK(random.next() == 9817491932198370423u);
}

TEST_CASE("Fourier: frequencies lie in the annulus, one wave is a cosine") {
    for (const Wave& wave : annulus_waves(3, 200, 4, 9)) {
        CHECK(glm::length(wave.frequency) >= 4);
        CHECK(glm::length(wave.frequency) <= 9);
    }
    const std::vector<Wave> one{{{2, 3}, 0.5, 0.25}};
    CHECK(fourier(one, {0.1, 0.7}) == Approx(0.5 * std::cos(0.2 + 2.1 + 0.25)));
}

TEST_CASE("w(t) = 2|t|^3 - 3t^2 + 1") {
    CHECK(GradientNoise::weight(0) == 1);
    CHECK(GradientNoise::weight(1) == 0);
    CHECK(GradientNoise::weight(-1) == 0);
    CHECK(GradientNoise::weight(1.5) == 0);
    CHECK(GradientNoise::weight(0.5) == Approx(0.5));
    CHECK(GradientNoise::weight(-0.25) == Approx(2.0 / 64 - 3.0 / 16 + 1));
}

TEST_CASE("gradient noise is 0 at lattice points with the gradient as its slope there") {
    const GradientNoise noise(5);
    for (const glm::dvec3 point : {glm::dvec3(0, 0, 0), {3, -2, 7}, {-5, 1, -1}}) {
        CHECK(noise(point) == 0);
        const glm::dvec3 slope = noise.gradient(
            static_cast<int>(point.x), static_cast<int>(point.y), static_cast<int>(point.z));
        CHECK(glm::length(slope) == Approx(1));
        constexpr double Step = 1e-5;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0);
            step[axis] = Step;
            CHECK((noise(point + step) - noise(point - step)) / (2 * Step) ==
                  Approx(slope[axis]).margin(1e-4));
        }
    }
}

TEST_CASE("noise along a lattice edge is the two ends' slopes, weighted") {
    const GradientNoise noise(11);
    const double t = 0.3;
    const double expected = (1 - 3 * t * t + 2 * t * t * t) * noise.gradient(4, 0, 0).x * t +
                            (3 * t * t - 2 * t * t * t) * noise.gradient(5, 0, 0).x * (t - 1);
    CHECK(noise({4 + t, 0, 0}) == Approx(expected));
}

TEST_CASE("periodic noise repeats, other noise does not") {
    const glm::dvec3 point(0.3, 1.7, 2.2);
    CHECK(GradientNoise(9, 4)(point) == Approx(GradientNoise(9, 4)(point + glm::dvec3(4, -4, 8))));
    CHECK(GradientNoise(9)(point) != Approx(GradientNoise(9)(point + glm::dvec3(4, -4, 8))));
}

TEST_CASE("turbulence sums sizes of octaves; stripes without swing are a sine") {
    const GradientNoise noise(2);
    const glm::dvec3 point(0.4, 0.2, 0.9);
    CHECK(turbulence(noise, point, 2) ==
          Approx(std::abs(noise(point)) + std::abs(noise(2.0 * point)) / 2));
    const Stripes plain{{0, 1, 0}, 0.5};
    CHECK(stripe(plain, noise, {7, 0.125, 3}) == Approx(1));
    CHECK(stripe(plain, noise, {7, 0.375, 3}) == Approx(0).margin(1e-12));
}

TEST_CASE("reaction and diffusion: an even plate follows the reaction's own equation") {
    Reaction reaction{Field(4, 4, 0.6), Field(4, 4, 0.2)};
    const GrayScott rates;
    advance(reaction, rates, 1);
    CHECK(reaction.u.at(1, 2) == Approx(0.6 - 0.6 * 0.04 + rates.feed * 0.4));
    CHECK(reaction.v.at(1, 2) == Approx(0.2 + 0.6 * 0.04 - (rates.feed + rates.kill) * 0.2));
}

TEST_CASE("diffusion alone spreads a wave as its eigenvalue says and keeps the sum") {
    constexpr int Size = 16;
    Reaction reaction{Field(Size, Size, 0), Field(Size, Size, 0)};
    const double k = 2 * std::numbers::pi * 3 / Size;
    for (int y = 0; y < Size; ++y) {
        for (int x = 0; x < Size; ++x)
            reaction.u.at(x, y) = std::cos(k * x);
    }
    advance(reaction, {0.2, 0.1, 0, 0}, 5);
    const double factor = std::pow(1 + 0.2 * (2 * std::cos(k) - 2), 5);
    for (int x = 0; x < Size; ++x)
        CHECK(reaction.u.at(x, 7) == Approx(factor * std::cos(k * x)).margin(1e-12));
}

// The least sum over all paths, by trying each.
double least_path(const Field& error, int column, int row) {
    if (column < 0 || column >= error.width) return HUGE_VAL;
    if (row == error.height - 1) return error.at(column, row);
    double least = HUGE_VAL;
    for (int step = -1; step <= 1; ++step)
        least = std::min(least, least_path(error, column + step, row + 1));
    return error.at(column, row) + least;
}

TEST_CASE("the minimum-error cut is as good as the best of all paths") {
    Random random(1);
    for (int trial = 0; trial < 20; ++trial) {
        Field error(5, 8);
        for (double& value : error.values)
            value = random.unit();
        const std::vector<int> path = minimum_error_cut(error);
        REQUIRE(path.size() == 8);
        double sum = 0, least = HUGE_VAL;
        for (int row = 0; row < 8; ++row) {
            const auto at = static_cast<std::size_t>(row);
            sum += error.at(path[at], row);
            if (row > 0) CHECK(std::abs(path[at] - path[at - 1]) <= 1);
        }
        for (int column = 0; column < 5; ++column)
            least = std::min(least, least_path(error, column, 0));
        CHECK(sum == Approx(least));
    }
}

TEST_CASE("a quilt of a periodic picture whose period the pieces find has no seam") {
    Field source(40, 40);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x)
            source.at(x, y) = (x / 2 + y / 2) % 2;
    }
    const Field result = quilt(source, {12, 4, 3, 200}, 7);
    REQUIRE(result.width == 28);
    for (int y = 0; y < 28; ++y) {
        for (int x = 0; x < 26; ++x)
            CHECK(result.at(x, y) != result.at(x + 2, y));
    }
}

} // namespace
} // namespace ffgpu::techniques
