// The scene of the tour through the pipeline (docs/pipeline): a frame that uses every stage, twice.
// A textured floor that begins behind the eye, a wall with a light map, a lit sphere of indexed
// triangles with its shadow by stencil, a triangle of three colours that leans away, an
// alpha-tested fence, blended glass, fog. 320x240.

#define GL_GLEXT_PROTOTYPES
#include "window.h"

namespace {

using namespace demo;

GLuint tiles, stone, light_map, fence;

Image tile_image() {
    return paint(64, [](int x, int y) {
        const bool dark = (x / 16 + y / 16) % 2 == 0;
        const float grain = 0.12f * hash(x, y), level = dark ? 0.55f : 0.8f;
        const bool joint = x % 16 == 0 || y % 16 == 0;
        return joint ? Rgb{0.15f, 0.13f, 0.12f}
                     : Rgb{level + grain, level * 0.9f + grain, level * 0.75f + grain};
    });
}

Image stone_image() {
    return paint(64, [](int x, int y) {
        const int row = y / 16;
        const bool joint = y % 16 < 1 || (x + row % 2 * 16) % 32 < 1;
        const float level = 0.5f + 0.2f * hash((x + row % 2 * 16) / 32, row) + 0.15f * hash(x, y);
        return joint ? Rgb{0.25f, 0.25f, 0.27f} : Rgb{level, level * 0.8f, level * 0.65f};
    });
}

Image light_image() {
    return paint(16, [](int x, int y) {
        const float dx = (static_cast<float>(x) - 5.0f) / 5.0f,
                    dy = (static_cast<float>(y) - 10.0f) / 5.0f;
        const float pool = std::exp(-(dx * dx + dy * dy));
        return Rgb{0.25f + 0.75f * pool, 0.25f + 0.7f * pool, 0.3f + 0.5f * pool};
    });
}

void make_fence() {
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const bool bar = (x + y) % 16 < 4 || (x + 32 - y) % 16 < 4;
            texels.push_back(bar ? 190 : 90);
            texels.push_back(bar ? 255 : 0);
        }
    }
    glGenTextures(1, &fence);
    glBindTexture(GL_TEXTURE_2D, fence);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 GL_LUMINANCE_ALPHA,
                 32,
                 32,
                 0,
                 GL_LUMINANCE_ALPHA,
                 GL_UNSIGNED_BYTE,
                 texels.data());
}

// Latitudes and longitudes; a vertex' normal is its position.
constexpr int Rows = 12, Columns = 18;
std::vector<GLfloat> sphere;
std::vector<GLushort> sphere_indices;

void make_sphere() {
    for (int row = 0; row <= Rows; ++row) {
        const float polar = Pi * static_cast<float>(row) / Rows;
        for (int column = 0; column <= Columns; ++column) {
            const float around = 2 * Pi * static_cast<float>(column) / Columns;
            for (const float value : {std::sin(polar) * std::cos(around),
                                      std::cos(polar),
                                      -std::sin(polar) * std::sin(around)})
                sphere.push_back(value);
        }
    }
    const auto index = [](int row, int column) {
        return static_cast<GLushort>(row * (Columns + 1) + column);
    };
    for (int row = 0; row < Rows; ++row) {
        for (int column = 0; column < Columns; ++column) {
            for (const GLushort corner : {index(row, column),
                                          index(row + 1, column),
                                          index(row + 1, column + 1),
                                          index(row, column),
                                          index(row + 1, column + 1),
                                          index(row, column + 1)})
                sphere_indices.push_back(corner);
        }
    }
}

void draw_sphere() {
    glPushMatrix();
    glTranslatef(0.45f, 0.75f, -1.2f);
    glScalef(0.65f, 0.65f, 0.65f);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, sphere.data());
    glNormalPointer(GL_FLOAT, 0, sphere.data());
    glDrawElements(GL_TRIANGLES,
                   static_cast<GLsizei>(sphere_indices.size()),
                   GL_UNSIGNED_SHORT,
                   sphere_indices.data());
    glDisableClientState(GL_NORMAL_ARRAY);
    glDisableClientState(GL_VERTEX_ARRAY);
    glPopMatrix();
}

constexpr GLfloat Lamp[] = {-2.5f, 3, 2.5f, 1};

void draw_lit_sphere() {
    glColor3f(0.8f, 0.8f, 0.8f); // Lighting replaces it.
    const GLfloat paint_color[] = {0.8f, 0.25f, 0.2f, 1}, gloss[] = {0.9f, 0.9f, 0.9f, 1};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glLightfv(GL_LIGHT0, GL_POSITION, Lamp);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, paint_color);
    glMaterialfv(GL_FRONT, GL_SPECULAR, gloss);
    glMaterialf(GL_FRONT, GL_SHININESS, 24);
    glEnable(GL_CULL_FACE);
    draw_sphere();
    glDisable(GL_CULL_FACE);
    glDisable(GL_LIGHTING);
}

// The sphere flattened onto the floor along the rays from the lamp; each pixel is darkened once.
void draw_shadow() {
    const GLfloat flatten[] = {
        Lamp[1], 0, 0, 0, -Lamp[0], 0, -Lamp[2], -1, 0, 0, Lamp[1], 0, 0, 0, 0, Lamp[1]};
    glPushMatrix();
    glMultMatrixf(flatten);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 255);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -2);
    glDepthMask(GL_FALSE);
    glColor4f(0, 0, 0.05f, 0.6f);
    draw_sphere();
    glDepthMask(GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glPopMatrix();
}

void draw_triangle() {
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex3f(-1.5f, 0.15f, 1.6f);
    glColor3f(0, 1, 0);
    glVertex3f(-0.6f, 0.3f, -2.6f);
    glColor3f(0, 0, 1);
    glVertex3f(-2.3f, 2.1f, -1.2f);
    glEnd();
}

void draw_floor() {
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, tiles);
    glColor3f(1, 1, 1);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(-8, 0, 6);
    glTexCoord2f(8, 0);
    glVertex3f(8, 0, 6);
    glTexCoord2f(8, 11);
    glVertex3f(8, 0, -16);
    glTexCoord2f(0, 11);
    glVertex3f(-8, 0, -16);
    glEnd();
}

void draw_wall() {
    glBindTexture(GL_TEXTURE_2D, stone);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, light_map);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    const GLfloat corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    glBegin(GL_QUADS);
    for (const GLfloat* corner : corners) {
        glMultiTexCoord2f(GL_TEXTURE0, 4 * corner[0], 2 * corner[1]);
        glMultiTexCoord2f(GL_TEXTURE1, corner[0], corner[1]);
        glVertex3f(-2 + 5.5f * corner[0], 2.3f * corner[1], -4);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
}

void draw_fence() {
    glBindTexture(GL_TEXTURE_2D, fence);
    glColor3f(0.8f, 0.9f, 0.6f);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(0.9f, 0, 0.6f);
    glTexCoord2f(2, 0);
    glVertex3f(2.3f, 0, -0.2f);
    glTexCoord2f(2, 1);
    glVertex3f(2.3f, 0.75f, -0.2f);
    glTexCoord2f(0, 1);
    glVertex3f(0.9f, 0.75f, 0.6f);
    glEnd();
    glDisable(GL_ALPHA_TEST);
    glDisable(GL_TEXTURE_2D);
}

void draw_glass() {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glBegin(GL_QUADS);
    glColor4f(0.1f, 0.5f, 0.9f, 0.7f);
    glVertex3f(-0.95f, 0.2f, 0);
    glVertex3f(0.05f, 0.2f, 0);
    glColor4f(0.6f, 0.9f, 1, 0.25f);
    glVertex3f(0.05f, 1.5f, 0);
    glVertex3f(-0.95f, 1.5f, 0);
    glEnd();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void setup() {
    tiles = make_texture(tile_image());
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);
    stone = make_texture(stone_image());
    light_map = make_texture(light_image(), false);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    make_fence();
    make_sphere();
    glEnable(GL_DEPTH_TEST);
    const GLfloat mist[] = {0.55f, 0.65f, 0.75f, 1};
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, 15);
    glFogfv(GL_FOG_COLOR, mist);
    glClearColor(mist[0], mist[1], mist[2], mist[3]);
}

void draw(int) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50, 4.0 / 3.0, 0.2, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 1.3, 3.6, 0, 0.75, -2, 0, 1, 0);
    draw_lit_sphere();
    draw_triangle();
    draw_floor();
    draw_wall();
    draw_fence();
    draw_shadow();
    draw_glass();
}

} // namespace

int main() {
    return run("tour", 320, 240, 2, setup, draw);
}
