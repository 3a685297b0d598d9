// Texture coordinates: division by q, and the face of a cube map.

#pragma once

#include "model/packets/fragment_batch.h"

#include <array>
#include <bit>
#include <cstdint>

namespace ffgpu {

struct TexCoord {
    float s = 0, t = 0, r = 0; // never NaN
};

// One IEEE division; NaN becomes 0. A negative q divides as any other, as OpenGL has it (the
// picture behind a projector is mirrored); q = 0 gives infinities, which the wrap modes take.
constexpr float divide_by_q(float coordinate, float q) {
    const float quotient = coordinate / q;
    return quotient == quotient ? quotient : 0.0f;
}

inline TexCoord project(const TexCoordPlanes& planes, unsigned lane) {
    const float q = planes.q[lane];
    return {divide_by_q(planes.s[lane], q),
            divide_by_q(planes.t[lane], q),
            divide_by_q(planes.r[lane], q)};
}

// Where anisotropic probe i of n, counted from 1, stands on the pixel's longer side: in the middle
// of the i-th of n equal parts. (The i / (n + 1) - 1/2 that EXT_texture_filter_anisotropic gives as
// an example leaves the ends of the side out, which shows as moire.)
constexpr float probe_position(unsigned i, unsigned n) {
    return (static_cast<float>(i) - 0.5f) / static_cast<float>(n) - 0.5f;
}

// In the middle the coordinate itself, whatever the step; NaN (of infinite steps) becomes 0.
constexpr float move_to_probe(float coordinate, float step, float position) {
    const float moved = coordinate + step * position;
    const float defined = moved == moved ? moved : 0.0f;
    return position == 0 ? coordinate : defined;
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

// GL 1.5, table 3.19: (s, t) on the given face. Equation 3.21 with one rounding more or less:
// (sc / |ma|) / 2 + 1/2. The centre stands for a direction that has none.
constexpr TexCoord project_to_face(unsigned face, const TexCoord& d) {
    const float sign = face % 2 == 0 ? 1.0f : -1.0f;
    const unsigned axis = face / 2;
    const float major = axis == 0 ? d.s : axis == 1 ? d.t : d.r;
    const float sc = axis == 0 ? -sign * d.r : axis == 1 ? d.s : sign * d.s;
    const float tc = axis == 1 ? sign * d.r : -d.t;
    const float magnitude = major < 0 ? -major : major;
    return {
        divide_by_q(sc, magnitude) * 0.5f + 0.5f, divide_by_q(tc, magnitude) * 0.5f + 0.5f, d.r};
}

// The lane whose face a quad's derivatives are taken on: the first of the live ones. A lane that is
// only a neighbour may look past the cube's edge, where the step to the next lane is another.
// `live` has a bit for each lane; without any it is lane 0.
constexpr unsigned face_lane(unsigned live) {
    return live == 0 ? 0 : static_cast<unsigned>(std::countr_zero(live));
}

} // namespace ffgpu
