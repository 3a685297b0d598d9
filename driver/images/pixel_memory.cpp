#include "driver/images/pixel_memory.h"

#include "driver/device_context/device_context.h"
#include "driver/objects/buffer_object.h"
#include "driver/pixel/pixel_format.h"

namespace ffgpu::gl {

namespace {

// Where `offset` lies in the buffer; null, with the error recorded, where it cannot be used.
std::byte* buffer_memory(DeviceContext& context,
                         BufferObject& buffer,
                         std::uintptr_t offset,
                         std::uint64_t bytes,
                         unsigned alignment) {
    std::byte* const memory = buffer.at(offset, bytes);
    if (buffer.mapped || !memory || offset % alignment != 0) {
        context.error(GL_INVALID_OPERATION);
        return nullptr;
    }
    return memory;
}

// What no machine has: refused before sizes computed from it can wrap around.
bool is_beyond_memory(DeviceContext& context, const PixelLayout& layout) {
    constexpr std::uint64_t Limit = std::uint64_t{1} << 40;
    if (layout.end <= Limit) return false;
    context.error(GL_OUT_OF_MEMORY);
    return true;
}

} // namespace

std::optional<const std::byte*>
source_memory(DeviceContext& context, const void* pixels, std::uint64_t bytes, unsigned alignment) {
    BufferObject* const buffer = context.client.buffers.pixel_unpack.get();
    if (!buffer) return static_cast<const std::byte*>(pixels);
    const auto offset = reinterpret_cast<std::uintptr_t>(pixels);
    const std::byte* const memory = buffer_memory(context, *buffer, offset, bytes, alignment);
    return memory ? std::optional(memory) : std::nullopt;
}

std::optional<std::byte*>
destination_memory(DeviceContext& context, void* pixels, std::uint64_t bytes, unsigned alignment) {
    BufferObject* const buffer = context.client.buffers.pixel_pack.get();
    if (!buffer) return static_cast<std::byte*>(pixels);
    const auto offset = reinterpret_cast<std::uintptr_t>(pixels);
    std::byte* const memory = buffer_memory(context, *buffer, offset, bytes, alignment);
    return memory ? std::optional(memory) : std::nullopt;
}

std::optional<PixelSource> pixel_source(DeviceContext& context,
                                        const void* pixels,
                                        ImageSize size,
                                        GLenum format,
                                        GLenum type,
                                        bool three_d) {
    PixelSource source(pixels, context.client.pixel_store.unpack, size, format, type, three_d);
    if (is_beyond_memory(context, source.layout)) return std::nullopt;
    const auto memory = source_memory(context, pixels, source.layout.end, type_bytes(type));
    if (!memory) return std::nullopt;
    source.memory = *memory;
    return source;
}

std::optional<PixelDestination> pixel_destination(DeviceContext& context,
                                                  void* pixels,
                                                  ImageSize size,
                                                  GLenum format,
                                                  GLenum type,
                                                  bool three_d) {
    PixelDestination destination(
        pixels, context.client.pixel_store.pack, size, format, type, three_d);
    if (is_beyond_memory(context, destination.layout)) return std::nullopt;
    const auto memory =
        destination_memory(context, pixels, destination.layout.end, type_bytes(type));
    if (!memory) return std::nullopt;
    destination.memory = *memory;
    return destination;
}

} // namespace ffgpu::gl
