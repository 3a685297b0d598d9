// Supersampling: 16 pictures, each shifted by a part of a pixel, are summed in the accumulation
// buffer. It averages whatever is drawn, and costs 16 times as much: the reference that filters are
// compared with.

#include "tests/gallery/harness/floor.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void supersampling(const Scene& scene) {
    glEnable(GL_TEXTURE_2D);
    texture_2d(checker(64, 4), GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    constexpr int Side = 4;
    for (int i = 0; i < Side * Side; ++i) {
        const double x = scene.broken ? 0 : (i % Side + 0.5) / Side - 0.5;
        const double y = scene.broken ? 0 : (static_cast<int>(i / Side) + 0.5) / Side - 0.5;
        clear(0.45f, 0.6f, 0.8f);
        draw_grazing_floor(panel(scene, 0, 1, 1), x, y);
        glAccum(i == 0 ? GL_LOAD : GL_ACCUM, 1.0f / (Side * Side));
    }
    glAccum(GL_RETURN, 1);
}

} // namespace ffgpu::gallery
