#include "driver/vertex/draw_path.h"

#include "driver/feedback/render_modes.h"
#include "driver/objects/shared_objects.h"
#include "driver/vertex/vertex_context.h"
#include "model/device/extents.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

IndexType index_type(const VertexRun& run) {
    return run.vertex_count() <= 0x10000 ? IndexType::U16 : IndexType::U32;
}

// From the run's words to the indices behind them.
std::size_t index_offset(const VertexRun& run) {
    return (run.words.size_bytes() + 63) / 64 * 64;
}

} // namespace

DrawPath::DrawPath(VertexContext& context)
    : context_(context)
    , ring_(context.shared().memory) {}

std::size_t DrawPath::max_words() {
    return ring_.bytes() / sizeof(float) / 2;
}

std::span<float> DrawPath::scratch(std::size_t words) {
    if (scratch_.size() < words) scratch_.resize(words);
    return {scratch_.data(), words};
}

void DrawPath::draw(const VertexRun& run) {
    const auto address = ring_.place(run.words.size_bytes());
    if (!address) return context_.error(GL_OUT_OF_MEMORY);
    context_.device().write_memory(*address, std::as_bytes(run.words));
    draw_resident(run, *address);
}

void DrawPath::draw_resident(const VertexRun& run, DeviceAddress address) {
    if (!prepare(run.format)) return;
    draws_.clear();
    for (const RunPrimitive& primitive : run.primitives) {
        draws_.push_back({.primitive = primitive.type,
                          .continue_line_stipple = primitive.continue_line_stipple,
                          .first = primitive.first,
                          .count = primitive.count,
                          .vertex_count = run.vertex_count(),
                          .vertex_address = address});
    }
    submit();
}

void DrawPath::draw_indexed(const VertexRun& run, std::span<const std::uint32_t> indices) {
    // Both in one place: the second may not push the first out of the ring.
    const auto address = ring_.place(indexed_bytes(run, indices.size()));
    if (!address) return context_.error(GL_OUT_OF_MEMORY);
    write_indexed(run, indices, *address);
    draw_resident_indexed(run, *address);
}

std::size_t DrawPath::indexed_bytes(const VertexRun& run, std::size_t count) {
    return index_offset(run) + count * ffgpu::index_bytes(index_type(run));
}

void DrawPath::write_indexed(const VertexRun& run,
                             std::span<const std::uint32_t> indices,
                             DeviceAddress address) {
    std::span<const std::byte> bytes = std::as_bytes(indices);
    if (index_type(run) == IndexType::U16) {
        short_indices_.resize(indices.size());
        std::transform(indices.begin(), indices.end(), short_indices_.begin(), [](std::uint32_t i) {
            return static_cast<std::uint16_t>(i);
        });
        bytes = std::as_bytes(std::span(short_indices_));
    }
    context_.device().write_memory(address, std::as_bytes(run.words));
    context_.device().write_memory(static_cast<DeviceAddress>(address + index_offset(run)), bytes);
}

void DrawPath::draw_resident_indexed(const VertexRun& run, DeviceAddress address) {
    if (!prepare(run.format)) return;
    const RunPrimitive& whole = run.primitives.front();
    draws_.clear();
    draws_.push_back({.primitive = whole.type,
                      .index_type = index_type(run),
                      .first = 0,
                      .count = whole.count,
                      .vertex_count = run.vertex_count(),
                      .vertex_address = address,
                      .index_address = static_cast<DeviceAddress>(address + index_offset(run))});
    submit();
}

bool DrawPath::prepare(const VertexFormat& format) {
    if (!context_.prepare_draw()) return false;
    RegisterFile& registers = context_.registers;
    registers.wanted.vertex_format = format;
    registers.update<&Registers::vertex_format>();
    // Attributes that the vertices carry are not read from the register: it keeps what it has.
    const CurrentAttributes& current = context_.state.current.attributes;
    for (std::size_t a = 1; a < Attributes; ++a) {
        if (format.elements[a].components == 0)
            registers.wanted.current.values[a] = current.values[a];
    }
    registers.update<&Registers::current>();
    return true;
}

void DrawPath::submit() {
    if (context_.render_modes().mode() != GL_RENDER) return context_.render_modes().draw(draws_);
    commands_.clear();
    for (const DrawCommand& draw : draws_)
        commands_.add(draw);
    context_.submit_drawing(commands_);
}

} // namespace ffgpu::gl
