// What each row of the textbook claims: its formula, its tolerance, its oracle.

#pragma once

#include "tests/gallery/oracles/oracle.h"

namespace ffgpu::gallery {

Claim texel_lookup_claim();
Claim wrap_modes_claim();
Claim barycentric_interpolation_claim();
Claim perspective_correct_claim();
Claim magnification_claim();
Claim mip_pyramid_claim();
Claim level_of_detail_claim();
Claim anisotropic_filter_claim();
Claim supersampling_claim();
Claim mappings_claim();
Claim texgen_claim();
Claim projective_texture_claim();
Claim cube_map_environment_claim();
Claim sphere_map_environment_claim();
Claim normal_mapping_claim();
Claim bump_mapping_claim();
Claim displacement_mapping_claim();
Claim shadow_map_claim();
Claim painters_cycle_claim();
Claim transparency_claim();
Claim noise_textures_claim();
Claim grown_textures_claim();
Claim solid_textures_claim();
Claim baked_occlusion_claim();
Claim lecture_snippets_claim();
Claim gloss_map_claim();
Claim filter_strip_claim();

} // namespace ffgpu::gallery
