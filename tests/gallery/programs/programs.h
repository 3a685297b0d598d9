// The programs of the gallery, one a technique, in the order of the textbook.

#pragma once

#include "tests/gallery/harness/scene.h"

#include <string_view>
#include <vector>

namespace ffgpu::gallery {

struct Program {
    std::string_view row;   // T1 ...
    std::string_view name;  // of the function, and of the file programs/<name>.cpp
    std::string_view title; // what a reader calls it
    void (*draw)(const Scene&);
    unsigned supersampling = 1; // that is forced on its window where it is drawn on ffgpu
};

const std::vector<Program>& programs();
// The same floor with one filter after the other; they do nothing wrong when told to.
const std::vector<Program>& filter_strip();
// Of either list; null: there is none of the name.
const Program* find_program(std::string_view name);

void texel_lookup(const Scene& scene);
void wrap_modes(const Scene& scene);
void barycentric_interpolation(const Scene& scene);
void perspective_correct(const Scene& scene);
void magnification(const Scene& scene);
void mip_pyramid(const Scene& scene);
void level_of_detail(const Scene& scene);
void anisotropic_filter(const Scene& scene);
void supersampling(const Scene& scene);
void mappings(const Scene& scene);
void texgen(const Scene& scene);
void projective_texture(const Scene& scene);
void cube_map_environment(const Scene& scene);
void sphere_map_environment(const Scene& scene);
void normal_mapping(const Scene& scene);
void bump_mapping(const Scene& scene);
void displacement_mapping(const Scene& scene);
void shadow_map(const Scene& scene);
void painters_cycle(const Scene& scene);
void transparency(const Scene& scene);
void noise_textures(const Scene& scene);
void grown_textures(const Scene& scene);
void solid_textures(const Scene& scene);
void baked_occlusion(const Scene& scene);
void lecture_snippets(const Scene& scene);
void gloss_map(const Scene& scene);

} // namespace ffgpu::gallery
