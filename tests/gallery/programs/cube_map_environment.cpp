// Cube-map environment: the surroundings as six pictures, and a ball that reflects them. The
// reflected direction is the eye's, so that the texture matrix turns it back into the world.

#include "tests/gallery/harness/environment.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>

namespace ffgpu::gallery {
namespace {

// The box around the eye: a place on it is its own direction.
void draw_surroundings() {
    glDisable(GL_DEPTH_TEST);
    glPushMatrix();
    glTranslatef(2.2f, -3.2f, 1.2f);
    glBegin(GL_TRIANGLES);
    for (const Triangle& triangle : cube(10, 1)) {
        for (const MeshVertex& vertex : triangle) {
            glTexCoord3dv(glm::value_ptr(vertex.position));
            glVertex3dv(glm::value_ptr(vertex.position));
        }
    }
    glEnd();
    glPopMatrix();
    glEnable(GL_DEPTH_TEST);
}

// The view's turn, undone: its transpose.
void turn_reflections_to_world() {
    GLdouble view[16], turn[16] = {};
    glGetDoublev(GL_MODELVIEW_MATRIX, view);
    for (int i = 0; i < 9; ++i)
        turn[4 * (i / 3) + i % 3] = view[4 * (i % 3) + i / 3];
    turn[15] = 1;
    glMatrixMode(GL_TEXTURE);
    glLoadMatrixd(turn);
    glMatrixMode(GL_MODELVIEW);
}

} // namespace

void cube_map_environment(const Scene& scene) {
    clear(0, 0, 0);
    cube_map(environment_cube(128));
    glEnable(GL_TEXTURE_CUBE_MAP);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const Panel place = panel(scene, 0, 1, 1);
    enter(place);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(40, place.aspect(), 0.5, 40);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(2.2, -3.2, 1.2, 0, 0, 0, 0, 0, 1);
    draw_surroundings();

    if (!scene.broken) turn_reflections_to_world();
    for (const auto coordinate : std::array<GLenum, 3>{GL_S, GL_T, GL_R})
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    glEnable(GL_TEXTURE_GEN_R);
    draw_mesh(sphere(1, 128, 64));
}

} // namespace ffgpu::gallery
