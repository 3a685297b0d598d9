#include "driver/vertex/immediate_vertices.h"

#include "driver/vertex/draw_path.h"
#include "driver/vertex/lit_draw.h"
#include "driver/vertex/primitive_cut.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>

namespace ffgpu::gl {

void ImmediateVertices::begin(GLenum mode) {
    if (inside_) return context_.error(GL_INVALID_OPERATION);
    if (mode > GL_POLYGON) return context_.error(GL_INVALID_ENUM);
    if (primitives_.size() >= MaxPrimitives) flush();
    type_ = static_cast<PrimitiveType>(mode);
    first_ = count();
    was_cut_ = false;
    open();
    context_.vertex_phase = VertexPhase::Inside;
}

void ImmediateVertices::end() {
    if (!inside_) return context_.error(GL_INVALID_OPERATION);
    if (was_cut_ && type_ == PrimitiveType::LineLoop) close_loop();
    close();
    const std::uint32_t whole = whole_vertices(type_, count() - first_);
    keep_vertices(first_ + whole);
    materials_.keep_vertices(first_ + whole);
    if (whole != 0) add_primitive(type_, whole);
    // Attributes that were set wait as well: they become current with flush().
    context_.vertex_phase = VertexPhase::Pending;
}

void ImmediateVertices::restart() {
    if (!inside_) return context_.error(GL_INVALID_OPERATION);
    const auto mode = static_cast<GLenum>(type_);
    end();
    begin(mode);
}

void ImmediateVertices::set_color_index(float value) {
    context_.state.current.color_index = value;
}

void ImmediateVertices::indexed(const VertexRun& run, std::span<const std::uint32_t> indices) {
    context_.draw_path().draw_indexed(run, indices);
}

void ImmediateVertices::flush() {
    if (!primitives_.empty()) draw_primitives();
    store_current();
    reset_run();
    materials_.clear();
    context_.vertex_phase = VertexPhase::Idle;
}

void ImmediateVertices::add_primitive(PrimitiveType type, std::uint32_t count) {
    if (!primitives_.empty() && is_independent(type)) {
        RunPrimitive& last = primitives_.back();
        if (last.type == type && last.first + last.count == first_) {
            last.count += count;
            return;
        }
    }
    const bool is_line = type == PrimitiveType::LineStrip || type == PrimitiveType::LineLoop;
    primitives_.push_back({.type = type,
                           .continue_line_stipple = was_cut_ && is_line,
                           .first = first_,
                           .count = count});
}

void ImmediateVertices::draw_primitives() {
    const std::vector<RunPrimitive> primitives = std::exchange(primitives_, {});
    const VertexRun run{format_, words(), primitives};
    if (materials_.empty()) return context_.draw_path().draw(run);
    draw_lit(context_, run, materials_.changes());
}

void ImmediateVertices::change_materials(const Materials& materials) {
    if (!inside_) return context_.flush_vertices();
    if (count() == first_) cut(); // What waits is drawn with the materials of one time.
    if (count() != first_) materials_.change(count(), context_.state.lighting.materials, materials);
}

void ImmediateVertices::cut() {
    const std::uint32_t n = count() - first_;
    const PrimitiveCut cut = cut_primitive(type_, n);
    const bool is_loop = type_ == PrimitiveType::LineLoop;
    if (type_ == PrimitiveType::Polygon && cut.drawn != 0) add_edge_flags();

    // The vertices that the next piece begins with.
    carried_.clear();
    carried_from_.clear();
    const auto carry = [&](std::uint32_t i) {
        carried_from_.push_back(i);
        carried_.insert(carried_.end(), vertex_at(i), vertex_at(i + 1));
    };
    const bool keeps_loop_start = is_loop && (was_cut_ || cut.drawn != 0);
    if (keeps_loop_start) carry(was_cut_ ? first_ - 1 : first_);
    if (cut.carries_first) carry(first_);
    for (std::uint32_t i = n - cut.carried; i < n; ++i)
        carry(first_ + i);

    if (type_ == PrimitiveType::Polygon && cut.drawn != 0) hide_edge(n);
    if (cut.drawn != 0) {
        add_primitive(is_loop ? PrimitiveType::LineStrip : type_, cut.drawn);
        was_cut_ = true;
    }
    if (!primitives_.empty()) draw_primitives();
    materials_.select(carried_from_);
    std::copy(carried_.begin(), carried_.end(), vertex_at(0));
    first_ = keeps_loop_start ? 1 : 0;
    if (format_.stride != 0)
        keep_vertices(static_cast<std::uint32_t>(carried_.size() / format_.stride));
    update_room();
}

// The line from the last vertex back to the first closes a loop that was cut.
void ImmediateVertices::close_loop() {
    type_ = PrimitiveType::LineStrip;
    if (used() + format_.stride > capacity()) enlarge(capacity() + format_.stride);
    std::copy(vertex_at(first_ - 1), vertex_at(first_), vertex_at(count()));
    materials_.repeat(first_ - 1, count());
    keep_vertices(count() + 1);
}

void ImmediateVertices::add_edge_flags() {
    if (format_.elements[attribute_index(Attribute::EdgeFlag)].components != 0) return;
    enlarge(capacity() + 2 * count() + 2); // So that widening needs no room.
    widen_format(Attribute::EdgeFlag, 1);
}

// The edge where a polygon of n vertices is cut lies inside of it: it is none of its boundary (GL
// 1.5, 2.6.2). It ends the first piece, from its last vertex on, and begins the second.
void ImmediateVertices::hide_edge(std::uint32_t n) {
    const unsigned flag = format_.elements[attribute_index(Attribute::EdgeFlag)].offset;
    vertex_at(first_ + n - 1)[flag] = 0;
    carried_[flag] = 0;
}

Vec4 ImmediateVertices::value_of(Attribute attribute) const {
    if (format_.elements[attribute_index(attribute)].components != 0)
        return pending_value(attribute);
    return context_.state.current.of(attribute);
}

void ImmediateVertices::store_current() {
    for (std::size_t a = 1; a < Attributes; ++a) {
        if (format_.elements[a].components == 0) continue;
        const auto attribute = static_cast<Attribute>(a);
        context_.state.current.of(attribute) = pending_value(attribute);
    }
}

void ImmediateVertices::outside_attribute(Attribute attribute, unsigned, const Vec4& value) {
    context_.state.current.of(attribute) = value;
}

bool ImmediateVertices::enters(Attribute attribute, Vec4& before) {
    before = context_.state.current.of(attribute);
    return true;
}

void ImmediateVertices::make_room(unsigned stride) {
    const std::size_t most =
        std::clamp(context_.draw_path().max_words(), LeastCapacity, MostCapacity);
    const auto needed = [&] { return std::size_t{count() + 1} * stride; };
    if (needed() > most) {
        if (inside_) {
            cut();
        } else {
            if (!primitives_.empty()) draw_primitives();
            keep_vertices(0);
            materials_.clear();
        }
    }
    if (needed() > capacity()) enlarge(std::max(LeastCapacity, std::min(2 * needed(), most)));
}

} // namespace ffgpu::gl
