// Cube maps: the face of a direction, the coordinates on it, and levels of detail across edges.

#include "model/texture/coordinates.h"
#include "model/texture/level_of_detail.h"
#include "tests/texture/texture_fixture.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

// GL 1.5, table 3.19, as printed: columns of (rx, ry, rz).
struct FaceRow {
    std::array<int, 3> major, sc, tc;
};
constexpr std::array<FaceRow, 6> Table{{
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
}};

double dot(const std::array<int, 3>& a, const TexCoord& b) {
    return a[0] * double{b.s} + a[1] * double{b.t} + a[2] * double{b.r};
}

TexCoord random_direction(Random& random) {
    const auto one = [&] {
        return static_cast<float>(static_cast<int>(below(random, 2001)) - 1000);
    };
    return {one(), one(), one()};
}

TEST_CASE("face and coordinates follow table 3.19") {
    Random random(8);
    for (unsigned i = 0; i < 5000; ++i) {
        const TexCoord direction = random_direction(random);
        const unsigned face = cube_face(direction);
        const double major = dot(Table[face].major, direction);
        for (const FaceRow& other : Table)
            REQUIRE(major >= dot(other.major, direction));
        if (major == 0) continue;
        const TexCoord on_face = project_to_face(face, direction);
        REQUIRE(std::abs(on_face.s - (dot(Table[face].sc, direction) / major + 1) / 2) < 1e-6);
        REQUIRE(std::abs(on_face.t - (dot(Table[face].tc, direction) / major + 1) / 2) < 1e-6);
    }
}

TEST_CASE("of axes as long, the first is the major one; no direction is the centre of face 0") {
    CHECK(cube_face({1, 1, 1}) == 0);
    CHECK(cube_face({-1, 1, 1}) == 1);
    CHECK(cube_face({0, -1, 1}) == 3);
    CHECK(cube_face({0, 0, 0}) == 0);
    CHECK(project_to_face(0, {0, 0, 0}).s == 0.5f);
}

TextureMemory numbered_faces(std::uint32_t size, std::uint32_t levels) {
    TextureShape shape{TextureKind::Cube, Format::Luminance8, size, size, 1, levels, 0};
    TextureMemory memory(shape);
    for (unsigned level = 0; level < levels; ++level)
        for (unsigned face = 0; face < 6; ++face) {
            const LevelLayout layout = level_layout(shape, level);
            const auto value = std::byte(face * 40 + level);
            std::fill_n(memory.at(level, face, 0, 0), layout.layer_stride, value);
        }
    return memory;
}

TEST_CASE("each direction reads its own face") {
    const TextureMemory memory = numbered_faces(8, 4);
    Sampler sampler = linear_sampler(Wrap::ClampToEdge);
    const TextureUnit unit = memory.compile(sampler);
    Random random(9);
    for (unsigned i = 0; i < 500; ++i) {
        const TexCoord d = random_direction(random);
        CHECK(sample_point(unit, {d.s, d.t, d.r})[0] == 40 * cube_face(d));
    }
}

// A screen of directions that looks at the edge between +x and +z: the level of detail of the quads
// that straddle it is that of their neighbours.
TEST_CASE("quads across a face's edge keep the level of detail of the quads beside it") {
    const TextureMemory memory = numbered_faces(256, 9);
    Sampler sampler = linear_sampler(Wrap::ClampToEdge);
    sampler.mip_filter = MipFilter::Nearest;
    const TextureUnit unit = memory.compile(sampler);
    const auto planes = make_planes(BatchQuads, [&](unsigned lane) {
        const auto x = static_cast<float>(lane / 4 * 2 + lane % 2) - 63.5f;
        const auto y = static_cast<float>(lane / 2 % 2);
        const float angle = 0.785398f + x * 0.03f;
        return Coordinates{std::cos(angle), y * 0.03f, std::sin(angle)};
    });
    ColorPlanes out;
    TexelFootprints footprints;
    sample(unit, *planes, all_quads(BatchQuads), out, &footprints);
    unsigned finest = 99, coarsest = 0;
    for (unsigned lane = 96; lane < 160; ++lane) { // Around the edge.
        finest = std::min<unsigned>(finest, footprints.accesses()[lane].level);
        coarsest = std::max<unsigned>(coarsest, footprints.accesses()[lane].level);
    }
    CHECK(coarsest - finest <= 1);
}

// A face drawn texel for pixel from an odd place on: of its first quad just lane 3 is inside of the
// primitive, and lane 0 looks past the corner at another face, where steps are longer.
TEST_CASE("lanes that are not covered do not choose the face of a quad's derivatives") {
    const TextureMemory memory = numbered_faces(64, 7);
    Sampler sampler = linear_sampler(Wrap::ClampToEdge);
    sampler.mip_filter = MipFilter::Nearest;
    const TextureUnit unit = memory.compile(sampler);
    const auto planes = make_planes(1, [&](unsigned lane) {
        const float x = static_cast<float>(lane % 2) - 0.5f; // Texels from the corner of face +z.
        const float y = static_cast<float>(lane / 2) - 0.5f;
        return Coordinates{1 - x / 32, 1 - y / 32, 1};
    });
    const auto level_with = [&](const FragmentMask& covered, const FragmentMask& live) {
        ColorPlanes out;
        TexelFootprints footprints;
        sample(unit, *planes, {1, covered, live}, out, &footprints);
        return unsigned{footprints.accesses().back().level};
    };
    FragmentMask last;
    last.set(3);
    CHECK(level_with(last, last) == 0);
    CHECK(level_with(all_live(1), all_live(1)) == 1);
    // What an early depth test killed still chooses, as it does where the test comes late.
    CHECK(level_with(all_live(1), last) == 1);
}

} // namespace
} // namespace ffgpu::test
