// Magnification filters: 8 x 8 texels on a large rectangle. Left, the nearest texel; in the middle
// bilinear: two lerps along s, the second from u01 to u11, and one along t; right, bicubic: a cubic
// through the four texels of each axis.

#include "driver/ffgpu_texture_filter.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void magnification(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_TEXTURE_2D);
    texture_2d(random_colours(8, 7));
    set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    for (int i = 0; i < 3; ++i) {
        enter_in_pixels(panel(scene, i, 3, 1));
        const GLint filter = i == 0 || scene.broken ? GL_NEAREST : GL_LINEAR;
        set_filters(GL_TEXTURE_2D, filter, filter);
        if (i == 2) set_wide_filter(GL_BICUBIC_FILTER_FFGPU);
        glTranslatef(65, 40, 0);
        glRotatef(20, 0, 0, 1);
        draw_rectangle(-40, 0, 40, 160);
    }
}

} // namespace ffgpu::gallery
