// Spherical environment map beside the cube map. Above, both with texels enough; below, with about
// the same small number (6 x 16^2 and 32^2): towards the rim of the ball the sphere map is
// stretched, because its own rim is one single direction, the one away from the eye.

#include "tests/gallery/harness/environment.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <array>

namespace ffgpu::gallery {
namespace {

void draw_ball(const Panel& place, GLenum target, GLint mode) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(32, place.aspect(), 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4.2f);
    for (const auto coordinate : std::array<GLenum, 3>{GL_S, GL_T, GL_R}) {
        const bool three = target == GL_TEXTURE_CUBE_MAP || coordinate != GL_R;
        if (three) glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
        const GLenum capability = GL_TEXTURE_GEN_S + (coordinate - GL_S);
        three ? glEnable(capability) : glDisable(capability);
    }
    glEnable(target);
    draw_mesh(sphere(1, 128, 64));
    glDisable(target);
}

} // namespace

void sphere_map_environment(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_DEPTH_TEST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const GLint direction = scene.broken ? GL_NORMAL_MAP : GL_REFLECTION_MAP;
    for (int row = 0; row < 2; ++row) {
        cube_map(environment_cube(row == 0 ? 128 : 16));
        draw_ball(panel(scene, 2 * row, 2, 2), GL_TEXTURE_CUBE_MAP, direction);
        texture_2d(environment_sphere_map(row == 0 ? 256 : 32));
        set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
        draw_ball(panel(scene, 2 * row + 1, 2, 2), GL_TEXTURE_2D, GL_SPHERE_MAP);
    }
}

} // namespace ffgpu::gallery
