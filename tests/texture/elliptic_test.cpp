// Which level the elliptic filter takes, and how far it reaches there.

#include "tests/texture/texture_fixture.h"
#include "tests/texture/wrapped_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

constexpr int Side = 256;
constexpr unsigned Levels = 9;

// Levels that have nothing in common, so that a wrong one cannot go unseen.
struct Pyramid {
    explicit Pyramid(Random& random)
        : memory({TextureKind::TwoD, Format::Rgba8, Side, Side, 1, Levels, 0}) {
        for (unsigned level = 0; level < Levels; ++level) {
            levels.push_back(random_picture(random, Side >> level, Side >> level));
            put(levels.back(), {level, 0, 0}, memory);
        }
    }

    TextureUnit unit(MipFilter mip_filter) const {
        Sampler sampler = linear_sampler(Wrap::Repeat);
        sampler.filter = TextureFilter::Elliptic;
        sampler.mip_filter = mip_filter;
        return memory.compile(sampler);
    }

    std::vector<Picture> levels;
    TextureMemory memory;
};

struct Step {
    double u = 0, v = 0;

    double length() const { return std::hypot(u, v); }
    // In texels of a level, at most 32 of them along either axis.
    Step at_level(unsigned level) const {
        const double scale = std::ldexp(1, -int(level));
        const double longer = scale * std::max(std::fabs(u), std::fabs(v));
        const double kept = longer > 32 ? scale * 32 / longer : scale;
        return {kept * u, kept * v};
    }
};

// That of as many probes as cover the longer side, 16 at most; nothing where rounding may choose
// another one.
std::optional<unsigned> level_of(const Step& x, const Step& y) {
    const double longer = std::max(x.length(), y.length());
    const double shorter = std::max(std::min(x.length(), y.length()), 1.0);
    const double ratio = longer / shorter;
    if (std::fabs(ratio - std::round(ratio)) < 0.05) return std::nullopt;
    const double lambda = std::log2(longer / std::min(std::ceil(ratio), 16.0));
    if (std::fabs(lambda - std::round(lambda)) < 0.02) return std::nullopt;
    return static_cast<unsigned>(std::clamp(std::floor(lambda), 0.0, Levels - 1.0));
}

double expected(const Picture& picture, const Pixel& at, const Step& x, const Step& y) {
    const double a = x.v * x.v + y.v * y.v + 1, b = -2 * (x.u * x.v + y.u * y.v);
    const double c = x.u * x.u + y.u * y.u + 1, f = a * c - b * b / 4;
    double sum = 0, total = 0;
    for (int j = int(at.v) - 50; j <= int(at.v) + 50; ++j)
        for (int i = int(at.u) - 50; i <= int(at.u) + 50; ++i) {
            const double u = i + 0.5 - at.u, v = j + 0.5 - at.v;
            const double q = (a * u * u + b * u * v + c * v * v) / f;
            if (q >= 1) continue;
            sum += std::exp2(-6 * q) * picture.at(Wrap::Repeat, i, j, 0);
            total += std::exp2(-6 * q);
        }
    return sum / total;
}

} // namespace

TEST_CASE("An elliptic sample is of the level of 16 probes, and no side is longer than 32 texels") {
    Random random(51);
    const Pyramid pyramid(random);
    const auto texels = [&](double most) { return (below(random, 65536) / 32768.0 - 1) * most; };
    for (const MipFilter mip_filter : {MipFilter::Linear, MipFilter::None}) {
        const TextureUnit unit = pyramid.unit(mip_filter);
        double worst = 0;
        int compared = 0, shortened = 0;
        for (int n = 0; n < 600; ++n) {
            const Step x{texels(60), texels(60)}, y{texels(6), texels(6)};
            const auto level = mip_filter == MipFilter::None ? 0u : level_of(x, y);
            if (!level || y.length() < 1) continue;
            const double scale = std::ldexp(1, -int(*level));
            const Pixel pixel{place(random, Side) / 3, place(random, Side) / 3, x.u, x.v, y.u, y.v};
            const Color color = sample_pixel(unit, pixel, nullptr);
            const double wanted = expected(pyramid.levels[*level],
                                           {.u = pixel.u * scale, .v = pixel.v * scale},
                                           x.at_level(*level),
                                           y.at_level(*level));
            worst = std::max(worst, std::fabs(wanted - color[0]));
            shortened += scale * std::max(std::fabs(x.u), std::fabs(x.v)) > 32;
            ++compared;
        }
        INFO(static_cast<int>(mip_filter) << ": " << compared << ", shortened " << shortened);
        CHECK(compared > 300);
        CHECK((mip_filter == MipFilter::None) == (shortened > 100));
        CHECK(worst < 2);
    }
}

} // namespace ffgpu::test
