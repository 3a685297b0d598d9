// One floor at a grazing angle, once for each filter of the texture unit, and bilinear with several
// samples a pixel, which ffgpu's configuration forces on the program: what quality costs.

#include "driver/ffgpu_texture_filter.h"
#include "tests/gallery/harness/floor.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <array>

namespace ffgpu::gallery {
namespace {

struct Filter {
    GLint minifying;
    GLfloat probes; // at most, along the long axis of the footprint
    GLint wide = GL_STANDARD_FILTER_FFGPU;
};
constexpr std::array Filters{
    Filter{GL_NEAREST, 1},
    Filter{GL_LINEAR, 1},
    Filter{GL_LINEAR_MIPMAP_NEAREST, 1},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 1},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 2},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 4},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 8},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 16},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 1, GL_RIP_MAP_FILTER_FFGPU},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 1, GL_SUMMED_AREA_FILTER_FFGPU},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 1, GL_ELLIPTIC_FILTER_FFGPU},
    Filter{GL_LINEAR_MIPMAP_LINEAR, 1, GL_FELINE_FILTER_FFGPU},
};
constexpr std::size_t Bilinear = 1;

template <std::size_t Index>
void draw_floor_with(const Scene& scene) {
    constexpr Filter Chosen = Filters[Index];
    const Image image = gravel(256, 5);
    glEnable(GL_TEXTURE_2D);
    texture_2d(image);
    gluBuild2DMipmaps(
        GL_TEXTURE_2D, GL_RGBA8, 256, 256, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    set_filters(
        GL_TEXTURE_2D, Chosen.minifying, Chosen.minifying == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
    if (Chosen.probes > 1)
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, Chosen.probes);
    if (Chosen.wide != GL_STANDARD_FILTER_FFGPU) set_wide_filter(Chosen.wide);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    clear(0.45f, 0.6f, 0.8f);
    draw_grazing_floor(panel(scene, 0, 1, 1), 0, 0);
}

} // namespace

const std::vector<Program>& filter_strip() {
    static const std::vector<Program> all{
        {"F1", "filter_nearest", "nearest texel", draw_floor_with<0>},
        {"F2", "filter_bilinear", "bilinear", draw_floor_with<1>},
        {"F3", "filter_nearest_level", "bilinear, nearest level", draw_floor_with<2>},
        {"F4", "filter_trilinear", "trilinear", draw_floor_with<3>},
        {"F5", "filter_anisotropic_2", "anisotropic, 2 probes", draw_floor_with<4>},
        {"F6", "filter_anisotropic_4", "anisotropic, 4 probes", draw_floor_with<5>},
        {"F7", "filter_anisotropic_8", "anisotropic, 8 probes", draw_floor_with<6>},
        {"F8", "filter_anisotropic_16", "anisotropic, 16 probes", draw_floor_with<7>},
        {"F9", "filter_rip_map", "rip-map", draw_floor_with<8>},
        {"F10", "filter_summed_area", "summed-area table", draw_floor_with<9>},
        {"F11", "filter_elliptic", "elliptic weighted average", draw_floor_with<10>},
        {"F12", "filter_feline", "Feline, up to 16 probes", draw_floor_with<11>},
        {"F13", "supersampled_4", "4 samples, bilinear", draw_floor_with<Bilinear>, 4},
        {"F14", "supersampled_8", "8 samples, bilinear", draw_floor_with<Bilinear>, 8},
        {"F15", "supersampled_16", "16 samples, bilinear", draw_floor_with<Bilinear>, 16},
    };
    return all;
}

} // namespace ffgpu::gallery
