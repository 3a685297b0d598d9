// Which bytes of device memory the things that commands name take up, and whether memory has them:
// each rule once, for the validator, for the units that read and write those bytes, and for those
// who follow what is read.

#pragma once

#include "model/device/commands.h"

#include <cstdint>

namespace ffgpu {

constexpr bool lies_within(std::uint64_t at, std::uint64_t bytes, std::uint64_t memory_size) {
    return at <= memory_size && bytes <= memory_size - at;
}

// Every pixel lies in memory and rows do not overlap. The last row need not reach to the next.
constexpr bool surface_fits(const Surface& surface, std::uint64_t memory_size) {
    if (!is_plain_color(surface.format) && !is_depth_target(surface.format)) return false;
    if (surface.width == 0 || surface.height == 0) return false;
    if (surface.samples != 1 && surface.samples != MaxSamples) return false;
    const std::uint64_t row = row_bytes(surface.format, surface.width);
    if (surface.height > 1 && surface.stride < row) return false;
    return surface.address + surface.bytes() - surface.stride + row <= memory_size;
}

constexpr bool texture_fits(const TextureImage& image, std::uint64_t memory_size) {
    return lies_within(image.address, texture_bytes(image.shape), memory_size);
}

// From the first byte of the first row to the last pixel of the last: what lies behind that up to
// the stride is not the image's.
constexpr std::uint64_t image_bytes(const DrawImageCommand& image) {
    if (image.width == 0 || image.height == 0) return 0;
    const std::uint64_t width = image.width;
    const std::uint64_t row = image.format == Format::Bitmap
                                  ? (width + 7) / 8
                                  : width * format_info(image.format).block_bytes;
    return std::uint64_t{image.height - 1} * image.stride + row;
}

constexpr bool is_image_format(Format format) {
    return format == Format::Rgba8 || format == Format::Depth24Stencil8 ||
           format == Format::Bitmap || format == Format::Stencil8;
}

constexpr bool image_fits(const DrawImageCommand& image, std::uint64_t memory_size) {
    return is_image_format(image.format) &&
           lies_within(image.address, image_bytes(image), memory_size);
}

// Whole vertices, the last one too.
constexpr std::uint64_t vertex_bytes(const DrawCommand& draw, const VertexFormat& format) {
    return std::uint64_t{4} * format.stride * draw.vertex_count;
}

constexpr std::uint32_t index_bytes(IndexType type) {
    if (type == IndexType::None) return 0;
    return type == IndexType::U16 ? 2 : 4;
}
constexpr std::uint64_t index_bytes(const DrawCommand& draw) {
    return std::uint64_t{draw.count} * index_bytes(draw.index_type);
}

// feedback_bytes is the size of the whole buffer, so that it has room for the count of bytes in its
// first word, and all of it lies in memory.
constexpr bool feedback_fits(const DrawCommand& draw, std::uint64_t memory_size) {
    return draw.feedback_bytes >= sizeof(std::uint32_t) &&
           lies_within(draw.feedback_address, draw.feedback_bytes, memory_size);
}

} // namespace ffgpu
