#include "driver/feedback/render_modes.h"

#include "driver/device_context/device_context.h"
#include "driver/objects/shared_objects.h"

#include <bit>
#include <cstring>

namespace ffgpu::gl {

namespace {

constexpr std::uint32_t FirstRecordBytes = 64u << 10;
constexpr std::uint32_t MaxRecordBytes = 256u << 20;
constexpr std::uint32_t DidNotFit = 0xffffffff;

} // namespace

GLint RenderModes::change_mode(GLenum mode) {
    GLint result = 0;
    if (mode_ == GL_SELECT) result = selection.finish();
    if (mode_ == GL_FEEDBACK) result = feedback.finish();
    mode_ = mode;
    if (mode == GL_SELECT) selection.start();
    if (mode == GL_FEEDBACK) feedback.start();
    return result;
}

void RenderModes::draw(std::span<DrawCommand> draws) {
    for (const DrawCommand& draw : draws) {
        if (!run(draw)) return context_.error(GL_OUT_OF_MEMORY);
        read_records(words_);
    }
}

// Fills words_ with the records of one draw, in a larger buffer if need be. Nothing but the records
// is written, so a draw may be repeated.
bool RenderModes::run(DrawCommand draw) {
    const auto& memory = context_.shared().memory;
    if (!records_) records_ = DeviceBlock::allocate(memory, FirstRecordBytes);
    while (records_) {
        draw.output = DrawOutput::Feedback;
        draw.feedback_address = records_.address();
        draw.feedback_bytes = static_cast<std::uint32_t>(records_.bytes());
        CommandStream stream;
        stream.add(draw);
        context_.submit(stream);

        std::uint32_t bytes = 0;
        context_.device().read_memory(records_.address(),
                                      std::as_writable_bytes(std::span(&bytes, 1)));
        if (bytes != DidNotFit) {
            words_.resize(bytes / sizeof(std::uint32_t));
            context_.device().read_memory(records_.address() + sizeof(bytes),
                                          std::as_writable_bytes(std::span(words_)));
            return true;
        }
        const std::uint64_t larger = 4 * records_.bytes();
        records_ = {}; // Before the next, so that both need not fit.
        if (larger > MaxRecordBytes) return false;
        records_ = DeviceBlock::allocate(memory, larger);
    }
    return false;
}

void RenderModes::read_records(std::span<const std::uint32_t> words) {
    constexpr std::size_t VertexWords = FeedbackVertexWords;
    static_assert(sizeof(FeedbackVertex) == VertexWords * sizeof(float));
    std::size_t at = 0;
    while (at + 2 <= words.size()) {
        const auto kind = static_cast<FeedbackKind>(words[at]);
        const std::size_t n = words[at + 1];
        at += 2;
        if (n * VertexWords > words.size() - at) return;
        vertices_.resize(n);
        std::memcpy(vertices_.data(), words.data() + at, n * sizeof(FeedbackVertex));
        at += n * VertexWords;
        if (mode_ == GL_FEEDBACK) feedback.primitive(kind, vertices_);
        if (mode_ != GL_SELECT) continue;
        for (const FeedbackVertex& vertex : vertices_)
            selection.hit(vertex.window[2]);
    }
}

void RenderModes::raster_position_set() {
    if (mode_ == GL_SELECT) selection.hit(context_.state.current.raster.position[2]);
}

bool RenderModes::takes_pixels(GLenum token) {
    if (mode_ == GL_RENDER) return false;
    if (mode_ == GL_FEEDBACK) {
        const RasterPosition& raster = context_.state.current.raster;
        feedback.raster_token(
            token,
            {.window = {raster.position[0], raster.position[1], raster.position[2]},
             .clip_w = raster.position[3],
             .color = raster.color,
             .tex_coord = raster.tex_coords[0]});
    }
    return true;
}

} // namespace ffgpu::gl
