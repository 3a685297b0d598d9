// ClientMemory: the memory of the traced program that outlives a call: vertex arrays, mapped
// buffers, and where feedback and selection results go.

#pragma once

#include "driver/context/context.h"
#include "driver/gl_types.h"
#include "driver/trace/reader/blob.h"
#include "driver/trace/reader/call.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>

namespace ffgpu::trace {

class ClientMemory {
public:
    // Takes the bytes of a gl*Pointer call, which stay until the same array of the context gets
    // others. `array`: whatever tells one array from another.
    void keep_array(const gl::Context& context, const void* array, Blob& blob);
    // The same of a call that outlives this object and is played again and again: its own bytes.
    void borrow_array(const gl::Context& context, const void* array, Blob& blob);

    // Vertices 0 .. n - 1 can be fetched from the array; a damaged trace's draw may ask for more.
    // No limit for an array that is off, or in a buffer object, which is the driver's business.
    std::uint64_t vertices_available(const gl::VertexArray& array) const;

    // Gives the array zeroes behind its bytes, so that `vertices` of them can be fetched. False
    // where it has no bytes at all, or too many more would be needed.
    bool extend(gl::VertexArray& array, std::uint64_t vertices);

    // Whether an array of the object that is enabled lies in the program's memory.
    static bool uses(const gl::VertexArrayObject& object);

    // The memory at `address` of the traced program is the mapped part of `buffer`, for as long as
    // that is mapped.
    void map(std::uint64_t address, std::shared_ptr<gl::BufferObject> buffer);
    // The program's write to its memory: into the mapping it hits, if any.
    void write(std::uint64_t address, std::span<const std::byte> bytes);

    // Room for glFeedbackBuffer or glSelectBuffer; the one before is given up.
    GLfloat* feedback(const gl::Context& context, std::size_t elements);
    GLuint* selection(const gl::Context& context, std::size_t elements);

private:
    // Bytes from `pointer` to the end of the blob it points into; 0: none.
    std::uint64_t bytes_from(const void* pointer) const;

    Blob* blob_at(const void* pointer);

    struct Array {
        Blob own;
        Blob* borrowed = nullptr; // instead

        Blob& blob() { return borrowed ? *borrowed : own; }
    };
    std::map<std::pair<const gl::Context*, const void*>, Array> arrays_;
    std::map<std::uint64_t, std::weak_ptr<gl::BufferObject>> mappings_; // by traced address
    std::map<const gl::Context*, Blob> feedback_, selection_;
};

} // namespace ffgpu::trace
