// Vertex arrays in the program's memory, and the commands that draw from them. A draw that goes
// beyond the bytes that the trace holds is left out: the program would have crashed.

#include "driver/context/current.h"
#include "driver/objects/buffer_object.h"
#include "driver/trace/player/player.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace ffgpu::trace {
namespace {

std::uint64_t positive(const Value& value) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, to_number<std::int64_t>(value)));
}

std::uint64_t largest(const Value& numbers) {
    std::uint64_t most = 0;
    const auto see = [&](const Value& number) { most = std::max(most, positive(number)); };
    if (numbers.kind == ValueKind::Array) {
        Call::for_each(numbers, see);
    } else {
        see(numbers);
    }
    return most;
}

// One more than the largest of the indices; 0 if there are none.
template <class Index>
std::uint64_t vertices_used(std::span<const std::byte> bytes, const GLuint* restart) {
    const auto* const begin = reinterpret_cast<const Index*>(bytes.data());
    const auto* const end = begin + bytes.size() / sizeof(Index);
    if (begin == end) return 0;
    if (!restart) return std::uint64_t{*std::max_element(begin, end)} + 1;
    std::uint64_t used = 0;
    for (const Index* index = begin; index != end; ++index)
        if (*index != *restart) used = std::max(used, std::uint64_t{*index} + 1);
    return used;
}

std::uint64_t vertices_used(std::span<const std::byte> bytes, GLenum type, const GLuint* restart) {
    if (type == GL_UNSIGNED_BYTE) return vertices_used<GLubyte>(bytes, restart);
    if (type == GL_UNSIGNED_SHORT) return vertices_used<GLushort>(bytes, restart);
    return vertices_used<GLuint>(bytes, restart);
}

} // namespace

void TracePlayer::set_array(const GlCommand* command, Call& call) {
    const gl::Context& context = *gl::current_context();
    const Value& pointer = call.argument(call.argument_count() - 1);
    if (pointer.kind != ValueKind::Blob) {
        play_plain(*command, call);
        return;
    }
    Blob copy; // For when the call is played again.
    if (options_.keep_last_frame && !repeats_)
        copy.append(call.blob(pointer).data(), call.blob(pointer).size());
    play_plain(*command, call);
    // An array is told by its command, and the texture unit it is for.
    const auto* const key =
        reinterpret_cast<const char*>(command) + context.client.arrays.active_unit;
    static_assert(sizeof(GlCommand) > TextureUnits);
    if (repeats_) return memory_.borrow_array(context, key, call.blob(pointer));
    memory_.keep_array(context, key, call.blob(pointer));
    if (options_.keep_last_frame) call.blob(pointer).swap(copy);
}

// An array that is enabled but has too little memory is one that the program did not care for, as a
// texture unit's that is off, or whose pointer the tracer did not tell again: what it has is used,
// and zeroes after that. One without any memory is disabled for the draw. (apitrace tells the
// arrays of texture units other than the active one only where GL_MAX_TEXTURE_COORDS is known,
// which OpenGL 1.5 without programs does not have: such a unit keeps an array of an earlier draw.)
void TracePlayer::draw_checked(const GlCommand* command, Call& call, std::uint64_t vertices) {
    gl::VertexArrayObject& object = *gl::current_context()->client.arrays.object;
    if (memory_.vertices_available(object.of(Attribute::Position)) < vertices)
        return warn_once(call.name(),
                         "call " + std::to_string(call.number()) + " " + std::string(call.name()) +
                             ": left out: its arrays have fewer vertices");
    std::array<gl::VertexArray*, Attributes> disabled{};
    std::size_t count = 0;
    for (gl::VertexArray& array : object.arrays) {
        const std::uint64_t available = memory_.vertices_available(array);
        if (available >= vertices) continue;
        if (memory_.extend(array, vertices)) {
            warn_once("a short array",
                      "call " + std::to_string(call.number()) + " " + std::string(call.name()) +
                          ": an array has " + std::to_string(available) + " of " +
                          std::to_string(vertices) +
                          " vertices in the trace, the others read as zero");
            continue;
        }
        array.enabled = false;
        disabled[count++] = &array;
    }
    play_plain(*command, call);
    for (gl::VertexArray* const array : std::span(disabled).first(count))
        array->enabled = true;
}

// glDrawArrays(mode, first, count), glArrayElement(i)
void TracePlayer::draw_arrays(const GlCommand* command, Call& call) {
    const std::size_t count = call.argument_count();
    const std::uint64_t last = count == 1 ? 1 : positive(call.argument(count - 1));
    const std::uint64_t first = positive(call.argument(count == 3 ? 1 : 0));
    draw_checked(command, call, last == 0 ? 0 : first + last);
}

void TracePlayer::multi_draw_arrays(const GlCommand* command, Call& call) {
    draw_checked(command, call, largest(call.argument(1)) + largest(call.argument(2)));
}

// glDrawElements, glDrawRangeElements, glMultiDrawElements and their forms with base vertices.
// Indices in a buffer object are looked at all together, which only a program does that has its
// indices there and its vertices not.
void TracePlayer::draw_elements(const GlCommand* command, Call& call) {
    const gl::VertexArrayState& arrays = gl::current_context()->client.arrays;
    if (!ClientMemory::uses(*arrays.object)) {
        play_plain(*command, call);
        return;
    }
    const auto type = to_number<GLenum>(call.argument("type"));
    const GLuint* const restart = arrays.primitive_restart ? &arrays.restart_index : nullptr;
    std::uint64_t vertices = 0;
    const auto see = [&](const Value& indices) {
        std::span<const std::byte> bytes;
        if (arrays.object->element_buffer) {
            bytes = arrays.object->element_buffer->bytes();
        } else if (indices.kind == ValueKind::Blob) {
            bytes = std::as_const(call).blob(indices).bytes();
        }
        vertices = std::max(vertices, vertices_used(bytes, type, restart));
    };
    const Value& indices = call.argument("indices");
    if (indices.kind == ValueKind::Array) {
        Call::for_each(indices, see);
    } else {
        see(indices);
    }
    draw_checked(command, call, vertices + largest(call.argument("basevertex")));
}

} // namespace ffgpu::trace
