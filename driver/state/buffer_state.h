// The buffer objects that are bound, but for the arrays' own (GL 1.5, 2.9; pixel and copy buffers).
// Null: none (name 0).

#pragma once

#include <memory>

namespace ffgpu::gl {

class BufferObject; // driver/objects/buffer_object.h

struct BufferState {
    std::shared_ptr<BufferObject> array; // GL_CLIENT_VERTEX_ARRAY_BIT; the next *Pointer takes it
    std::shared_ptr<BufferObject> pixel_pack;   // GL_CLIENT_PIXEL_STORE_BIT
    std::shared_ptr<BufferObject> pixel_unpack; // GL_CLIENT_PIXEL_STORE_BIT
    std::shared_ptr<BufferObject> copy_read;    // in no group
    std::shared_ptr<BufferObject> copy_write;
};

} // namespace ffgpu::gl
