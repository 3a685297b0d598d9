#include "model/texture/texture_unit.h"

namespace ffgpu {

void sample(const TextureUnit& unit,
            const TexCoordPlanes& coordinates,
            unsigned quad_count,
            const FragmentMask& live,
            ColorPlanes& out,
            TexelFootprints* footprints) {
    sample_reference(unit, coordinates, quad_count, live, out, footprints);
}

} // namespace ffgpu
