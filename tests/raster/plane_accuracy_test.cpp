// The error of texture coordinates against exact barycentric interpolation in long double, on
// random triangles and slivers, in 1/256 texel after the texture unit's rounding to it. Set
// FFGPU_PLANE_TRIANGLES for another number of triangles.

#include "model/raster/interpolator.h"
#include "tests/raster/raster_helpers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

using Real = long double;

struct Triangle {
    WindowVertex v[3];

    // Twice the area, in 1/65536 pixel.
    std::int64_t area() const {
        return double_area({v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y});
    }
    double altitude() const { // pixels
        double longest = 0;
        for (int i = 0; i < 3; ++i) {
            const WindowVertex &a = v[i], &b = v[(i + 1) % 3];
            longest = std::max(longest, std::hypot(a.x - b.x, a.y - b.y));
        }
        return static_cast<double>(std::abs(area())) / longest / 256;
    }
};

// 1024 x 768 pixels, w from 1 to 100. Each fourth is a sliver.
Triangle random_triangle(Random& random, float repeats, bool sliver) {
    Triangle t;
    for (WindowVertex& each : t.v) {
        each = vertex(random.below(1024 * 256), random.below(768 * 256));
        each.inverse_w = 1 / (1 + random.unit() * random.unit() * 99);
        each.attributes[0] = random.unit() * repeats;
    }
    if (sliver) {
        const float along = random.unit();
        const auto between = [&](int a, int b) {
            return a + static_cast<int>(along * static_cast<float>(b - a)) +
                   random.between(-600, 600);
        };
        t.v[2].x = std::clamp(between(t.v[0].x, t.v[1].x), 0, 1024 * 256 - 1);
        t.v[2].y = std::clamp(between(t.v[0].y, t.v[1].y), 0, 768 * 256 - 1);
    }
    return t;
}

// The coordinate at a pixel's centre; false where that lies outside.
bool true_coordinate(const Triangle& t, int x, int y, Real& s) {
    const auto& v = t.v;
    const std::int64_t px = x * 256 + 128, py = y * 256 + 128;
    Real weighted = 0, weights = 0;
    for (int i = 0; i < 3; ++i) {
        const WindowVertex &a = v[(i + 1) % 3], &b = v[(i + 2) % 3];
        const std::int64_t part =
            std::int64_t{b.x - a.x} * (py - a.y) - std::int64_t{b.y - a.y} * (px - a.x);
        const Real weight = static_cast<Real>(part) / static_cast<Real>(t.area());
        if (weight <= 0) return false;
        weighted +=
            weight * static_cast<Real>(v[i].inverse_w) * static_cast<Real>(v[i].attributes[0]);
        weights += weight * static_cast<Real>(v[i].inverse_w);
    }
    s = weighted / weights;
    return true;
}

// The model's coordinate at a pixel, by way of a batch of one quad.
class Model {
public:
    Model() {
        setup_.layout.tex_coord[0] = 0;
        setup_.layout.tex_components[0] = 2;
        setup_.layout.count = 2;
        batch_->quad_count = 1;
    }
    bool set_up(const Triangle& t) { return buffer_.triangle(setup_, t.v[0], t.v[1], t.v[2]); }
    float at(int x, int y) {
        batch_->x[0] = static_cast<std::uint16_t>(x & ~1);
        batch_->y[0] = static_cast<std::uint16_t>(y & ~1);
        batch_->tile_x = static_cast<std::uint16_t>(x & ~127);
        batch_->tile_y = static_cast<std::uint16_t>(y & ~127);
        const BatchRun run{&buffer_.record(), 0};
        interpolate_perspective({&run, 1}, *batch_, *planes_);
        interpolate_tex_coords(setup_.layout, 0, {&run, 1}, *planes_, *batch_, *coords_);
        return coords_->s[static_cast<unsigned>((x & 1) + 2 * (y & 1))];
    }

private:
    SetupContext setup_ = context({0, 0, 1024, 768});
    RecordBuffer buffer_;
    std::unique_ptr<FragmentBatch> batch_ = std::make_unique<FragmentBatch>();
    std::unique_ptr<PerspectivePlanes> planes_ = std::make_unique<PerspectivePlanes>();
    std::unique_ptr<TexCoordPlanes> coords_ = std::make_unique<TexCoordPlanes>();
};

unsigned triangle_count() {
    const char* const asked = std::getenv("FFGPU_PLANE_TRIANGLES");
    return asked ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 20000;
}

// The greatest error in 1/256 texel.
Real worst_error(float texels, float repeats) {
    Random random(31);
    Model model;
    Real worst = 0;
    for (unsigned n = 0; n < triangle_count(); ++n) {
        Triangle t = random_triangle(random, repeats, n % 4 == 0);
        if (t.area() == 0 || t.altitude() < 0.5) continue;
        if (!model.set_up(t)) continue;
        for (int i = 0; i < 8; ++i) {
            float a = random.unit(), b = random.unit();
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const auto between = [&](int p, int q, int r) {
                return static_cast<int>(static_cast<float>(p) + a * static_cast<float>(q - p) +
                                        b * static_cast<float>(r - p)) >>
                       8;
            };
            const int x = between(t.v[0].x, t.v[1].x, t.v[2].x);
            const int y = between(t.v[0].y, t.v[1].y, t.v[2].y);
            Real s = 0;
            if (!true_coordinate(t, x, y, s)) continue;
            const double raw = std::nearbyint(static_cast<double>(model.at(x, y) * (256 * texels)));
            worst = std::max(
                worst, std::fabs(static_cast<Real>(raw) - s * 256 * static_cast<Real>(texels)));
        }
    }
    return worst;
}

} // namespace

TEST_CASE("texture coordinates err by at most 2/256 texel of 1024 texels 16 times repeated") {
    const Real once = worst_error(1024, 1), repeated = worst_error(1024, 16);
    const Real large = worst_error(4096, 16);
    WARN("1/256 texel: 1024 x 1 " << static_cast<double>(once) << ", 1024 x 16 "
                                  << static_cast<double>(repeated) << ", 4096 x 16 "
                                  << static_cast<double>(large));
    CHECK(once < 1);
    CHECK(repeated <= 2);
    CHECK(large <= 8);
    CHECK(once > 0.25L);
}
