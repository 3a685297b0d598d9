// Transparency. Above, four panes blended in two orders of submission: the results differ. Below
// left, what is opaque first, then the panes sorted from back to front. Below right, depth peeling:
// layer after layer, the nearest depth behind the layer before, found by a comparison with the
// depths of that layer in a texture; the panes come in any order.

#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <array>

namespace ffgpu::gallery {
namespace {

struct Pane {
    GLfloat left, bottom, right, top, depth; // larger is farther
    GLfloat color[4];
};
const Pane Panes[] = {
    {20, 40, 100, 110, 0.6f, {0.9f, 0.2f, 0.2f, 0.5f}},
    {60, 10, 140, 80, 0.3f, {0.2f, 0.8f, 0.3f, 0.6f}},
    {40, 25, 120, 95, 0.8f, {0.2f, 0.4f, 1.0f, 0.7f}},
    {10, 55, 150, 75, 0.45f, {1.0f, 0.9f, 0.2f, 0.4f}},
};
const Pane Opaque{75, 5, 95, 115, 0.5f, {0.15f, 0.15f, 0.15f, 1}};
constexpr GLfloat Background[] = {0.95f, 0.93f, 0.88f, 1};
using Order = std::array<int, 4>;

// Leaning: the right edge is farther than the left one by 0.05.
void draw_pane(const Pane& pane, bool premultiplied) {
    const GLfloat a = premultiplied ? pane.color[3] : 1;
    glColor4f(a * pane.color[0], a * pane.color[1], a * pane.color[2], pane.color[3]);
    glBegin(GL_QUADS);
    glVertex3f(pane.left, pane.bottom, -pane.depth);
    glVertex3f(pane.right, pane.bottom, -pane.depth - 0.05f);
    glVertex3f(pane.right, pane.top, -pane.depth - 0.05f);
    glVertex3f(pane.left, pane.top, -pane.depth);
    glEnd();
}

void draw_blended(const Panel& place, const Order& order) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, place.width, 0, place.height, 0, 1);
    glMatrixMode(GL_MODELVIEW);
    draw_pane(Opaque, false);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    for (const int i : order)
        draw_pane(Panes[i], false);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void draw_all(const Order& order) {
    draw_pane(Opaque, true);
    for (const int i : order)
        draw_pane(Panes[i], true);
}

// Alpha is kept where the fragment lies behind the texture's depth, and is 0 elsewhere. The
// texture's first texels are the panel's pixels.
void compare_with_last_layer(const Panel& place) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    set_filters(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GREATER);
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 GL_DEPTH_COMPONENT24,
                 256,
                 128,
                 0,
                 GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT,
                 nullptr);
    for (int i = 0; i < 3; ++i) {
        GLfloat plane[4] = {};
        plane[i] = i == 0 ? 1.0f / 256 : i == 1 ? 1.0f / 128 : -1;
        if (i == 2) plane[3] = -0.001f; // Not behind itself.
        const auto coordinate = static_cast<GLenum>(GL_S + i);
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        glTexGenfv(coordinate, GL_OBJECT_PLANE, plane);
        glEnable(static_cast<GLenum>(GL_TEXTURE_GEN_S + i));
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glAlphaFunc(GL_GREATER, 0);
    glScissor(place.x, place.y, place.width, place.height);
}

// The layer's depths, then its colours under what is already there: C += (1 - A) a c, A += (1 - A)
// a.
void draw_layer(const Panel& place, const Order& order, bool first) {
    glClear(GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    if (!first) {
        glEnable(GL_TEXTURE_2D);
        glEnable(GL_ALPHA_TEST);
    }
    draw_all(order);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_ALPHA_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, place.x, place.y, place.width, place.height);

    glDepthFunc(GL_EQUAL);
    draw_all(order);
    glDepthFunc(GL_LESS);
}

void draw_peeled(const Panel& place, const Order& order, int layers) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, place.width, 0, place.height, 0, 1);
    glMatrixMode(GL_MODELVIEW);
    compare_with_last_layer(place);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    for (int layer = 0; layer < layers; ++layer)
        draw_layer(place, order, layer == 0);
    glDisable(GL_DEPTH_TEST);
    glColor4fv(Background);
    glRectf(0, 0, static_cast<GLfloat>(place.width), static_cast<GLfloat>(place.height));
}

} // namespace

void transparency(const Scene& scene) {
    clear(Background[0], Background[1], Background[2]);
    glEnable(GL_DEPTH_TEST);
    draw_blended(panel(scene, 0, 2, 2), {0, 1, 2, 3});
    draw_blended(panel(scene, 1, 2, 2), {3, 2, 1, 0});
    draw_blended(panel(scene, 2, 2, 2), {2, 0, 3, 1});
    draw_peeled(panel(scene, 3, 2, 2), {1, 3, 0, 2}, scene.broken ? 1 : 5);
}

} // namespace ffgpu::gallery
