#include "driver/feedback/feedback.h"

namespace ffgpu::gl {

namespace {

GLfloat token_of(FeedbackKind kind) {
    switch (kind) {
    case FeedbackKind::Point:
        return GL_POINT_TOKEN;
    case FeedbackKind::Line:
        return GL_LINE_TOKEN;
    case FeedbackKind::LineReset:
        return GL_LINE_RESET_TOKEN;
    case FeedbackKind::Polygon:
        return GL_POLYGON_TOKEN;
    }
    return 0;
}

} // namespace

void Feedback::primitive(FeedbackKind kind, std::span<const FeedbackVertex> vertices) {
    write(token_of(kind));
    if (kind == FeedbackKind::Polygon) write(static_cast<GLfloat>(vertices.size()));
    for (const FeedbackVertex& vertex : vertices)
        write_vertex(vertex);
}

void Feedback::pass_through(GLfloat value) {
    write(GL_PASS_THROUGH_TOKEN);
    write(value);
}

void Feedback::raster_token(GLenum token, const FeedbackVertex& position) {
    write(static_cast<GLfloat>(token));
    write_vertex(position);
}

void Feedback::write_vertex(const FeedbackVertex& vertex) {
    write(vertex.window[0]);
    write(vertex.window[1]);
    if (type_ == GL_2D) return;
    write(vertex.window[2]);
    if (type_ == GL_3D) return;
    if (type_ == GL_4D_COLOR_TEXTURE) write(vertex.clip_w);
    for (const float component : vertex.color)
        write(component);
    if (type_ == GL_3D_COLOR) return;
    for (const float component : vertex.tex_coord)
        write(component);
}

void Feedback::write(GLfloat value) {
    if (written_ >= static_cast<std::size_t>(size_)) {
        overflow_ = true;
        return;
    }
    buffer_[written_++] = value;
}

} // namespace ffgpu::gl
