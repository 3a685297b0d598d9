#include "driver/trace/player/client_memory.h"

#include "driver/objects/buffer_object.h"
#include "model/base/check.h"

#include <algorithm>
#include <functional>

namespace ffgpu::trace {
namespace {

std::uint64_t component_bytes(GLenum type) {
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT:
        return 2;
    case GL_DOUBLE:
        return 8;
    default:
        return 4;
    }
}

// Bytes of an array's element, and from one to the next.
struct ElementPlaces {
    std::uint64_t element, stride;
};

ElementPlaces element_places(const gl::VertexArray& array) {
    const std::uint64_t element =
        static_cast<std::uint64_t>(array.size) * component_bytes(array.type);
    check(element > 0, "an element of a vertex array has no size");
    return {element, array.stride > 0 ? static_cast<std::uint64_t>(array.stride) : element};
}

std::byte* make_room(Blob& blob, std::size_t bytes) {
    blob.clear();
    blob.pad(std::max<std::size_t>(bytes, 1));
    return blob.data();
}

} // namespace

void ClientMemory::keep_array(const gl::Context& context, const void* array, Blob& blob) {
    Array& kept = arrays_[{&context, array}];
    kept.own.swap(blob);
    kept.borrowed = nullptr;
}

void ClientMemory::borrow_array(const gl::Context& context, const void* array, Blob& blob) {
    arrays_[{&context, array}].borrowed = &blob;
}

Blob* ClientMemory::blob_at(const void* pointer) {
    const auto* const at = static_cast<const std::byte*>(pointer);
    for (auto& [key, array] : arrays_) {
        Blob& blob = array.blob();
        // std::less orders pointers of different objects.
        if (!std::less<>()(at, blob.data()) && std::less<>()(at, blob.data() + blob.size()))
            return &blob;
    }
    return nullptr;
}

std::uint64_t ClientMemory::bytes_from(const void* pointer) const {
    const Blob* const blob = const_cast<ClientMemory*>(this)->blob_at(pointer);
    if (!blob) return 0;
    return blob->size() -
           static_cast<std::uint64_t>(static_cast<const std::byte*>(pointer) - blob->data());
}

bool ClientMemory::extend(gl::VertexArray& array, std::uint64_t vertices) {
    constexpr std::uint64_t Limit = 64 << 20; // bytes
    Blob* const blob = array.enabled && !array.buffer ? blob_at(array.pointer) : nullptr;
    if (!blob || vertices > Limit) return false;
    const auto [element, stride] = element_places(array);
    const auto offset =
        static_cast<std::uint64_t>(static_cast<const std::byte*>(array.pointer) - blob->data());
    const std::uint64_t needed = offset + vertices * stride + element;
    if (needed > Limit) return false;
    blob->pad(needed);
    array.pointer = blob->data() + offset;
    return true;
}

std::uint64_t ClientMemory::vertices_available(const gl::VertexArray& array) const {
    if (!array.enabled || array.buffer) return ~std::uint64_t{0};
    const auto [element, stride] = element_places(array);
    const std::uint64_t bytes = bytes_from(array.pointer);
    return bytes < element ? 0 : (bytes - element) / stride + 1;
}

bool ClientMemory::uses(const gl::VertexArrayObject& object) {
    return std::ranges::any_of(
        object.arrays, [](const gl::VertexArray& array) { return array.enabled && !array.buffer; });
}

void ClientMemory::map(std::uint64_t address, std::shared_ptr<gl::BufferObject> buffer) {
    std::erase_if(mappings_, [&](const auto& mapping) {
        const auto before = mapping.second.lock();
        return !before || !before->mapped || before == buffer;
    });
    if (address != 0 && buffer->mapped) mappings_[address] = buffer;
}

void ClientMemory::write(std::uint64_t address, std::span<const std::byte> bytes) {
    auto mapping = mappings_.upper_bound(address);
    if (mapping == mappings_.begin()) return;
    --mapping;
    const auto buffer = mapping->second.lock();
    if (!buffer || !buffer->mapped) return;
    const std::uint64_t offset = address - mapping->first;
    if (offset >= buffer->map_length) return;
    const std::size_t count = std::min<std::uint64_t>(bytes.size(), buffer->map_length - offset);
    if (std::byte* const to = buffer->at(buffer->map_offset + offset, count))
        std::copy_n(bytes.data(), count, to);
}

GLfloat* ClientMemory::feedback(const gl::Context& context, std::size_t elements) {
    return reinterpret_cast<GLfloat*>(make_room(feedback_[&context], elements * sizeof(GLfloat)));
}

GLuint* ClientMemory::selection(const gl::Context& context, std::size_t elements) {
    return reinterpret_cast<GLuint*>(make_room(selection_[&context], elements * sizeof(GLuint)));
}

} // namespace ffgpu::trace
