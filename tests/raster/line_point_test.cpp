#include "model/raster/pixel_areas.h"
#include "model/raster/stipple.h"
#include "tests/raster/raster_helpers.h"

#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

__extension__ using Wide = __int128;

// GL 1.5, 3.4.1, literally: "the fragments f for which the line segment intersects R_f, except if
// p_b is contained in R_f", R_f = |x - x_f| + |y - y_f| < 1/2, end points moved by (-e, -e^2).
// Coordinates in units of 2^-40 sub-pixels; e is 2^20 of them, e^2 is 1.
class DiamondExit {
public:
    static constexpr std::int64_t Unit = std::int64_t{1} << 40;

    DiamondExit(SubPixelPoint a, SubPixelPoint b)
        : ax_(a.x * Unit - (1 << 20))
        , ay_(a.y * Unit - 1)
        , bx_(b.x * Unit - (1 << 20))
        , by_(b.y * Unit - 1) {}

    bool produces(int x, int y) const {
        const std::int64_t cx = (x * 256 + 128) * Unit, cy = (y * 256 + 128) * Unit;
        return !inside(bx_ - cx, by_ - cy) && crosses(cx, cy);
    }

private:
    static constexpr std::int64_t Half = 128 * Unit;

    static bool inside(std::int64_t dx, std::int64_t dy) {
        return std::abs(dx) + std::abs(dy) < Half;
    }

    // Some t in [0, 1] with |u(t)| < Half and |v(t)| < Half, u and v running along the diagonals.
    bool crosses(std::int64_t cx, std::int64_t cy) const {
        const std::int64_t u0 = ax_ - cx + ay_ - cy, u1 = bx_ - cx + by_ - cy;
        const std::int64_t v0 = ax_ - cx - (ay_ - cy), v1 = bx_ - cx - (by_ - cy);
        if (inside(ax_ - cx, ay_ - cy) || inside(bx_ - cx, by_ - cy)) return true;
        Fraction low{0, 1}, high{1, 1};
        for (const auto& [from, to] : {std::pair{u0, u1}, std::pair{v0, v1}})
            for (const int sign : {1, -1}) {
                // sign * (from + t (to - from)) < Half
                const Wide slope = Wide{sign} * (to - from), rest = Wide{Half} - Wide{sign} * from;
                if (slope == 0) {
                    if (rest <= 0) return false;
                } else if (slope > 0) {
                    high = least(high, {rest, slope});
                } else {
                    low = most(low, {-rest, -slope});
                }
            }
        return less(low, high);
    }

    struct Fraction {
        Wide numerator, denominator; // > 0
    };
    static bool less(const Fraction& a, const Fraction& b) {
        return a.numerator * b.denominator < b.numerator * a.denominator;
    }
    static Fraction least(const Fraction& a, const Fraction& b) { return less(a, b) ? a : b; }
    static Fraction most(const Fraction& a, const Fraction& b) { return less(a, b) ? b : a; }

    std::int64_t ax_, ay_, bx_, by_;
};

std::multiset<Pixel> line_pixels(const SetupContext& setup, SubPixelPoint a, SubPixelPoint b) {
    RecordBuffer buffer;
    const WindowVertex va = vertex(a.x, a.y), vb = vertex(b.x, b.y);
    if (!buffer.set_up(setup, {.shape = PrimitiveShape::Line, .vertices = {&va, &vb}})) return {};
    return covered_pixels(buffer.record());
}

std::multiset<Pixel> point_pixels(const SetupContext& setup, int x, int y, float size) {
    RecordBuffer buffer;
    WindowVertex v = vertex(x, y);
    v.point_size = size;
    if (!buffer.set_up(setup, {.shape = PrimitiveShape::Point, .vertices = {&v}})) return {};
    return covered_pixels(buffer.record());
}

} // namespace

TEST_CASE("lines of width 1 follow the diamond-exit rule") {
    Random random(21);
    for (int i = 0; i < 3000; ++i) {
        const auto coordinate = [&] {
            const int at = random.between(0, 14 * 256);
            // Ties of all kinds: centres, corners, the diamonds' tips and edges.
            return i % 3 == 0 ? at & ~127 : i % 3 == 1 ? at & ~31 : at;
        };
        const SubPixelPoint a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
        if (a == b) continue;
        const DiamondExit rule(a, b);
        std::multiset<Pixel> expected;
        for (int y = -1; y < 16; ++y)
            for (int x = -1; x < 16; ++x)
                if (x >= 0 && y >= 0 && rule.produces(x, y)) expected.emplace(x, y);
        INFO(a.x << ' ' << a.y << " to " << b.x << ' ' << b.y);
        REQUIRE(line_pixels(context(), a, b) == expected);
    }
}

TEST_CASE("a strip of lines draws no joint twice") {
    const SetupContext setup = context();
    const SubPixelPoint corner[] = {
        {700, 700}, {3000, 1100}, {4000, 3900}, {900, 3000}, {700, 700}};
    std::multiset<Pixel> all;
    for (int i = 0; i < 4; ++i)
        all.merge(line_pixels(setup, corner[i], corner[i + 1]));
    CHECK(std::set<Pixel>(all.begin(), all.end()).size() == all.size());
}

TEST_CASE("a wide line is columns of whole fragments") {
    SetupContext setup = context();
    for (const int width : {2, 3, 6}) {
        setup.primitive.line_width = static_cast<float>(width) + 0.3f;
        const SubPixelPoint a{2 * 256 + 40, 20 * 256 + 99}, b{30 * 256 + 7, 31 * 256};
        const int shift = (width - 1) * 128;
        std::multiset<Pixel> expected;
        for (const auto& [x, y] : line_pixels(context(), {a.x, a.y - shift}, {b.x, b.y - shift}))
            for (int row = 0; row < width; ++row)
                expected.emplace(x, y + row);
        CHECK(line_pixels(setup, a, b) == expected);
        // Steep lines: rows.
        std::multiset<Pixel> turned;
        for (const auto& [x, y] : line_pixels(context(), {a.y - shift, a.x}, {b.y - shift, b.x}))
            for (int column = 0; column < width; ++column)
                turned.emplace(x + column, y);
        CHECK(line_pixels(setup, {a.y, a.x}, {b.y, b.x}) == turned);
    }
}

TEST_CASE("points are squares: odd sizes around a pixel, even ones around a corner") {
    const SetupContext setup = context();
    const auto square = [](int x0, int y0, int size) {
        std::multiset<Pixel> pixels;
        for (int y = y0; y < y0 + size; ++y)
            for (int x = x0; x < x0 + size; ++x)
                pixels.emplace(x, y);
        return pixels;
    };
    CHECK(point_pixels(setup, 10 * 256 + 255, 10 * 256, 1) == square(10, 10, 1));
    CHECK(point_pixels(setup, 10 * 256 + 255, 10 * 256, 3.4f) == square(9, 9, 3));
    CHECK(point_pixels(setup, 10 * 256 + 127, 10 * 256 + 128, 2) == square(9, 10, 2));
    CHECK(point_pixels(setup, 10 * 256 + 127, 10 * 256 + 128, 4) == square(8, 9, 4));
    CHECK(point_pixels(setup, 10 * 256, 10 * 256, 0.2f) == square(10, 10, 1));
}

TEST_CASE("a sprite covers the centres in its square and runs from 0 to 1 across it") {
    SetupContext setup = context();
    setup.primitive.point_sprite = true;
    setup.primitive.point_sprite_replace = 1;
    setup.layout.tex_coord[0] = 0;
    setup.layout.tex_components[0] = 4;
    setup.layout.count = 4;
    RecordBuffer buffer;
    WindowVertex v = vertex(20 * 256, 30 * 256);
    v.point_size = 8;
    REQUIRE(buffer.set_up(setup, {.shape = PrimitiveShape::Point, .vertices = {&v}}));
    const SetupRecord& record = buffer.record();
    CHECK(record.box == Rectangle{16, 26, 24, 34});
    const auto at = [&](unsigned plane, int x, int y) {
        const AttributePlane at_plane = record.plane(plane);
        return static_cast<float>(at_plane.corner(x - record.x_reference, y - record.y_reference)) *
               at_plane.scale;
    };
    CHECK(at(0, 16, 30) == 1 / 16.0f);
    CHECK(at(0, 23, 30) == 15 / 16.0f);
    CHECK(at(1, 16, 26) == 15 / 16.0f); // t falls upwards: the origin is the upper left.
    CHECK(at(1, 16, 33) == 1 / 16.0f);
    CHECK(at(2, 16, 33) == 0);
    CHECK(at(3, 16, 33) == 1);
}

TEST_CASE("a line's stipple counts fragments from its first vertex") {
    SetupContext setup = context();
    setup.primitive.line_stipple = true;
    StipplePatterns patterns{};
    patterns.line = 0x0f35;
    patterns.line_factor = 3;
    for (const bool backwards : {false, true}) {
        const SubPixelPoint ends[2] = {{3 * 256 + 128, 640}, {60 * 256 + 128, 900}};
        const WindowVertex a = vertex(ends[backwards].x, ends[backwards].y);
        const WindowVertex b = vertex(ends[!backwards].x, ends[!backwards].y);
        RecordBuffer buffer;
        REQUIRE(buffer.set_up(
            setup, {.shape = PrimitiveShape::Line, .stipple_counter = 7, .vertices = {&a, &b}}));
        const int first = backwards ? 60 : 3;
        for (int x = 3; x <= 60; ++x) {
            const unsigned s = 7u + static_cast<unsigned>(std::abs(x - first));
            const bool expected = patterns.line >> (s / 3 % 16) & 1;
            const BlockMask mask = stipple_mask(buffer.record(), patterns, x & ~7, 0);
            REQUIRE((mask >> block_bit(x & 7, 2) & 1) == expected);
        }
    }
}

TEST_CASE("the polygon stipple reads its rows from the most significant bit") {
    SetupContext setup = context();
    setup.primitive.polygon_stipple = true;
    StipplePatterns patterns{};
    patterns.polygon[3] = 0x80000001;
    RecordBuffer buffer;
    REQUIRE(buffer.triangle(setup, vertex(0, 0), vertex(60000, 0), vertex(0, 60000)));
    const BlockMask left = stipple_mask(buffer.record(), patterns, 32, 32);
    CHECK(left == BlockMask{1} << block_bit(0, 3));
    const BlockMask right = stipple_mask(buffer.record(), patterns, 56, 0);
    CHECK(right == BlockMask{1} << block_bit(7, 3));
}

TEST_CASE("the areas of a smooth polygon's pixels add up to its area") {
    Random random(22);
    for (int i = 0; i < 100; ++i) {
        const SubPixelPoint p[3] = {{random.below(8000), random.below(8000)},
                                    {random.below(8000), random.below(8000)},
                                    {random.below(8000), random.below(8000)}};
        const std::int64_t twice = double_area(p[0], p[1], p[2]);
        if (twice <= 0) continue;
        const AreaPolygon polygon = make_area_polygon(p);
        double sum = 0;
        RowAreas areas;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; x += static_cast<int>(AreaRow)) {
                row_areas(polygon, x, y, areas);
                sum = std::accumulate(areas.begin(), areas.end(), sum);
            }
        REQUIRE(sum == Approx(static_cast<double>(twice) / 131072).margin(1e-9));
    }
}

TEST_CASE("areas are the same pixel by pixel and row by row") {
    Random random(23);
    for (int i = 0; i < 2000; ++i) {
        const int size = i % 2 == 0 ? 2048 : 1 << 20;
        std::vector<SubPixelPoint> corners(3 + static_cast<std::size_t>(i % 2));
        for (SubPixelPoint& corner : corners)
            corner = {random.below(size) - size / 2, random.below(size) - size / 2};
        if (i % 5 == 0) corners[1].y = corners[0].y; // a level edge
        const AreaPolygon polygon = make_area_polygon(corners);
        RowAreas areas, expected;
        const int x = random.below(16) - 8;
        row_areas(polygon, x, i % 8 - 4, areas);
        row_areas_scalar(polygon, x, i % 8 - 4, expected);
        REQUIRE(areas == expected);
    }
}

TEST_CASE("smooth blocks are the same with each pixel reckoned and by rows that edges cross") {
    Random random(31);
    SetupContext setup = context();
    setup.primitive.polygon_smooth = setup.primitive.point_smooth = true;
    RecordBuffer buffer;
    unsigned partial = 0;
    for (int i = 0; i < 1500; ++i) {
        const int size = i % 3 == 0 ? 1 << 21 : i % 3 == 1 ? 1 << 14 : 1 << 16;
        std::array<WindowVertex, 3> v;
        for (WindowVertex& corner : v)
            corner = vertex(16384 + random.below(size) - size / 2,
                            16384 + random.below(size) - size / 2);
        v[0].point_size = static_cast<float>(1 + random.below(60));
        const bool point = i % 7 == 0;
        if (!buffer.set_up(setup,
                           {.shape = point ? PrimitiveShape::Point : PrimitiveShape::Triangle,
                            .vertices = {&v[0], &v[1], &v[2]}}))
            continue;
        for (int y = 0; y < 256; y += BlockSize)
            for (int x = 0; x < 256; x += BlockSize) {
                BlockAntialias one{}, other{};
                const BlockMask mask = smooth_block(buffer.record(), x, y, one);
                REQUIRE(mask == smooth_block_scalar(buffer.record(), x, y, other));
                for (unsigned bit = 0; bit < one.size(); ++bit)
                    if (mask >> bit & 1) REQUIRE(one[bit] == other[bit]);
                partial += mask != 0 && mask != FullBlock;
            }
    }
    CHECK(partial > 1000);
}

TEST_CASE("a pixel's area is what the polygon covers of it") {
    const auto area = [](std::vector<SubPixelPoint> corners, unsigned x, int y) {
        RowAreas areas;
        row_areas(make_area_polygon(corners), 0, y, areas);
        return areas[x];
    };
    const std::vector<SubPixelPoint> triangle{{256, 256}, {512, 256}, {256, 512}};
    CHECK(area(triangle, 1, 1) == 0.5);
    CHECK(area(triangle, 0, 1) == 0);
    CHECK(area(triangle, 2, 1) == 0);
    CHECK(area(triangle, 1, 0) == 0);
    const std::vector<SubPixelPoint> square{{128, 128}, {640, 128}, {640, 640}, {128, 640}};
    CHECK(area(square, 0, 0) == 0.25);
    CHECK(area(square, 1, 0) == 0.5);
    CHECK(area(square, 1, 1) == 1);
    CHECK(area(square, 2, 1) == 0.5);
    CHECK(area(square, 3, 1) == 0);
}

TEST_CASE("neighbours along a smooth edge share each pixel without gap") {
    SetupContext setup = context();
    setup.primitive.polygon_smooth = true;
    RecordBuffer one, other;
    const WindowVertex a = vertex(300, 500), b = vertex(15000, 900), c = vertex(14000, 15200),
                       d = vertex(700, 14000);
    REQUIRE(one.triangle(setup, a, b, c));
    REQUIRE(other.triangle(setup, a, c, d));
    BlockAntialias first, second;
    for (int y = 8; y < 48; y += 8)
        for (int x = 8; x < 48; x += 8) {
            first.fill(0);
            second.fill(0);
            smooth_block(one.record(), x, y, first);
            smooth_block(other.record(), x, y, second);
            for (unsigned i = 0; i < 64; ++i) {
                REQUIRE(first[i] + second[i] >= 254);
                REQUIRE(first[i] + second[i] <= 256);
            }
        }
}

TEST_CASE("a smooth line carries its width in coverage") {
    SetupContext setup = context();
    setup.primitive.line_smooth = true;
    setup.primitive.line_width = 2.5f;
    const WindowVertex a = vertex(10 * 256, 20 * 256), b = vertex(50 * 256, 20 * 256);
    RecordBuffer buffer;
    REQUIRE(buffer.set_up(setup, {.shape = PrimitiveShape::Line, .vertices = {&a, &b}}));
    BlockAntialias coverage;
    coverage.fill(0);
    smooth_block(buffer.record(), 24, 16, coverage);
    int column = 0;
    for (int y = 0; y < 8; ++y)
        column += coverage[block_bit(3, y)];
    CHECK(column == Approx(2.5 * 255).margin(1));
}

TEST_CASE("a smooth point is a disc") {
    SetupContext setup = context();
    setup.primitive.point_smooth = true;
    WindowVertex v = vertex(20 * 256, 20 * 256);
    v.point_size = 10;
    RecordBuffer buffer;
    REQUIRE(buffer.set_up(setup, {.shape = PrimitiveShape::Point, .vertices = {&v}}));
    double sum = 0;
    BlockAntialias coverage;
    for (int y = 8; y < 32; y += 8)
        for (int x = 8; x < 32; x += 8) {
            coverage.fill(0);
            smooth_block(buffer.record(), x, y, coverage);
            for (const std::uint8_t each : coverage)
                sum += each / 255.0;
        }
    CHECK(sum == Approx(3.14159 * 25).epsilon(0.02));
}
