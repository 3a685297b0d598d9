// Level of detail: how many texels does a pixel step over? L = max(|d(u,v)/dx|, |d(u,v)/dy|) in
// texels of level 0, D = log2 L. Each level has a colour of its own. Left, the nearest level;
// right, trilinear: the coarser of two levels has the weight D - floor(D).

#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <vector>

namespace ffgpu::gallery {
namespace {

const GLubyte LevelColors[][3] = {{230, 60, 50},
                                  {240, 200, 40},
                                  {60, 190, 70},
                                  {50, 200, 220},
                                  {60, 70, 220},
                                  {200, 60, 210},
                                  {240, 240, 240},
                                  {20, 20, 20}};

void load_coloured_levels() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int level = 0; level < 8; ++level) {
        const GLsizei size = 128 >> level;
        std::vector<GLubyte> texels;
        for (int i = 0; i < size * size; ++i)
            texels.insert(texels.end(), LevelColors[level], LevelColors[level] + 3);
        glTexImage2D(
            GL_TEXTURE_2D, level, GL_RGB8, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    }
}

} // namespace

void level_of_detail(const Scene& scene) {
    clear(0.45f, 0.6f, 0.8f);
    glEnable(GL_TEXTURE_2D);
    load_coloured_levels();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    if (scene.broken) glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0.5f);

    for (int i = 0; i < 2; ++i) {
        const Panel place = panel(scene, i, 2, 1);
        enter(place);
        set_filters(GL_TEXTURE_2D,
                    i == 0 ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR,
                    GL_NEAREST);
        glMatrixMode(GL_PROJECTION);
        gluPerspective(60, place.aspect(), 0.1, 100);
        glMatrixMode(GL_MODELVIEW);
        gluLookAt(0, 0, 1, 0.5, 4, 0, 0, 0, 1);
        glBegin(GL_QUADS); // a floor; the picture once a unit
        for (const auto& [x, y] :
             {std::pair{-20.f, 0.2f}, {20.f, 0.2f}, {20.f, 40.f}, {-20.f, 40.f}}) {
            glTexCoord2f(x, y);
            glVertex3f(x, y, 0);
        }
        glEnd();
    }
}

} // namespace ffgpu::gallery
