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
        anisotropic_filter_claim(),
        supersampling_claim(),
        mappings_claim(),
        texgen_claim(),
        projective_texture_claim(),
        cube_map_environment_claim(),
        sphere_map_environment_claim(),
        normal_mapping_claim(),
        bump_mapping_claim(),
        displacement_mapping_claim(),
        shadow_map_claim(),
        painters_cycle_claim(),
        transparency_claim(),
        noise_textures_claim(),
        grown_textures_claim(),
        solid_textures_claim(),
        baked_occlusion_claim(),
        lecture_snippets_claim(),
        gloss_map_claim(),
    };
    return all;
}

const Claim& claim_of(std::string_view row) {
    static const Claim strip = filter_strip_claim();
    for (const Claim& claim : claims()) {
        if (claim.row == row) return claim;
    }
    return strip;
}

} // namespace ffgpu::gallery
