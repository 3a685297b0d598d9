// How many elements the array arguments of a recorded command have, where the Khronos registry or
// the parameter's name tells.

#pragma once

#include "driver/commands/command.h"
#include "driver/gl_types.h"

#include <cstdint>

namespace ffgpu::gl {

// Values of a parameter in commands of the form glThing*v(..., pname, params).
constexpr std::int64_t parameter_count(GLenum name) {
    switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_POSITION:
    case GL_LIGHT_MODEL_AMBIENT:
    case GL_FOG_COLOR:
    case GL_TEXTURE_ENV_COLOR:
    case GL_TEXTURE_BORDER_COLOR:
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE:
        return 4;
    case GL_SPOT_DIRECTION:
    case GL_COLOR_INDEXES:
    case GL_POINT_DISTANCE_ATTENUATION:
        return 3;
    default:
        return 1;
    }
}

// Bytes of a name in glCallLists; 0: there is no such type.
constexpr unsigned list_name_bytes(GLenum type) {
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_2_BYTES:
        return 2;
    case GL_3_BYTES:
        return 3;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_4_BYTES:
        return 4;
    default:
        return 0;
    }
}

constexpr std::int64_t call_lists_bytes(GLsizei n, GLenum type, const void*) {
    return std::int64_t{n} * list_name_bytes(type);
}

// Known<Id>: the registry gives the length, which is count(the command's arguments).
template <Command Id>
struct ArrayLength {
    static constexpr bool Known = false;
};

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define GL_ARRAYS(name, parameters, elements)                                                      \
    template <>                                                                                    \
    struct ArrayLength<Command::name> {                                                            \
        static constexpr bool Known = true;                                                        \
        static constexpr std::int64_t count parameters { return elements; }                        \
    };
#include "driver/commands/array_lengths.inc"
#undef GL_ARRAYS
#pragma GCC diagnostic pop

} // namespace ffgpu::gl
