// Generated coordinates. Top: object linear, as the lecture's snippet; eye linear, the planes given
// under a unit modelview matrix; sphere map. Bottom: reflection map and normal map on a cube map;
// object linear with s, t and r on a 3-D texture.

#include "tests/gallery/harness/environment.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

const GLfloat PlaneS[] = {1.0f, 0.0f, 0.0f, 0.0f};
const GLfloat PlaneT[] = {0.0f, 1.0f, 0.0f, 0.0f};
const GLfloat PlaneR[] = {0.0f, 0.0f, 1.0f, 0.0f};

void set_mode(GLint mode) {
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, mode);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, mode);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    if (mode == GL_SPHERE_MAP) return; // which has no r
    glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, mode);
    glEnable(GL_TEXTURE_GEN_R);
}

void set_planes(GLenum which) {
    glTexGenfv(GL_S, which, PlaneS);
    glTexGenfv(GL_T, which, PlaneT);
    glTexGenfv(GL_R, which, PlaneR);
}

// A ball that stands turned before the eye.
void draw_ball(const Panel& place, GLenum target) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(32, place.aspect(), 1, 20);
    glMatrixMode(GL_MODELVIEW);
    set_planes(GL_EYE_PLANE); // in the coordinates of the eye: the modelview matrix is 1 as yet
    set_planes(GL_OBJECT_PLANE);
    glTranslatef(0, 0, -4.2f);
    glRotatef(40, 0, 0, 1);
    glRotatef(25, 1, 0, 0);
    glEnable(target);
    draw_mesh(sphere(1, 96, 48));
    glDisable(target);
    glDisable(GL_TEXTURE_GEN_R);
}

// Red, green and blue along the axes, in cells.
techniques::Texels cells() {
    techniques::Texels texels{8, 8, 8, 3, {}};
    for (int i = 0; i < 8 * 8 * 8; ++i) {
        for (const int place : {i % 8, i / 8 % 8, i / 64})
            texels.bytes.push_back(static_cast<std::uint8_t>(30 + 28 * place));
    }
    return texels;
}

} // namespace

void texgen(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_DEPTH_TEST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    texture_2d(waves(128));
    cube_map(environment_cube(64));
    texture_3d(cells());
    set_wrap(GL_TEXTURE_3D, GL_CLAMP_TO_EDGE);

    set_mode(GL_OBJECT_LINEAR);
    draw_ball(panel(scene, 0, 3, 2), GL_TEXTURE_2D);
    set_mode(scene.broken ? GL_OBJECT_LINEAR : GL_EYE_LINEAR);
    draw_ball(panel(scene, 1, 3, 2), GL_TEXTURE_2D);
    set_mode(GL_SPHERE_MAP);
    draw_ball(panel(scene, 2, 3, 2), GL_TEXTURE_2D);
    set_mode(GL_REFLECTION_MAP);
    draw_ball(panel(scene, 3, 3, 2), GL_TEXTURE_CUBE_MAP);
    set_mode(GL_NORMAL_MAP);
    draw_ball(panel(scene, 4, 3, 2), GL_TEXTURE_CUBE_MAP);
    set_mode(GL_OBJECT_LINEAR);
    draw_ball(panel(scene, 5, 3, 2), GL_TEXTURE_3D);
}

} // namespace ffgpu::gallery
