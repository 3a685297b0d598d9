#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

const std::vector<Program>& programs() {
    static const std::vector<Program> all{
        {"T1", "texel_lookup", "Texel look-up", texel_lookup},
        {"T2", "wrap_modes", "Wrap modes and texture transformations", wrap_modes},
        {"T3", "barycentric_interpolation", "Barycentric interpolation", barycentric_interpolation},
        {"T4", "perspective_correct", "Perspective-correct interpolation", perspective_correct},
        {"T5", "magnification", "Magnification filters", magnification},
        {"T6", "mip_pyramid", "The mip pyramid", mip_pyramid},
        {"T7", "level_of_detail", "Level of detail", level_of_detail},
        {"T10", "mappings", "Texture coordinates from geometry", mappings},
        {"T11", "texgen", "Generated coordinates: glTexGen", texgen},
        {"T12", "projective_texture", "Projective texturing", projective_texture},
    };
    return all;
}

} // namespace ffgpu::gallery
