#include "driver/lists/list_vertices.h"

#include "driver/lists/record.h"
#include "driver/vertex/primitive_cut.h"

#include <algorithm>
#include <utility>

namespace ffgpu::gl {

void ListVertices::start(DisplayList& list) {
    list_ = &list;
    raw_ = false;
    array_draws_ = false;
    close();
    reset_run();
    primitives_.clear();
    inherited_.fill(0);
    forget_current();
}

void ListVertices::begin(GLenum mode) {
    // Errors are found when the list is executed.
    if (inside_) spill();
    if (raw_ || mode > GL_POLYGON) return record_begin(mode);
    mode_ = mode;
    first_ = count();
    begin_format_ = format_;
    begin_values_ = pending_values();
    open();
}

void ListVertices::end() {
    if (!inside_) {
        RecordWriter(list_->code, operation(Command::End)).commit();
        raw_ = false;
        return;
    }
    close();
    const auto type = static_cast<PrimitiveType>(mode_);
    const std::uint32_t whole = whole_vertices(type, count() - first_);
    keep_vertices(first_ + whole);
    if (whole == 0) return;
    const bool goes_on = !primitives_.empty() && is_independent(type) &&
                         primitives_.back().type == type &&
                         primitives_.back().first + primitives_.back().count == first_;
    if (goes_on) {
        primitives_.back().count += whole;
    } else {
        primitives_.push_back({.type = type, .first = first_, .count = whole});
    }
}

void ListVertices::restart() {
    if (!inside_) {
        RecordWriter(list_->code, operation(Command::PrimitiveRestartNV)).commit();
        return;
    }
    end();
    begin(mode_);
}

void ListVertices::set_color_index(float value) {
    RecordWriter record(list_->code, Operation::SetColorIndex);
    record.value(value).commit();
}

bool ListVertices::begin_array_draw() {
    // Not merged with the array draw before: an array that is no longer enabled leaves its place to
    // the current value.
    const bool refused = inside_primitive();
    settle();
    array_draws_ = true;
    if (refused) settle(); // An empty block of array draws: all it does is to err.
    return !refused;
}

void ListVertices::indexed(const VertexRun& run, std::span<const std::uint32_t> indices) {
    if (!primitives_.empty()) { // of the same call, taken apart
        settle();
        array_draws_ = true;
    }
    auto block = std::make_unique<VertexBlock>();
    block->format = run.format;
    block->words.assign(run.words.begin(), run.words.end());
    block->primitives.assign(run.primitives.begin(), run.primitives.end());
    block->indices.assign(indices.begin(), indices.end());
    block->is_array_draw = true;
    add_block(std::move(block));
}

void ListVertices::settle() {
    if (inside_) spill();
    seal_block(format_, pending_values());
}

ListVertices::Values ListVertices::pending_values() const {
    Values values{};
    for (std::size_t a = 1; a < Attributes; ++a)
        values[a] = pending_value(static_cast<Attribute>(a));
    return values;
}

// The vertices of whole primitives become a block, after which the attributes of `set` have the
// values `last`.
void ListVertices::seal_block(const VertexFormat& set, const Values& last) {
    if (primitives_.empty() && !array_draws_) {
        record_attributes(set, last);
    } else {
        auto block = std::make_unique<VertexBlock>();
        block->format = format_;
        block->words.assign(words().begin(), words().end());
        block->primitives = std::exchange(primitives_, {});
        block->inherited = inherited_;
        block->is_array_draw = std::exchange(array_draws_, false);
        block->inherits = std::any_of(
            inherited_.begin(), inherited_.end(), [](std::uint32_t n) { return n != 0; });
        for (std::size_t a = 1; a < Attributes; ++a) {
            if (block->is_array_draw || set.elements[a].components == 0) continue;
            block->sets |= 1u << a;
            block->last[a] = last[a];
            known_[a] = last[a];
        }
        add_block(std::move(block));
    }
    inherited_.fill(0);
    reset_run();
}

void ListVertices::add_block(std::unique_ptr<VertexBlock> block) {
    RecordWriter record(list_->code, Operation::DrawBlock);
    record.value(reinterpret_cast<std::uintptr_t>(block.get())).commit();
    list_->blocks.push_back(std::move(block));
}

void ListVertices::record_attributes(const VertexFormat& set, const Values& values) {
    for (std::size_t a = 1; a < Attributes; ++a) {
        if (set.elements[a].components != 0)
            outside_attribute(static_cast<Attribute>(a), set.elements[a].components, values[a]);
    }
}

// The primitive at hand cannot be a block: its calls are recorded as they came.
void ListVertices::spill() {
    close();
    const VertexFormat format = format_;
    const auto inherited = inherited_;
    const Values last = pending_values();
    const std::uint32_t first = first_;
    const std::vector<float> vertices(words().begin() + first * format.stride, words().end());
    keep_vertices(first);
    seal_block(begin_format_, begin_values_);

    record_begin(mode_);
    const auto value = [&](std::size_t a, std::size_t at) {
        Vec4 result = MissingComponents;
        const VertexElement element = format.elements[a];
        std::copy_n(vertices.begin() + static_cast<std::ptrdiff_t>(at + element.offset),
                    element.components,
                    result.begin());
        return result;
    };
    std::uint32_t vertex = first;
    for (std::size_t at = 0; at < vertices.size(); at += format.stride, ++vertex) {
        for (std::size_t a = 1; a < Attributes; ++a) {
            const unsigned components = format.elements[a].components;
            if (components != 0 && vertex >= inherited[a])
                outside_attribute(static_cast<Attribute>(a), components, value(a, at));
        }
        outside_vertex(format.elements[0].components, value(0, at));
    }
    record_attributes(format, last);
}

void ListVertices::record_begin(GLenum mode) {
    RecordWriter record(list_->code, operation(Command::Begin));
    record.value(mode).commit();
    raw_ = raw_ || mode <= GL_POLYGON;
}

void ListVertices::outside_attribute(Attribute attribute, unsigned components, const Vec4& value) {
    known_[attribute_index(attribute)] = value;
    RecordWriter record(list_->code, Operation::SetAttribute);
    record.value(attribute).value(static_cast<std::uint8_t>(components)).value(value).commit();
}

void ListVertices::outside_vertex(unsigned components, const Vec4& position) {
    RecordWriter record(list_->code, Operation::Vertex);
    record.value(static_cast<std::uint8_t>(components)).value(position).commit();
}

bool ListVertices::enters(Attribute attribute, Vec4& before) {
    const std::size_t a = attribute_index(attribute);
    if (count() == 0) return true;
    if (known_[a]) {
        before = *known_[a];
        return true;
    }
    if (inside_) {
        inherited_[a] = count();
        return true;
    }
    settle();
    return false;
}

void ListVertices::make_room(unsigned stride) {
    constexpr std::size_t FirstCapacity = 1u << 10;
    const std::size_t needed = std::size_t{count() + 1} * stride;
    if (needed > capacity()) enlarge(std::max(FirstCapacity, 2 * needed));
}

} // namespace ffgpu::gl
