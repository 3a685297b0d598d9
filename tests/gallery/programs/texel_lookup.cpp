// Texel look-up: a coordinate u in [0, 1] names texel round(u w - 1/2) of w; texel centres lie at
// half integers, so that texel 0 sits at u = 1 / (2 w).

#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void texel_lookup(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    enter_in_pixels(panel(scene, 0, 1, 1));
    glEnable(GL_TEXTURE_2D);
    texture_2d(random_colours(8, 1), GL_NEAREST);
    set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const float shift = scene.broken ? 0.5f / 8 : 0.0f; // The half texel that beginners forget.
    glBegin(GL_QUADS);
    glTexCoord2f(0 + shift, 0 + shift);
    glVertex2f(30, 20);
    glTexCoord2f(1 + shift, 0 + shift);
    glVertex2f(300, 40);
    glTexCoord2f(1 + shift, 1 + shift);
    glVertex2f(280, 230);
    glTexCoord2f(0 + shift, 1 + shift);
    glVertex2f(10, 210);
    glEnd();
}

} // namespace ffgpu::gallery
