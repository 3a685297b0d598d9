// Shadow map: the casters' depth, seen from the light, in a depth texture; on the floor the
// hardware compares each fragment's own depth from the light with it. Left, the nearest texel: in
// shadow or not. Right, percentage-closer filtering: the mean of four comparisons, not of four
// depths.

#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {
namespace {

constexpr int MapSize = 128;

void light_projection() {
    gluPerspective(60, 1, 1, 10);
}
void light_view() {
    gluLookAt(1.6, -1.2, 4, 0, 0, 0, 0, 0, 1);
}

void draw_caster() {
    glColor3f(0.9f, 0.5f, 0.2f);
    glBegin(GL_QUADS);
    glVertex3f(-0.9f, -0.5f, 1.1f);
    glVertex3f(0.7f, -0.7f, 0.9f);
    glVertex3f(0.9f, 0.5f, 1.1f);
    glVertex3f(-0.7f, 0.7f, 1.3f);
    glEnd();
}

void make_shadow_map() {
    glViewport(0, 0, MapSize, MapSize);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    light_projection();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    light_view();
    draw_caster();

    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    set_wrap(GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, MapSize, MapSize, 0);
}

// Where a place of the world lies in the shadow map, and how deep: bias * P_light * V_light.
void generate_map_coordinates() {
    coordinates_are_places();
    glMatrixMode(GL_TEXTURE);
    glTranslatef(0.5f, 0.5f, 0.5f);
    glScalef(0.5f, 0.5f, 0.5f);
    light_projection();
    light_view();
}

// The comparison's result chooses between the colour and its dark form.
void shade_by_map() {
    const GLfloat dark[] = {0.18f, 0.2f, 0.3f, 1};
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_CONSTANT);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_COLOR);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, dark);
}

} // namespace

void shadow_map(const Scene& scene) {
    glEnable(GL_DEPTH_TEST);
    clear(0, 0, 0);
    make_shadow_map();
    clear(0.1f, 0.1f, 0.1f);
    generate_map_coordinates();
    shade_by_map();
    for (int i = 0; i < 2; ++i) {
        const Panel place = panel(scene, i, 2, 1);
        enter(place);
        glMatrixMode(GL_PROJECTION);
        gluPerspective(36, place.aspect(), 0.5, 20);
        glMatrixMode(GL_MODELVIEW);
        gluLookAt(0, -4.5, 4, -0.3, 0.2, 0.3, 0, 0, 1);
        const GLint filter = i == 0 || scene.broken ? GL_NEAREST : GL_LINEAR;
        set_filters(GL_TEXTURE_2D, filter, filter);
        glEnable(GL_TEXTURE_2D);
        glColor3f(0.8f, 0.85f, 0.7f);
        glRectf(-2.2f, -2.2f, 2.2f, 2.2f);
        glDisable(GL_TEXTURE_2D);
        draw_caster();
    }
}

} // namespace ffgpu::gallery
