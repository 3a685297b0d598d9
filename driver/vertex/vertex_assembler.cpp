#include "driver/vertex/vertex_assembler.h"

#include "model/base/float_environment.h"

#include <algorithm>

namespace ffgpu::gl {

void VertexAssembler::set(Attribute attribute, unsigned components, const Vec4& v) {
    if (format_.elements[attribute_index(attribute)].components != components)
        return set_other(attribute, components, v);
    pending(attribute) = v;
}

void VertexAssembler::vertex(unsigned components, const Vec4& p) {
    switch (components) {
    case 2:
        return vertex<2>(p[0], p[1]);
    case 3:
        return vertex<3>(p[0], p[1], p[2]);
    default:
        return vertex<4>(p[0], p[1], p[2], p[3]);
    }
}

// The calls that only move numbers run in the application's floating-point mode; what waits may be
// drawn here, and numbers are compared.
void VertexAssembler::set_other(Attribute attribute, unsigned components, const Vec4& value) {
    const FloatEnvironment environment;
    if (format_.elements[attribute_index(attribute)].components < components) {
        if (!inside_ && count() == 0) return outside_attribute(attribute, components, value);
        if (!widen_format(attribute, components))
            return outside_attribute(attribute, components, value);
    }
    pending(attribute) = value;
}

void VertexAssembler::other_vertex(unsigned components, const Vec4& position) {
    const FloatEnvironment environment;
    if (!inside_) return outside_vertex(components, position);
    if (format_.elements[0].components < components) widen_format(Attribute::Position, components);
    if (room_ == 0) {
        make_room(format_.stride);
        update_room();
    }
    const unsigned words = format_.elements[0].components;
    std::copy_n(position.data(), words, cursor_);
    finish_vertex();
}

bool VertexAssembler::widen_format(Attribute attribute, unsigned components) {
    Vec4 before = MissingComponents;
    const bool is_new = format_.elements[attribute_index(attribute)].components == 0;
    if (is_new && attribute != Attribute::Position && !enters(attribute, before)) return false;

    // A value that is wider than what the application sets from now on stays whole.
    if (is_new && count() > 0) {
        for (unsigned c = components; c < 4; ++c)
            if (before[c] != MissingComponents[c]) components = c + 1;
    }
    const VertexFormat wide = widen(format_, attribute, components);
    if (std::size_t{count() + 1} * wide.stride > capacity()) make_room(wide.stride);
    convert_vertices(wide, attribute, is_new ? before : MissingComponents);
    update_room();
    return true;
}

void VertexAssembler::convert_vertices(const VertexFormat& to,
                                       Attribute entering,
                                       const Vec4& before) {
    const bool is_new = format_.elements[attribute_index(entering)].components == 0;
    const VertexElement entered = to.elements[attribute_index(entering)];
    const std::uint32_t vertices = count();
    std::array<float, 4 * Attributes> one{};
    // From the last one down: a vertex moves to where only later ones have been.
    for (std::uint32_t i = vertices; i-- > 0;) {
        convert_vertex(format_, to, vertex_at(i), one.data());
        if (is_new) std::copy_n(before.data(), entered.components, one.data() + entered.offset);
        std::copy_n(one.data(), to.stride, words_.data() + std::size_t{i} * to.stride);
    }
    if (is_new) pending(entering) = before;
    set_format(to);
    keep_vertices(vertices);
}

void VertexAssembler::set_format(const VertexFormat& format) {
    format_ = format;
    placed_count_ = 0;
    for (std::size_t a = attribute_index(Attribute::Position) + 1; a < Attributes; ++a)
        if (format.elements[a].components != 0)
            placed_[placed_count_++] = {static_cast<std::uint8_t>(a), format.elements[a].offset};
}

void VertexAssembler::enlarge(std::size_t capacity) {
    const std::size_t kept = used();
    words_.resize(capacity + Slack);
    cursor_ = words_.data() + kept;
}

void VertexAssembler::reset_run() {
    set_format(EmptyVertexFormat);
    cursor_ = words_.data();
    room_ = 0;
}

void VertexAssembler::update_room() {
    const std::size_t free = capacity() - used();
    room_ = inside_ && format_.stride != 0 ? static_cast<std::uint32_t>(free / format_.stride) : 0;
}

Vec4 VertexAssembler::pending_value(Attribute attribute) const {
    const VertexElement element = format_.elements[attribute_index(attribute)];
    Vec4 value = MissingComponents;
    std::copy_n(pending_[attribute_index(attribute)].data(), element.components, value.data());
    return value;
}

} // namespace ffgpu::gl
