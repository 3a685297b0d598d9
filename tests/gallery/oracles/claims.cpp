#include "tests/gallery/oracles/claims.h"

namespace ffgpu::gallery {

const std::vector<Claim>& claims() {
    static const std::vector<Claim> all{
        texel_lookup_claim(),
        wrap_modes_claim(),
        barycentric_interpolation_claim(),
        perspective_correct_claim(),
        magnification_claim(),
        mip_pyramid_claim(),
        level_of_detail_claim(),
        mappings_claim(),
        texgen_claim(),
        projective_texture_claim(),
    };
    return all;
}

} // namespace ffgpu::gallery
