// Controlling shading parameters: a texture that says how shiny a surface is, in two passes. First
// the diffuse light times the surface's colours; then the highlight alone, times the gloss map, is
// added where the depth is equal.

#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

const GLfloat Black[] = {0, 0, 0, 1}, White[] = {1, 1, 1, 1};

// A lamp infinitely far away, and an eye infinitely far away for the highlights, as is the default.
void set_light(const GLfloat* diffuse, const GLfloat* specular) {
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, Black);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
    glLightfv(GL_LIGHT0, GL_SPECULAR, specular);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, White);
    glMaterialfv(GL_FRONT, GL_SPECULAR, White);
    glMaterialf(GL_FRONT, GL_SHININESS, 12);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
}

} // namespace

void gloss_map(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    const Panel place = panel(scene, 0, 1, 1);
    enter(place);
    const GLfloat towards[] = {0.48f, 0.64f, 0.6f, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, towards); // in the eye's frame: the modelview matrix is 1
    set_light(White, Black);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(34, place.aspect(), 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4);
    glRotatef(-65, 1, 0, 0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);

    const Mesh ball = sphere(1, 128, 64);
    texture_2d(waves(128));
    draw_mesh(ball);

    texture_2d(scene.broken ? Image(2, 2) : slide(64)); // broken: equally shiny everywhere
    set_light(Black, White);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glMatrixMode(GL_TEXTURE);
    glScalef(6, 3, 1); // the gloss map's own grain
    draw_mesh(ball);
}

} // namespace ffgpu::gallery
