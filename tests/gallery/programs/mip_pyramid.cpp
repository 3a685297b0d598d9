// The mip pyramid: each level averages four texels of the finer one, so that all levels together
// need 4/3 of the first. Six levels of 64 x 64 texels, made by OpenGL (above) and by GLU (below);
// each is shown alone, as the only level that may be taken.

#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

constexpr int Levels = 6;

void show_levels(const Scene& scene, int row) {
    for (int level = 0; level < Levels; ++level) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
        enter_in_pixels(panel(scene, row * Levels + level, Levels, 2));
        draw_rectangle(2, 2, 50, 118);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
}

// What a pyramid without averages would hold: every fourth texel.
void put_in_samples(const Image& image) {
    Image samples(16, 16);
    for (int i = 0; i < 16 * 16; ++i) {
        const std::uint8_t* const texel = image.texel(i % 16 * 4, i / 16 * 4);
        samples.set(i % 16, i / 16, texel[0], texel[1], texel[2]);
    }
    glTexSubImage2D(GL_TEXTURE_2D, 2, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, samples.rgba.data());
}

} // namespace

void mip_pyramid(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const Image image = gravel(64, 3);

    GLuint names[2];
    glGenTextures(2, names);
    glBindTexture(GL_TEXTURE_2D, names[0]);
    set_filters(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(
        GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    if (scene.broken) put_in_samples(image);
    show_levels(scene, 0);

    glBindTexture(GL_TEXTURE_2D, names[1]);
    set_filters(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
    gluBuild2DMipmaps(
        GL_TEXTURE_2D, GL_RGBA8, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    show_levels(scene, 1);
    glDeleteTextures(2, names);
}

} // namespace ffgpu::gallery
