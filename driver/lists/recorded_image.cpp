#include "driver/lists/recorded_image.h"

#include "driver/device_context/device_context.h"
#include "driver/objects/buffer_object.h"
#include "driver/pixel/pixel_format.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ffgpu::gl {

const std::byte* unpack_source(DeviceContext& context, const void* data, std::size_t bytes) {
    const auto& buffer = context.client.buffers.pixel_unpack;
    if (!buffer) return static_cast<const std::byte*>(data);
    return buffer->mapped ? nullptr : buffer->at(reinterpret_cast<std::size_t>(data), bytes);
}

ImageCopy plan_image_copy(DeviceContext& context, const ImageArguments& image, const void* pixels) {
    ImageCopy copy;
    if (image.size.empty() || format_type_error(image.format, image.type) != GL_NO_ERROR)
        return copy;
    const PixelStore& unpack = context.client.pixel_store.unpack;
    copy.source = pixel_layout(unpack, image.size, image.format, image.type, image.three_d);
    copy.pixels = unpack_source(context, pixels, copy.source.end);
    if (!copy.pixels) return copy;

    copy.store = {.swap_bytes = unpack.swap_bytes, .lsb_first = unpack.lsb_first, .alignment = 1};
    const auto width = static_cast<std::size_t>(image.size.width);
    if (image.type == GL_BITMAP) {
        const std::size_t bits = copy.source.first_bit + width;
        copy.row_bytes = (bits + 7) / 8;
        copy.store.skip_pixels = static_cast<GLint>(copy.source.first_bit);
        copy.store.row_length = static_cast<GLint>(bits);
    } else {
        copy.row_bytes = width * pixel_bytes(image.format, image.type);
    }
    copy.rows = static_cast<std::size_t>(image.size.height);
    copy.images = static_cast<std::size_t>(image.size.depth);
    return copy;
}

void record_image(RecordWriter& record, const ImageCopy& copy) {
    std::byte* to = record.array(copy.row_bytes * copy.rows * copy.images, copy.pixels != nullptr);
    if (!copy.pixels) return;
    for (std::size_t z = 0; z < copy.images; ++z) {
        for (std::size_t y = 0; y < copy.rows; ++y, to += copy.row_bytes)
            std::memcpy(to, copy.pixels + copy.source.row(y, z), copy.row_bytes);
    }
}

RecordedUnpack::RecordedUnpack(DeviceContext& context, const PixelStore& store)
    : context_(context)
    , store_(std::exchange(context.client.pixel_store.unpack, store))
    , buffer_(std::exchange(context.client.buffers.pixel_unpack, nullptr)) {}

RecordedUnpack::~RecordedUnpack() {
    context_.client.pixel_store.unpack = store_;
    context_.client.buffers.pixel_unpack = std::move(buffer_);
}

} // namespace ffgpu::gl
