// Precomputed shading: the floor of a courtyard with high walls. How much of the sky each texel
// sees is computed once, kept in a texture (left), and multiplied by the floor's picture in a
// second texture unit (right).

#include "techniques/ambient_occlusion.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

constexpr int Size = 64, Wall = 4;
constexpr double Height = 26; // in texels

techniques::Texels courtyard() {
    techniques::Field heights(Size, Size, Height);
    for (int y = Wall; y < Size - Wall; ++y) {
        for (int x = Wall; x < Size - Wall; ++x)
            heights.at(x, y) = 0;
    }
    return techniques::to_texels(techniques::ambient_occlusion(heights, {180, 100}));
}

// The floor from the centre of its first texel to that of its last.
void draw_floor() {
    constexpr float Low = (Wall + 0.5f) / Size, High = 1 - Low;
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {1.f, 1.f}, {0.f, 1.f}}) {
        glMultiTexCoord2f(GL_TEXTURE0, 2 * x, 2 * y);
        glMultiTexCoord2f(GL_TEXTURE1, Low + (High - Low) * x, Low + (High - Low) * y);
        glVertex2f(8 + 144 * x, 20 + 200 * y);
    }
    glEnd();
}

} // namespace

void baked_occlusion(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glActiveTexture(GL_TEXTURE1);
    texture_2d(courtyard());
    set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
    texture_2d(gravel(64, 9));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    enter_in_pixels(panel(scene, 0, 2, 1));
    draw_floor();
    if (scene.broken) {
        glActiveTexture(GL_TEXTURE1);
        glDisable(GL_TEXTURE_2D);
        glActiveTexture(GL_TEXTURE0);
    }
    glEnable(GL_TEXTURE_2D);
    enter_in_pixels(panel(scene, 1, 2, 1));
    draw_floor();
}

} // namespace ffgpu::gallery
