// A turned solid (a lathe profile, teapot-like) with a sphere-mapped environment and specular light
// over a reflecting table drawn with the stencil buffer. 320x240, 6 frames.

#include "window.h"

namespace {

using namespace demo;

constexpr int Around = 32;
struct Station {
    float radius, height;
};
const Station Profile[] = {{0.0f, -0.75f},
                           {0.55f, -0.75f},
                           {0.6f, -0.7f},
                           {0.85f, -0.4f},
                           {0.98f, -0.05f},
                           {0.92f, 0.3f},
                           {0.7f, 0.6f},
                           {0.66f, 0.66f},
                           {0.6f, 0.7f},
                           {0.35f, 0.82f},
                           {0.12f, 0.88f},
                           {0.1f, 0.95f},
                           {0.18f, 1.04f},
                           {0.12f, 1.13f},
                           {0.0f, 1.16f}};
constexpr int Stations = sizeof(Profile) / sizeof(Profile[0]);

GLuint environment, wood, solid_list;

Image environment_image() {
    return paint(128, [](int x, int y) {
        const float u = (static_cast<float>(x) - 63.5f) / 64,
                    v = (static_cast<float>(y) - 63.5f) / 64;
        const float up = v + 0.1f * std::sin(u * 9);
        const float sun = std::exp(-30 * ((u - 0.35f) * (u - 0.35f) + (v - 0.45f) * (v - 0.45f)));
        if (up > 0)
            return Rgb{0.35f + 0.5f * (1 - up) + sun, 0.5f + 0.4f * (1 - up) + sun, 0.95f + sun};
        const float ground = 0.35f + 0.5f * up + 0.1f * hash(x / 4, y / 4);
        return Rgb{ground, ground * 0.8f, ground * 0.5f};
    });
}

Image wood_image() {
    return paint(128, [](int x, int y) {
        const float ring = std::sin(static_cast<float>(x) * 0.35f + 3 * hash(x / 24, 7) +
                                    0.6f * std::sin(static_cast<float>(y) * 0.06f));
        const float level = 0.45f + 0.1f * ring + 0.06f * hash(x, y / 8);
        return Rgb{level, level * 0.62f, level * 0.35f};
    });
}

// The profile's normal at station i, from its neighbours.
Station normal_at(int i) {
    const Station& before = Profile[i > 0 ? i - 1 : 0];
    const Station& after = Profile[i + 1 < Stations ? i + 1 : Stations - 1];
    const float along_r = after.radius - before.radius, along_h = after.height - before.height;
    const float length = std::sqrt(along_r * along_r + along_h * along_h);
    return {along_h / length, -along_r / length};
}

void turned_solid() {
    for (int i = 0; i + 1 < Stations; ++i) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= Around; ++j) {
            const float angle = 2 * Pi * static_cast<float>(j % Around) / Around;
            const float c = std::cos(angle), s = std::sin(angle);
            for (const int k : {i + 1, i}) {
                const Station n = normal_at(k);
                glNormal3f(c * n.radius, n.height, s * n.radius);
                glVertex3f(c * Profile[k].radius, Profile[k].height, s * Profile[k].radius);
            }
        }
        glEnd();
    }
}

void setup() {
    environment = make_texture(environment_image());
    wood = make_texture(wood_image());
    solid_list = glGenLists(1);
    glNewList(solid_list, GL_COMPILE);
    turned_solid();
    glEndList();

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);
    glEnable(GL_LIGHT0);
    const GLfloat position[] = {2, 4, 3, 0}, white[] = {1, 1, 1, 1},
                  diffuse[] = {0.8f, 0.8f, 0.8f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 60);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
}

void draw_solid(float angle) {
    glPushMatrix();
    glRotatef(angle, 0, 1, 0);
    glRotatef(12, 1, 0, 0.4f);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, environment);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    glEnable(GL_LIGHTING);
    glCallList(solid_list);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_GEN_S);
    glDisable(GL_TEXTURE_GEN_T);
    glPopMatrix();
}

void table() {
    glBindTexture(GL_TEXTURE_2D, wood);
    glBegin(GL_QUADS);
    const float corners[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    for (const auto& corner : corners) {
        glTexCoord2f(corner[0] * 2, corner[1] * 2);
        glVertex3f(corner[0] * 2.4f, -0.9f, corner[1] * 2.4f);
    }
    glEnd();
}

void draw(int frame) {
    const float angle = 15.0f * static_cast<float>(frame);
    glClearColor(0.55f, 0.65f, 0.75f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, 4.0 / 3.0, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 1.6, 5, 0, -0.1, 0, 0, 1, 0);

    // The table's pixels into the stencil buffer, the mirrored solid only there, the table over it.
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_STENCIL_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    table();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glStencilFunc(GL_EQUAL, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glPushMatrix();
    glTranslatef(0, -1.8f, 0);
    glScalef(1, -1, 1);
    glColor4f(1, 1, 1, 1);
    draw_solid(angle);
    glPopMatrix();
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glColor4f(1, 1, 1, 0.75f);
    table();
    glDisable(GL_BLEND);
    glColor4f(1, 1, 1, 1);
    draw_solid(angle);
}

} // namespace

int main() {
    return run("chrome", 320, 240, 6, setup, draw);
}
