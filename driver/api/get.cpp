// State queries (GL 1.5, 6.1.1, 6.1.2 and 6.1.11) and glGetError (2.5).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/get/client_arrays.h"
#include "driver/get/state_variable.h"
#include "driver/math/conversion.h"

#include <cstdint>

namespace ffgpu::gl::api {
namespace {

using Kind = StateValue::Kind;

GLint to_int(Kind kind, double value) {
    switch (kind) {
    case Kind::Normalized:
        return int_from_normalized(value);
    case Kind::Real:
        return round_to_int(value);
    default: // Masks are unsigned: their bits stay.
        return static_cast<GLint>(static_cast<std::uint32_t>(static_cast<std::int64_t>(value)));
    }
}

// Writes the variable, each value as `convert` makes it.
template <class Result, class Convert>
void get(Context& context, GLenum name, Result* result, Convert convert) {
    const StateValue value = find_state(context, name);
    if (value.count == 0) return context.error(GL_INVALID_ENUM);
    for (std::size_t i = 0; i < value.count; ++i)
        result[i] = convert(value.kind, value.values[i]);
}

GLenum array_of_pointer(GLenum pointer) {
    switch (pointer) {
    case GL_VERTEX_ARRAY_POINTER:
        return GL_VERTEX_ARRAY;
    case GL_NORMAL_ARRAY_POINTER:
        return GL_NORMAL_ARRAY;
    case GL_COLOR_ARRAY_POINTER:
        return GL_COLOR_ARRAY;
    case GL_SECONDARY_COLOR_ARRAY_POINTER:
        return GL_SECONDARY_COLOR_ARRAY;
    case GL_FOG_COORD_ARRAY_POINTER:
        return GL_FOG_COORD_ARRAY;
    case GL_INDEX_ARRAY_POINTER:
        return GL_INDEX_ARRAY;
    case GL_TEXTURE_COORD_ARRAY_POINTER:
        return GL_TEXTURE_COORD_ARRAY;
    case GL_EDGE_FLAG_ARRAY_POINTER:
        return GL_EDGE_FLAG_ARRAY;
    default:
        return GL_NONE;
    }
}

} // namespace

void GetBooleanv(Context& context, GLenum pname, GLboolean* data) {
    get(context, pname, data, [](Kind, double value) -> GLboolean {
        return value != 0 ? GL_TRUE : GL_FALSE;
    });
}

void GetIntegerv(Context& context, GLenum pname, GLint* data) {
    get(context, pname, data, to_int);
}

void GetFloatv(Context& context, GLenum pname, GLfloat* data) {
    get(context, pname, data, [](Kind, double value) { return static_cast<GLfloat>(value); });
}

void GetDoublev(Context& context, GLenum pname, GLdouble* data) {
    get(context, pname, data, [](Kind, double value) { return value; });
}

void GetPointerv(Context& context, GLenum pname, void** params) {
    const auto hand_out = [&](const void* pointer) { *params = const_cast<void*>(pointer); };
    if (pname == GL_FEEDBACK_BUFFER_POINTER)
        return hand_out(context.render_modes().feedback.buffer());
    if (pname == GL_SELECTION_BUFFER_POINTER)
        return hand_out(context.render_modes().selection.buffer());
    const VertexArray* const array =
        find_client_array(context.client.arrays, array_of_pointer(pname));
    if (!array) return context.error(GL_INVALID_ENUM);
    hand_out(array->pointer);
}

GLenum GetError(Context& context) {
    return context.take_error();
}

} // namespace ffgpu::gl::api
