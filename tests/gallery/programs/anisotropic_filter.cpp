// Anisotropic filtering: at a grazing angle a pixel's footprint on the floor is long and narrow.
// From the top: trilinear, whose one square has to be as wide as the footprint is long; then probes
// along the long axis, up to 4 and up to 16.

#include "tests/gallery/harness/floor.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

void anisotropic_filter(const Scene& scene) {
    clear(0.45f, 0.6f, 0.8f);
    glEnable(GL_TEXTURE_2D);
    const Image image = gravel(256, 5);
    texture_2d(image);
    set_filters(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    gluBuild2DMipmaps(
        GL_TEXTURE_2D, GL_RGBA8, 256, 256, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const GLfloat probes[] = {1, 4, 16};
    for (int i = 0; i < 3; ++i) {
        const GLfloat most = scene.broken ? 1 : probes[i];
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, most);
        draw_grazing_floor(panel(scene, i, 1, 3));
    }
}

} // namespace ffgpu::gallery
