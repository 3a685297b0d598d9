// Vertex arrays and the bindings of buffers (GL 1.5, state tables 6.6 and 6.7).

#include "driver/context/context.h"
#include "driver/get/client_arrays.h"
#include "driver/get/state_variable.h"
#include "driver/objects/buffer_object.h"

#include <array>

namespace ffgpu::gl {
namespace {

GLuint name(const std::shared_ptr<BufferObject>& buffer) {
    return buffer ? buffer->name() : 0;
}

const VertexArray& find(Context& context, GLenum token) {
    return *find_client_array(context.client.arrays, token);
}

// GL_BGRA takes the place of the size where that was given.
StateValue size(Context& context, GLenum token) {
    const VertexArray& array = find(context, token);
    return values::integer(array.bgra ? GL_BGRA : array.size);
}

StateValue type(Context& context, GLenum token) {
    return values::integer(find(context, token).type);
}

StateValue stride(Context& context, GLenum token) {
    return values::integer(find(context, token).stride);
}

StateValue buffer(Context& context, GLenum token) {
    return values::integer(name(find(context, token).buffer));
}

} // namespace

std::span<const StateVariable> array_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_VERTEX_ARRAY_SIZE, size(c, GL_VERTEX_ARRAY)),
        FFGPU_STATE(GL_VERTEX_ARRAY_TYPE, type(c, GL_VERTEX_ARRAY)),
        FFGPU_STATE(GL_VERTEX_ARRAY_STRIDE, stride(c, GL_VERTEX_ARRAY)),
        FFGPU_STATE(GL_VERTEX_ARRAY_BUFFER_BINDING, buffer(c, GL_VERTEX_ARRAY)),
        FFGPU_STATE(GL_NORMAL_ARRAY_TYPE, type(c, GL_NORMAL_ARRAY)),
        FFGPU_STATE(GL_NORMAL_ARRAY_STRIDE, stride(c, GL_NORMAL_ARRAY)),
        FFGPU_STATE(GL_NORMAL_ARRAY_BUFFER_BINDING, buffer(c, GL_NORMAL_ARRAY)),
        FFGPU_STATE(GL_COLOR_ARRAY_SIZE, size(c, GL_COLOR_ARRAY)),
        FFGPU_STATE(GL_COLOR_ARRAY_TYPE, type(c, GL_COLOR_ARRAY)),
        FFGPU_STATE(GL_COLOR_ARRAY_STRIDE, stride(c, GL_COLOR_ARRAY)),
        FFGPU_STATE(GL_COLOR_ARRAY_BUFFER_BINDING, buffer(c, GL_COLOR_ARRAY)),
        FFGPU_STATE(GL_SECONDARY_COLOR_ARRAY_SIZE, size(c, GL_SECONDARY_COLOR_ARRAY)),
        FFGPU_STATE(GL_SECONDARY_COLOR_ARRAY_TYPE, type(c, GL_SECONDARY_COLOR_ARRAY)),
        FFGPU_STATE(GL_SECONDARY_COLOR_ARRAY_STRIDE, stride(c, GL_SECONDARY_COLOR_ARRAY)),
        FFGPU_STATE(GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, buffer(c, GL_SECONDARY_COLOR_ARRAY)),
        FFGPU_STATE(GL_FOG_COORD_ARRAY_TYPE, type(c, GL_FOG_COORD_ARRAY)),
        FFGPU_STATE(GL_FOG_COORD_ARRAY_STRIDE, stride(c, GL_FOG_COORD_ARRAY)),
        FFGPU_STATE(GL_FOG_COORD_ARRAY_BUFFER_BINDING, buffer(c, GL_FOG_COORD_ARRAY)),
        FFGPU_STATE(GL_INDEX_ARRAY_TYPE, type(c, GL_INDEX_ARRAY)),
        FFGPU_STATE(GL_INDEX_ARRAY_STRIDE, stride(c, GL_INDEX_ARRAY)),
        FFGPU_STATE(GL_INDEX_ARRAY_BUFFER_BINDING, buffer(c, GL_INDEX_ARRAY)),
        FFGPU_STATE(GL_TEXTURE_COORD_ARRAY_SIZE, size(c, GL_TEXTURE_COORD_ARRAY)),
        FFGPU_STATE(GL_TEXTURE_COORD_ARRAY_TYPE, type(c, GL_TEXTURE_COORD_ARRAY)),
        FFGPU_STATE(GL_TEXTURE_COORD_ARRAY_STRIDE, stride(c, GL_TEXTURE_COORD_ARRAY)),
        FFGPU_STATE(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, buffer(c, GL_TEXTURE_COORD_ARRAY)),
        FFGPU_STATE(GL_EDGE_FLAG_ARRAY_STRIDE, stride(c, GL_EDGE_FLAG_ARRAY)),
        FFGPU_STATE(GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, buffer(c, GL_EDGE_FLAG_ARRAY)),
        FFGPU_STATE(GL_CLIENT_ACTIVE_TEXTURE, integer(GL_TEXTURE0 + c.client.arrays.active_unit)),
        FFGPU_STATE(GL_VERTEX_ARRAY_BINDING, integer(c.client.arrays.object->name)),
        FFGPU_STATE(GL_ARRAY_BUFFER_BINDING, integer(name(c.client.buffers.array))),
        FFGPU_STATE(GL_ELEMENT_ARRAY_BUFFER_BINDING,
                    integer(name(c.client.arrays.object->element_buffer))),
        FFGPU_STATE(GL_PIXEL_PACK_BUFFER_BINDING, integer(name(c.client.buffers.pixel_pack))),
        FFGPU_STATE(GL_PIXEL_UNPACK_BUFFER_BINDING, integer(name(c.client.buffers.pixel_unpack))),
        FFGPU_STATE(GL_COPY_READ_BUFFER_BINDING, integer(name(c.client.buffers.copy_read))),
        FFGPU_STATE(GL_COPY_WRITE_BUFFER_BINDING, integer(name(c.client.buffers.copy_write))),
        // EXT_vertex_array's number of static elements: none are promised to stay as they are.
        FFGPU_STATE(GL_VERTEX_ARRAY_COUNT_EXT, integer(0)),
        FFGPU_STATE(GL_NORMAL_ARRAY_COUNT_EXT, integer(0)),
        FFGPU_STATE(GL_COLOR_ARRAY_COUNT_EXT, integer(0)),
        FFGPU_STATE(GL_INDEX_ARRAY_COUNT_EXT, integer(0)),
        FFGPU_STATE(GL_TEXTURE_COORD_ARRAY_COUNT_EXT, integer(0)),
        FFGPU_STATE(GL_EDGE_FLAG_ARRAY_COUNT_EXT, integer(0)),
        FFGPU_STATE(GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, integer(c.client.arrays.lock_first)),
        FFGPU_STATE(GL_ARRAY_ELEMENT_LOCK_COUNT_EXT, integer(c.client.arrays.lock_count)),
        FFGPU_STATE(GL_PRIMITIVE_RESTART_NV, boolean(c.client.arrays.primitive_restart)),
        FFGPU_STATE(GL_PRIMITIVE_RESTART_INDEX_NV, integer(c.client.arrays.restart_index)),
    };
    return Table;
}

} // namespace ffgpu::gl
