// A floor that is seen at a grazing angle: what filters are judged by.

#pragma once

#include "tests/gallery/harness/scene.h"

#include <utility>

namespace ffgpu::gallery {

// z = 0 from y = 1 to 60 in front of an eye at (0, 0, 1) that looks at (0, 5, 0), 19 degrees from
// the lower edge to the upper; the picture repeats every two units. `shift` moves the view by parts
// of a pixel.
inline void draw_grazing_floor(const Panel& place, double shift_x = 0, double shift_y = 0) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    glTranslated(2 * shift_x / place.width, 2 * shift_y / place.height, 0);
    gluPerspective(19, place.aspect(), 0.1, 100);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0, 0, 1, 0, 5, 0, 0, 0, 1);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-30.f, 1.f}, {30.f, 1.f}, {30.f, 60.f}, {-30.f, 60.f}}) {
        glTexCoord2f(x / 2, y / 2);
        glVertex3f(x, y, 0);
    }
    glEnd();
}

} // namespace ffgpu::gallery
