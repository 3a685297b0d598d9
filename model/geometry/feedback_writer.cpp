#include "model/geometry/feedback_writer.h"

#include <array>
#include <bit>
#include <cstring>

namespace ffgpu {

InterpolantLayout FeedbackWriter::layout() {
    InterpolantLayout layout;
    layout.color = 0;
    layout.tex_coord[0] = 4;
    layout.tex_components[0] = 4;
    layout.count = 8;
    return layout;
}

void FeedbackWriter::point(const WindowVertex& vertex) {
    const std::array<const WindowVertex*, 1> vertices{&vertex};
    record(FeedbackKind::Point, vertices);
}

void FeedbackWriter::line(const WindowVertex& a, const WindowVertex& b, bool reset) {
    const std::array<const WindowVertex*, 2> vertices{&a, &b};
    record(reset ? FeedbackKind::LineReset : FeedbackKind::Line, vertices);
}

void FeedbackWriter::polygon(std::span<const WindowVertex* const> corners) {
    record(FeedbackKind::Polygon, corners);
}

void FeedbackWriter::record(FeedbackKind kind, std::span<const WindowVertex* const> vertices) {
    const std::size_t words = 2 + FeedbackVertexWords * vertices.size();
    overflow_ |= words > (buffer_.size() - used_) / sizeof(std::uint32_t);
    if (overflow_) return;
    constexpr float Grid = 1.0f / (1 << SubPixelBits);
    put(static_cast<std::uint32_t>(kind));
    put(static_cast<std::uint32_t>(vertices.size()));
    for (const WindowVertex* vertex : vertices) {
        put(static_cast<float>(vertex->x) * Grid);
        put(static_cast<float>(vertex->y) * Grid);
        put(vertex->depth);
        put(1 / vertex->inverse_w);
        for (unsigned i = 0; i < 8; ++i)
            put(vertex->attributes[i]);
    }
}

void FeedbackWriter::finish() {
    const std::uint32_t bytes = overflow_ ? 0xffffffff : static_cast<std::uint32_t>(used_ - 4);
    std::memcpy(buffer_.data(), &bytes, sizeof bytes);
}

void FeedbackWriter::put(std::uint32_t word) {
    std::memcpy(buffer_.data() + used_, &word, sizeof word);
    used_ += sizeof word;
}

void FeedbackWriter::put(float value) {
    put(std::bit_cast<std::uint32_t>(value));
}

} // namespace ffgpu
