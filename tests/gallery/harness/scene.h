// What a program of the gallery is given: a window to fill, already current.

#pragma once

#include "tests/gallery/harness/opengl.h"

namespace ffgpu::gallery {

struct Scene {
    int width = 320, height = 240;
    bool broken = false; // Do the one thing wrong that the program's oracle has to notice.
};

// A part of the window. `index` counts rows of panels from the top left.
struct Panel {
    int x, y, width, height;

    double aspect() const { return static_cast<double>(width) / height; }
};

inline Panel panel(const Scene& scene, int index, int columns, int rows) {
    const int width = scene.width / columns, height = scene.height / rows;
    return {index % columns * width, (rows - 1 - index / columns) * height, width, height};
}

// Draw into the panel, with unit matrices.
inline void enter(const Panel& panel) {
    glViewport(panel.x, panel.y, panel.width, panel.height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

// A pixel of the panel is a unit of length, from the lower left corner.
inline void enter_in_pixels(const Panel& panel) {
    enter(panel);
    glMatrixMode(GL_PROJECTION);
    gluOrtho2D(0, panel.width, 0, panel.height);
    glMatrixMode(GL_MODELVIEW);
}

inline void clear(float red, float green, float blue) {
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

} // namespace ffgpu::gallery
