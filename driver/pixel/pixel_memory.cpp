#include "driver/pixel/pixel_memory.h"

#include "driver/context/context.h"
#include "driver/objects/buffer_object.h"
#include "driver/pixel/elements.h"
#include "driver/pixel/pixel_format.h"

#include <cstring>
#include <utility>

namespace ffgpu::gl {

namespace {

// Where `offset` lies in the buffer; null, with the error recorded, where it cannot be used.
std::byte* buffer_memory(Context& context,
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

// A row of a bitmap, moved to bit 7 of the first byte, most significant bit first.
void capture_bitmap_row(const PixelSource& source, const std::byte* row, std::byte* to) {
    for (std::size_t x = 0; x < source.width(); ++x) {
        if (bitmap_pixel(source, row, x)) to[x / 8] |= std::byte{0x80} >> static_cast<int>(x % 8);
    }
}

void swap_elements(std::byte* at, std::size_t bytes, unsigned element) {
    for (std::size_t i = 0; i + element <= bytes; i += element) {
        if (element == 2) store_element(at + i, load_element<std::uint16_t>(at + i, true), false);
        if (element == 4) store_element(at + i, load_element<std::uint32_t>(at + i, true), false);
    }
}

} // namespace

std::optional<const std::byte*>
source_memory(Context& context, const void* pixels, std::uint64_t bytes, unsigned alignment) {
    BufferObject* const buffer = context.client.buffers.pixel_unpack.get();
    if (!buffer) return static_cast<const std::byte*>(pixels);
    const auto offset = reinterpret_cast<std::uintptr_t>(pixels);
    const std::byte* const memory = buffer_memory(context, *buffer, offset, bytes, alignment);
    return memory ? std::optional(memory) : std::nullopt;
}

std::optional<std::byte*>
destination_memory(Context& context, void* pixels, std::uint64_t bytes, unsigned alignment) {
    BufferObject* const buffer = context.client.buffers.pixel_pack.get();
    if (!buffer) return static_cast<std::byte*>(pixels);
    const auto offset = reinterpret_cast<std::uintptr_t>(pixels);
    std::byte* const memory = buffer_memory(context, *buffer, offset, bytes, alignment);
    return memory ? std::optional(memory) : std::nullopt;
}

std::optional<PixelSource> pixel_source(Context& context,
                                        const void* pixels,
                                        ImageSize size,
                                        GLenum format,
                                        GLenum type,
                                        bool three_d) {
    PixelSource source(pixels, context.client.pixel_store.unpack, size, format, type, three_d);
    const auto memory = source_memory(context, pixels, source.layout.end, type_bytes(type));
    if (!memory) return std::nullopt;
    source.memory = *memory;
    return source;
}

std::optional<PixelDestination> pixel_destination(
    Context& context, void* pixels, ImageSize size, GLenum format, GLenum type, bool three_d) {
    PixelDestination destination(
        pixels, context.client.pixel_store.pack, size, format, type, three_d);
    const auto memory =
        destination_memory(context, pixels, destination.layout.end, type_bytes(type));
    if (!memory) return std::nullopt;
    destination.memory = *memory;
    return destination;
}

std::vector<std::byte> capture_pixels(Context& context,
                                      const void* pixels,
                                      ImageSize size,
                                      GLenum format,
                                      GLenum type,
                                      bool three_d) {
    if (size.empty() || format_type_error(format, type) != GL_NO_ERROR) return {};
    const auto source = pixel_source(context, pixels, size, format, type, three_d);
    if (!source || !source->memory) return {};
    const PixelLayout tight = pixel_layout(TightStore, size, format, type, three_d);
    std::vector<std::byte> copy(tight.end);
    for (GLsizei z = 0; z < size.depth; ++z) {
        for (GLsizei y = 0; y < size.height; ++y) {
            std::byte* const to = copy.data() + tight.row(static_cast<std::uint64_t>(y),
                                                          static_cast<std::uint64_t>(z));
            if (type == GL_BITMAP)
                capture_bitmap_row(*source, source->row(y, z), to);
            else
                std::memcpy(to, source->row(y, z), source->width() * pixel_bytes(format, type));
        }
    }
    if (source->swap_bytes && type != GL_BITMAP)
        swap_elements(copy.data(), copy.size(), type_bytes(type));
    return copy;
}

TightUnpackScope::TightUnpackScope(Context& context)
    : context_(context)
    , store_(std::exchange(context.client.pixel_store.unpack, TightStore))
    , buffer_(std::exchange(context.client.buffers.pixel_unpack, nullptr)) {}

TightUnpackScope::~TightUnpackScope() {
    context_.client.pixel_store.unpack = store_;
    context_.client.buffers.pixel_unpack = std::move(buffer_);
}

} // namespace ffgpu::gl
