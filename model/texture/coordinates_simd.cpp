// coordinates.h over a batch. Divergent by nature (a face a fragment), and rare: no vectors.

#include "model/texture/coordinates.h"
#include "model/texture/sampling_batch.h"

namespace ffgpu {
namespace {

void put(TexCoordPlanes& planes, unsigned lane, const TexCoord& coord) {
    planes.s[lane] = coord.s;
    planes.t[lane] = coord.t;
}

} // namespace

void project_batch(const TexCoordPlanes& directions,
                   const SampleQuads& quads,
                   ProjectedBatch& out) {
    for (unsigned first = 0; first < 4 * grouped_quads(quads.count); first += 4) {
        bool one_face = true;
        const unsigned lane_of_face = first + face_lane(quads.covered.quad(first / 4));
        const unsigned quad_face = cube_face(coordinates_of(directions, lane_of_face));
        for (unsigned lane = first; lane < first + 4; ++lane) {
            const TexCoord direction = coordinates_of(directions, lane);
            const unsigned face = cube_face(direction);
            out.face[lane] = static_cast<std::int32_t>(face);
            one_face &= face == quad_face;
            put(out.sample, lane, project_to_face(face, direction));
            put(out.level_of_detail, lane, project_to_face(quad_face, direction));
        }
        out.one_face[first / 4] = one_face;
    }
}

} // namespace ffgpu
