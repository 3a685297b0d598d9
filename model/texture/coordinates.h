// Texture coordinates: the face of a cube map, and where anisotropic probes stand.

#pragma once

#include "model/arith/reciprocal.h"
#include "model/packets/fragment_batch.h"

#include <array>
#include <bit>
#include <cstdint>

namespace ffgpu {

struct TexCoord {
    float s = 0, t = 0, r = 0;
};

inline TexCoord coordinates_of(const TexCoordPlanes& planes, unsigned lane) {
    return {planes.s[lane], planes.t[lane], planes.r[lane]};
}

constexpr unsigned MaxProbes = 16;

// Where anisotropic probe i of n, counted from 1, stands on the pixel's longer side: in the middle
// of the i-th of n equal parts. (The i / (n + 1) - 1/2 that EXT_texture_filter_anisotropic gives as
// an example leaves the ends of the side out, which shows as moire.)
constexpr auto ProbePositions = [] {
    std::array<std::array<float, MaxProbes + 1>, MaxProbes + 1> table{};
    for (unsigned n = 1; n <= MaxProbes; ++n)
        for (unsigned i = 1; i <= n; ++i)
            table[n][i] = (static_cast<float>(i) - 0.5f) / static_cast<float>(n) - 0.5f;
    return table;
}();

constexpr float probe_position(unsigned i, unsigned n) {
    return ProbePositions[n][i];
}

// In the middle the coordinate itself, whatever the step.
constexpr float move_to_probe(float coordinate, float step, float position) {
    return coordinate + step * position;
}

// Faces count +x -x +y -y +z -z. The major axis is the one of largest magnitude, of equal ones the
// first; a zero counts as positive.
constexpr unsigned cube_face(const TexCoord& direction) {
    const auto magnitude = [](float x) { return x < 0 ? -x : x; };
    const float x = magnitude(direction.s), y = magnitude(direction.t), z = magnitude(direction.r);
    if (x >= y && x >= z) return direction.s < 0 ? 1 : 0;
    if (y >= z) return direction.t < 0 ? 3 : 2;
    return direction.r < 0 ? 5 : 4;
}

// The least length of a major axis that is divided by: products stay finite.
constexpr float LeastMajorAxis = 0x1p-62f;

// GL 1.5, table 3.19: (s, t) on the given face. Equation 3.21 by one reciprocal:
// (sc * (1 / |ma|)) / 2 + 1/2. The centre stands for a direction that has none.
constexpr TexCoord project_to_face(unsigned face, const TexCoord& d) {
    const float sign = face % 2 == 0 ? 1.0f : -1.0f;
    const unsigned axis = face / 2;
    const float major = axis == 0 ? d.s : axis == 1 ? d.t : d.r;
    const float sc = axis == 0 ? -sign * d.r : axis == 1 ? d.s : sign * d.s;
    const float tc = axis == 1 ? sign * d.r : -d.t;
    const float magnitude = major < 0 ? -major : major;
    const float over_major = reciprocal(magnitude > LeastMajorAxis ? magnitude : LeastMajorAxis);
    return {(sc * over_major) * 0.5f + 0.5f, (tc * over_major) * 0.5f + 0.5f, d.r};
}

// The lane whose face a quad's derivatives are taken on: the first of those that the primitive
// covers, whether or not a test killed it since. A lane that is only a neighbour may look past the
// cube's edge, where the step to the next lane is another. Without any it is lane 0.
constexpr unsigned face_lane(unsigned covered) {
    return covered == 0 ? 0 : static_cast<unsigned>(std::countr_zero(covered));
}

} // namespace ffgpu
