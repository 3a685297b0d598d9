// What the tests of display lists draw and ask.

#pragma once

#include "tests/driver/draw_fixture.h"

namespace ffgpu::gl {

inline void triangle(float first) {
    entry::Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i)
        entry::Vertex3f(first + static_cast<float>(i), 0, 0);
    entry::End();
}

inline GLfloat current_red() {
    GLfloat color[4] = {};
    entry::GetFloatv(GL_CURRENT_COLOR, color);
    return color[0];
}

inline GLint get(GLenum name) {
    GLint value = -1;
    entry::GetIntegerv(name, &value);
    return value;
}

} // namespace ffgpu::gl
