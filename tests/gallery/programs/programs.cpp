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
        {"T8", "anisotropic_filter", "Anisotropic filtering", anisotropic_filter},
        {"T9", "supersampling", "Supersampling", supersampling},
        {"T10", "mappings", "Texture coordinates from geometry", mappings},
        {"T11", "texgen", "Generated coordinates: glTexGen", texgen},
        {"T12", "projective_texture", "Projective texturing", projective_texture},
        {"T13", "cube_map_environment", "Cube-map environment", cube_map_environment},
        {"T14", "sphere_map_environment", "Spherical environment map", sphere_map_environment},
        {"T15", "normal_mapping", "Normal mapping", normal_mapping},
        {"T16", "bump_mapping", "Bump mapping from heights", bump_mapping},
        {"T17", "displacement_mapping", "Displacement mapping", displacement_mapping},
        {"T18", "shadow_map", "Shadow map", shadow_map},
        {"T19", "painters_cycle", "The z-buffer and the painter's cycle", painters_cycle},
        {"T20", "transparency", "Transparency", transparency},
        {"T21", "noise_textures", "Texture synthesis: noise", noise_textures},
        {"T22", "grown_textures", "Texture synthesis: grown and quilted", grown_textures},
        {"T23", "solid_textures", "3-D textures and volumes", solid_textures},
        {"T24", "baked_occlusion", "Precomputed shading", baked_occlusion},
        {"T25", "lecture_snippets", "The OpenGL snippets", lecture_snippets},
        {"T26", "gloss_map", "Controlling shading: a gloss map", gloss_map},
    };
    return all;
}

const Program* find_program(std::string_view name) {
    for (const auto* const list : {&programs(), &filter_strip()}) {
        for (const Program& program : *list) {
            if (program.name == name) return &program;
        }
    }
    return nullptr;
}

} // namespace ffgpu::gallery
