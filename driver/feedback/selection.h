// The selection mode's side of glRenderMode: the name stack and the hit records (GL 1.5, 5.2).

#pragma once

#include "driver/gl_types.h"

#include <cstddef>
#include <vector>

namespace ffgpu::gl {

class Selection {
public:
    // The application's buffer, of `size` words.
    void set_buffer(GLuint* buffer, GLsizei size) { buffer_ = buffer, size_ = size; }
    GLsizei buffer_size() const { return size_; }
    const GLuint* buffer() const { return buffer_; }

    void start();
    // The number of hit records, or -1 if they did not fit; selection is over.
    GLint finish();

    // Each ends the hit record of the names so far.
    void init_names();
    void load_name(GLuint name);
    void push_name(GLuint name);
    void pop_name();
    const std::vector<GLuint>& names() const { return names_; }

    // A primitive with a vertex of this window depth, in [0, 1], met the clip volume.
    void hit(float depth);

private:
    void end_record();
    void write(GLuint word);

    std::vector<GLuint> names_;
    GLuint* buffer_ = nullptr;
    GLsizei size_ = 0;
    std::size_t written_ = 0;
    GLint records_ = 0;
    bool overflow_ = false;
    bool hit_ = false;
    float nearest_ = 1, farthest_ = 0;
};

} // namespace ffgpu::gl
