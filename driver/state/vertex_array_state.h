// Vertex arrays (GL 1.5, 2.8; state tables 6.6 and 6.7). All of it is GL_CLIENT_VERTEX_ARRAY_BIT.

#pragma once

#include "driver/gl_types.h"
#include "model/device/registers/vertex.h"

#include <array>
#include <memory>

namespace ffgpu::gl {

class BufferObject; // driver/objects/buffer_object.h

// What a gl*Pointer command set.
struct VertexArray {
    bool enabled = false;
    bool bgra = false; // the size was GL_BGRA (EXT_vertex_array_bgra): four bytes b g r a
    bool normalized = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0;            // as given; 0: the elements follow each other
    const void* pointer = nullptr; // with a buffer: an offset
    std::shared_ptr<BufferObject> buffer{};
};

// The arrays of a vertex array object. Name 0, the default object, is one like the others.
struct VertexArrayObject {
    GLuint name = 0;
    std::array<VertexArray, Attributes> arrays = initial_arrays();
    VertexArray color_index = {.size = 1};
    std::shared_ptr<BufferObject> element_buffer;

    VertexArray& of(Attribute attribute) { return arrays[static_cast<std::size_t>(attribute)]; }
    const VertexArray& of(Attribute attribute) const {
        return arrays[static_cast<std::size_t>(attribute)];
    }

    static std::array<VertexArray, Attributes> initial_arrays() {
        std::array<VertexArray, Attributes> all{};
        const auto size = [&](Attribute attribute, GLint components) {
            all[static_cast<std::size_t>(attribute)].size = components;
        };
        size(Attribute::Normal, 3);
        size(Attribute::SecondaryColor, 3);
        size(Attribute::FogCoordinate, 1);
        size(Attribute::EdgeFlag, 1);
        all[static_cast<std::size_t>(Attribute::EdgeFlag)].type = GL_UNSIGNED_BYTE;
        return all;
    }
};

struct VertexArrayState {
    std::shared_ptr<VertexArrayObject> object = std::make_shared<VertexArrayObject>(); // never null
    GLuint active_unit = 0;         // glClientActiveTexture
    bool primitive_restart = false; // NV_primitive_restart
    GLuint restart_index = 0;
    GLint lock_first = 0; // EXT_compiled_vertex_array; count 0: not locked
    GLsizei lock_count = 0;

    VertexArray& of(Attribute attribute) { return object->of(attribute); }
    const VertexArray& of(Attribute attribute) const { return object->of(attribute); }
};

// What glPushClientAttrib keeps: the binding, and what the bound object held.
struct SavedVertexArrays {
    VertexArrayState state;
    VertexArrayObject contents;
};

inline SavedVertexArrays save(const VertexArrayState& state) {
    return {state, *state.object};
}

inline void restore(VertexArrayState& state, const SavedVertexArrays& saved) {
    state = saved.state;
    *state.object = saved.contents;
}

} // namespace ffgpu::gl
