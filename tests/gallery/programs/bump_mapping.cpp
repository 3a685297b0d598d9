// Bump mapping from a height field. Left: its slopes become a normal map, n = (-dp/du, -dp/dv, 1)
// normalised, and the combiner's dot product lights it. Right: emboss, as hardware without a dot
// product did it: the heights, less the heights a step towards the light, around grey.

#include "techniques/relief.h"
#include "tests/gallery/harness/heights.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

constexpr double Scale = 20;

void draw_lit(const techniques::Field& heights, double scale) {
    texture_2d(techniques::normal_map(heights, scale));
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_PRIMARY_COLOR);
    glColor3f(0.5f - 0.5f * 0.6f, 0.5f, 0.5f + 0.5f * 0.8f); // the light (-0.6, 0, 0.8)
    draw_rectangle(5, 5, 155, 235);
}

void draw_embossed(const techniques::Field& heights) {
    const techniques::Texels texels = techniques::to_texels(heights);
    texture_2d(texels);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    glActiveTexture(GL_TEXTURE1);
    texture_2d(texels);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_TEXTURE);
    glTranslatef(-0.04f, 0, 0); // a step towards the light
    glMatrixMode(GL_MODELVIEW);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD_SIGNED);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_ONE_MINUS_SRC_COLOR);
    glBegin(GL_QUADS);
    for (const auto& [u, v] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {1.f, 1.f}, {0.f, 1.f}}) {
        glMultiTexCoord2f(GL_TEXTURE0, u, v);
        glMultiTexCoord2f(GL_TEXTURE1, u, v);
        glVertex2f(5 + 150 * u, 5 + 230 * v);
    }
    glEnd();
}

} // namespace

void bump_mapping(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    const techniques::Field heights = hills(128);
    enter_in_pixels(panel(scene, 0, 2, 1));
    draw_lit(heights, scene.broken ? -Scale : Scale); // Hills become hollows.
    enter_in_pixels(panel(scene, 1, 2, 1));
    draw_embossed(heights);
}

} // namespace ffgpu::gallery
