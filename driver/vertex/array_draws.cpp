#include "driver/vertex/array_draws.h"

#include "driver/objects/buffer_object.h"
#include "driver/vertex/array_gather.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/immediate_vertices.h"
#include "driver/vertex/index_reader.h"
#include "driver/vertex/primitive_cut.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>
#include <vector>

namespace ffgpu::gl {

namespace {

// Sets the attributes of a vertex in the gathered format, and the vertex itself if it has a
// position.
void feed(VertexAssembler& to, const VertexFormat& format, const float* vertex) {
    for (std::size_t a = Attributes; a-- > 0;) { // The position last.
        const VertexElement element = format.elements[a];
        if (element.components == 0) continue;
        Vec4 value = MissingComponents;
        std::copy_n(vertex + element.offset, element.components, value.begin());
        if (a == 0) {
            to.vertex(element.components, value);
        } else {
            to.set(static_cast<Attribute>(a), element.components, value);
        }
    }
}

bool is_compiling(VertexContext& context) {
    return &context.vertices() != &context.immediate();
}

// As a glBegin, `count` array elements with the indices index_at(0) ..., and a glEnd. But the
// current attributes stay as they are, as they do after the draws that need no feeding: GL 1.5,
// 2.8 leaves them undefined, and programs that draw one thing without normals rely on the normal
// not being the last of another thing's array. (List blocks of array draws set none, either.)
template <class IndexAt>
void feed_primitive(VertexContext& context,
                    const ArrayGather& arrays,
                    GLenum mode,
                    std::uint32_t count,
                    IndexAt&& index_at) {
    const bool compiling = is_compiling(context);
    if (!compiling) context.flush_vertices();
    const CurrentState before = context.state.current;
    std::array<float, 4 * Attributes> vertex{};
    context.vertices().begin(mode);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t element = index_at(i);
        arrays.indexed({&element, 1}, vertex.data());
        feed(context.vertices(), arrays.format(), vertex.data());
    }
    context.vertices().end();
    if (compiling) return;
    context.flush_vertices();
    context.state.current = before;
}

bool can_draw(VertexContext& context, const ArrayGather& arrays, GLenum mode, GLsizei count) {
    if (mode > GL_POLYGON) return context.error(GL_INVALID_ENUM), false;
    if (count < 0) return context.error(GL_INVALID_VALUE), false;
    if (context.fails_inside_begin()) return false;
    if (arrays.is_mapped()) return context.error(GL_INVALID_OPERATION), false;
    return count > 0 && arrays.has_positions();
}

// Index lists that name few vertices far apart are drawn without indices.
void draw_indexed(VertexContext& context,
                  const ArrayGather& arrays,
                  GLenum mode,
                  std::span<std::uint32_t> indices) {
    const auto type = static_cast<PrimitiveType>(mode);
    const std::uint32_t size = whole_vertices(type, static_cast<std::uint32_t>(indices.size()));
    if (size == 0) return;
    indices = indices.first(size);
    std::uint32_t first = indices.front(), last = first;
    for (const std::uint32_t i : indices) { // In lanes, other than std::minmax_element.
        first = std::min(first, i);
        last = std::max(last, i);
    }
    const std::uint64_t range = std::uint64_t{last} - first + 1;
    const std::size_t stride = arrays.format().stride;
    DrawPath& path = context.draw_path();

    const bool is_dense = range <= 2 * std::uint64_t{size} + 16;
    const std::uint64_t vertices = is_dense ? range : size;
    const bool compiling = is_compiling(context);
    const bool fits = vertices * stride <= path.max_words() && size <= path.max_words();
    if (compiling ? !is_dense : !fits)
        return feed_primitive(context, arrays, mode, size, [&](auto i) { return indices[i]; });

    const std::span<float> words = path.scratch(vertices * stride);
    const RunPrimitive whole{.type = type, .first = 0, .count = size};
    if (!is_dense) {
        arrays.indexed(indices, words.data());
        return path.draw({arrays.format(), words, {&whole, 1}});
    }
    arrays.range(first, static_cast<std::uint32_t>(range), words.data());
    for (std::uint32_t& i : indices)
        i -= first;
    context.vertices().indexed({arrays.format(), words, {&whole, 1}}, indices);
}

} // namespace

void draw_arrays(VertexContext& context, GLenum mode, GLint first, GLsizei count) {
    const ArrayGather arrays(*context.client.arrays.object);
    if (first < 0) return context.error(GL_INVALID_VALUE);
    if (!can_draw(context, arrays, mode, count)) return;

    const std::size_t stride = arrays.format().stride;
    const auto from = static_cast<std::uint32_t>(first);
    const auto type = static_cast<PrimitiveType>(mode);
    const std::uint32_t vertices = whole_vertices(type, static_cast<std::uint32_t>(count));
    if (vertices == 0) return;
    DrawPath& path = context.draw_path();
    if (is_compiling(context) || vertices * stride > path.max_words()) {
        const auto index_at = [&](std::uint32_t i) { return from + i; };
        return feed_primitive(context, arrays, mode, vertices, index_at);
    }
    const std::span<float> words = path.scratch(vertices * stride);
    arrays.range(from, vertices, words.data());
    const RunPrimitive whole{.type = type, .first = 0, .count = vertices};
    path.draw({arrays.format(), words, {&whole, 1}});
}

void draw_elements(VertexContext& context,
                   GLenum mode,
                   GLsizei count,
                   GLenum type,
                   const void* indices,
                   GLint base_vertex) {
    const VertexArrayState& state = context.client.arrays;
    const ArrayGather arrays(*state.object);
    if (index_bytes(type) == 0) return context.error(GL_INVALID_ENUM);
    const BufferObject* const buffer = state.object->element_buffer.get();
    if (buffer && buffer->mapped) return context.error(GL_INVALID_OPERATION);
    if (!can_draw(context, arrays, mode, count)) return;

    const IndexReader reader(indices, buffer, type, static_cast<std::size_t>(count));
    if (!reader.in_range()) return context.error(GL_INVALID_OPERATION);
    std::vector<std::uint32_t>& all = context.draw_path().index_scratch();
    reader.read(all);
    // A restart index ends a primitive; the next begins behind it.
    auto begin = all.begin();
    while (begin != all.end()) {
        const auto end =
            state.primitive_restart ? std::find(begin, all.end(), state.restart_index) : all.end();
        for (auto i = begin; i != end; ++i)
            *i += static_cast<std::uint32_t>(base_vertex);
        if (begin != end) draw_indexed(context, arrays, mode, {begin, end});
        begin = end == all.end() ? end : end + 1;
    }
}

void array_element(VertexContext& context, GLint i) {
    const VertexArrayState& state = context.client.arrays;
    const auto element = static_cast<std::uint32_t>(i);
    if (state.primitive_restart && element == state.restart_index)
        return context.vertices().restart();
    // Undefined; the specification recommends this error (GL 1.5, 2.8).
    if (i < 0) return context.error(GL_INVALID_VALUE);
    const ArrayGather arrays(*state.object);
    if (arrays.is_mapped()) return context.error(GL_INVALID_OPERATION);
    std::array<float, 4 * Attributes> vertex{};
    arrays.indexed({&element, 1}, vertex.data());
    feed(context.vertices(), arrays.format(), vertex.data());
}

} // namespace ffgpu::gl
