// A lit corridor with mip-mapped brick and tile textures: trilinear filtering at every level of
// detail, per-vertex lighting by two lamps, a walk forward. 320x240, 8 frames.

#include "window.h"

namespace {

using namespace demo;

constexpr int Segments = 24; // of the corridor's length, so that the lamps light it smoothly
constexpr float SegmentLength = 1.5f;

GLuint brick, tile, plaster;
GLuint corridor_list;

Image brick_image() {
    return paint(256, [](int x, int y) {
        const int row = y / 32;
        const int shifted = x + (row % 2) * 32;
        const bool mortar = y % 32 < 3 || shifted % 64 < 3;
        const float grain = 0.15f * hash(x, y) + 0.25f * hash(shifted / 64, row);
        return mortar ? Rgb{0.65f + grain / 3, 0.63f + grain / 3, 0.6f + grain / 3}
                      : Rgb{0.45f + grain, 0.2f + grain / 2, 0.14f + grain / 3};
    });
}

Image tile_image() {
    return paint(256, [](int x, int y) {
        const bool joint = x % 64 < 2 || y % 64 < 2;
        const bool dark = ((x / 64) + (y / 64)) % 2 == 0;
        const float grain = 0.08f * hash(x / 2, y / 2);
        const float level = joint ? 0.2f : (dark ? 0.35f : 0.8f) + grain;
        return Rgb{level, level, level * 0.95f};
    });
}

Image plaster_image() {
    return paint(128, [](int x, int y) {
        const float level = 0.7f + 0.15f * hash(x / 4, y / 4) + 0.1f * hash(x, y);
        return Rgb{level, level * 0.97f, level * 0.9f};
    });
}

// One side of the corridor: a strip of quads from (ax, ay) to (bx, by) in the cross section.
void wall(GLuint texture, float ax, float ay, float bx, float by, float nx, float ny) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glNormal3f(nx, ny, 0);
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= Segments; ++i) {
        const float z = -SegmentLength * static_cast<float>(i);
        glTexCoord2f(0, -z / 2);
        glVertex3f(ax, ay, z);
        glTexCoord2f(1, -z / 2);
        glVertex3f(bx, by, z);
    }
    glEnd();
}

void setup() {
    brick = make_texture(brick_image());
    tile = make_texture(tile_image());
    plaster = make_texture(plaster_image());

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
    const GLfloat ambient[] = {0.25f, 0.25f, 0.3f, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    const GLfloat gloss[] = {0.3f, 0.3f, 0.3f, 1};
    glMaterialfv(GL_FRONT, GL_SPECULAR, gloss);
    glMaterialf(GL_FRONT, GL_SHININESS, 20);
    const GLfloat warm[] = {1.0f, 0.85f, 0.6f, 1}, cold[] = {0.5f, 0.6f, 1.0f, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, warm);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, cold);
    for (const GLenum light : {GL_LIGHT0, GL_LIGHT1})
        glLightf(light, GL_LINEAR_ATTENUATION, 0.15f);

    corridor_list = glGenLists(1);
    glNewList(corridor_list, GL_COMPILE);
    wall(tile, -1, -1, 1, -1, 0, 1);
    wall(plaster, 1, 1, -1, 1, 0, -1);
    wall(brick, -1, 1, -1, -1, 1, 0);
    wall(brick, 1, -1, 1, 1, -1, 0);
    glEndList();
}

void draw(int frame) {
    const float step = static_cast<float>(frame);
    glClearColor(0.02f, 0.02f, 0.04f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(65, 4.0 / 3.0, 0.1, 60);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(
        0.2 * std::sin(step * 0.4f), -0.1, -0.35 * step, 0, -0.15, -0.35 * step - 4, 0.05, 1, 0);
    const GLfloat lamp0[] = {0.6f, 0.7f, -3.0f, 1}, lamp1[] = {-0.6f, 0.5f, -10.0f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, lamp0);
    glLightfv(GL_LIGHT1, GL_POSITION, lamp1);
    glCallList(corridor_list);
}

} // namespace

int main() {
    return run("corridor", 320, 240, 8, setup, draw);
}
