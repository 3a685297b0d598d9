// Projective texturing: a light as a slide projector. Texture coordinates are places in the world,
// and the texture matrix carries them into the projector's picture: bias * P_light * V_light; s/q
// and t/q are divided out for each fragment. Behind the projector q is negative, and the division
// would throw the picture backwards, too: a second unit masks by the sign of q, so that there it is
// dark.

#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

// The walls, as corners of quadrilaterals.
const GLfloat Room[][4][3] = {
    {{-4, -2, 0}, {4, -2, 0}, {4, 3, 0}, {-4, 3, 0}}, // floor
    {{-4, 3, 0}, {4, 3, 0}, {4, 3, 3}, {-4, 3, 3}},   // back
    {{-4, -2, 0}, {-4, 3, 0}, {-4, 3, 3}, {-4, -2, 3}},
    {{4, 3, 0}, {4, -2, 0}, {4, -2, 3}, {4, 3, 3}},
};
const GLfloat Shades[][3] = {
    {0.3f, 0.3f, 0.33f}, {0.4f, 0.4f, 0.43f}, {0.22f, 0.2f, 0.2f}, {0.2f, 0.2f, 0.22f}};

void set_projector() {
    glActiveTexture(GL_TEXTURE0);
    texture_2d(slide(64));
    set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_BORDER); // whose colour is black
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glEnable(GL_TEXTURE_2D);
    coordinates_are_places();
    glMatrixMode(GL_TEXTURE);
    glTranslatef(0.5f, 0.5f, 0.5f);
    glScalef(0.5f, 0.5f, 0.5f);
    gluPerspective(56, 1, 0.1, 20);
    gluLookAt(0, 0.5, 1.4, 4, 3.5, 1.2, 0, 0, 1);
}

// Two texels: dark where s = q / 100 + 1/2 is below 1/2, else light. There the light's colour is
// kept, in the dark the surface's own.
void set_mask() {
    glActiveTexture(GL_TEXTURE1);
    const GLubyte sides[] = {0, 255};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_1D, name);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE8, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, sides);
    set_filters(GL_TEXTURE_1D, GL_NEAREST, GL_NEAREST);
    set_wrap(GL_TEXTURE_1D, GL_CLAMP_TO_EDGE);
    glEnable(GL_TEXTURE_1D);

    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_COLOR);

    // q is the distance along the projector's view, (4, 3, -0.2) / |(4, 3, -0.2)| from its place.
    const GLfloat length = 5.0039984f * 100;
    const GLfloat ahead[] = {
        4 / length, 3 / length, -0.2f / length, -(0.5f * 3 - 1.4f * 0.2f) / length + 0.5f};
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, ahead);
    glEnable(GL_TEXTURE_GEN_S);
}

} // namespace

void projective_texture(const Scene& scene) {
    clear(0, 0, 0);
    glEnable(GL_DEPTH_TEST);
    set_projector();
    if (!scene.broken) set_mask();

    enter(panel(scene, 0, 1, 1));
    glMatrixMode(GL_PROJECTION);
    gluPerspective(45, panel(scene, 0, 1, 1).aspect(), 0.5, 30);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0, -7, 2.2, 0, 1, 1.2, 0, 0, 1);
    glBegin(GL_QUADS);
    for (int wall = 0; wall < 4; ++wall) {
        glColor3fv(Shades[wall]);
        for (const auto& corner : Room[wall])
            glVertex3fv(corner);
    }
    glEnd();
}

} // namespace ffgpu::gallery
