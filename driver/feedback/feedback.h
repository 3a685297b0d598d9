// The feedback mode's side of glRenderMode: what is drawn comes back as tokens and vertices in the
// application's buffer (GL 1.5, 5.3).

#pragma once

#include "driver/gl_types.h"
#include "model/device/commands.h"

#include <array>
#include <cstddef>
#include <span>

namespace ffgpu::gl {

// A vertex as DrawOutput::Feedback records it.
struct FeedbackVertex {
    std::array<float, 3> window; // depth in [0, 1]
    float clip_w;
    std::array<float, 4> color;
    std::array<float, 4> tex_coord; // s t r q
};

class Feedback {
public:
    void set_buffer(GLfloat* buffer, GLsizei size, GLenum type) {
        buffer_ = buffer, size_ = size, type_ = type;
    }
    GLsizei buffer_size() const { return size_; }
    const GLfloat* buffer() const { return buffer_; }
    GLenum type() const { return type_; }

    void start() { written_ = 0, overflow_ = false; }
    // The number of values, or -1 if they did not fit.
    GLint finish() const { return overflow_ ? -1 : static_cast<GLint>(written_); }

    void primitive(FeedbackKind kind, std::span<const FeedbackVertex> vertices);
    void pass_through(GLfloat value);
    // GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN or GL_COPY_PIXEL_TOKEN, with the raster position.
    void raster_token(GLenum token, const FeedbackVertex& position);

private:
    void write(GLfloat value);
    void write_vertex(const FeedbackVertex& vertex);

    GLfloat* buffer_ = nullptr;
    GLsizei size_ = 0;
    GLenum type_ = GL_2D;
    std::size_t written_ = 0;
    bool overflow_ = false;
};

} // namespace ffgpu::gl
