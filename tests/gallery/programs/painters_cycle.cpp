// The painter's algorithm and the z-buffer. Three bars lie over each other in a circle. The first
// six panels paint them in each of the six orders: none is right, because no bar is the last. The
// last two use the z-buffer, in two orders: right, and the same.

#include "tests/gallery/programs/programs.h"

#include <algorithm>
#include <array>

namespace ffgpu::gallery {
namespace {

const GLfloat BarColors[][3] = {{0.9f, 0.25f, 0.2f}, {0.25f, 0.75f, 0.3f}, {0.25f, 0.4f, 0.95f}};

// Bar i along a side of a triangle; one end is nearer than the other.
void draw_bar(int i) {
    glPushMatrix();
    glRotatef(120.0f * static_cast<float>(i), 0, 0, 1);
    glColor3fv(BarColors[i]);
    glBegin(GL_QUADS);
    glVertex3f(0.15f, -1.2f, -0.4f);
    glVertex3f(0.6f, -1.2f, -0.4f);
    glVertex3f(0.6f, 1.2f, 0.4f);
    glVertex3f(0.15f, 1.2f, 0.4f);
    glEnd();
    glPopMatrix();
}

void draw_bars(const Panel& place, const std::array<int, 3>& order) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1.4, 1.4, -1.4 / place.aspect(), 1.4 / place.aspect(), -1, 1);
    glMatrixMode(GL_MODELVIEW);
    for (const int bar : order)
        draw_bar(bar);
}

} // namespace

void painters_cycle(const Scene& scene) {
    clear(0.95f, 0.93f, 0.88f);
    std::array<int, 3> order{0, 1, 2};
    int place = 0;
    do {
        draw_bars(panel(scene, place++, 4, 2), order);
    } while (std::next_permutation(order.begin(), order.end()));

    glEnable(GL_DEPTH_TEST);
    if (scene.broken) glDepthFunc(GL_ALWAYS);
    draw_bars(panel(scene, 6, 4, 2), {0, 1, 2});
    draw_bars(panel(scene, 7, 4, 2), {2, 1, 0});
}

} // namespace ffgpu::gallery
