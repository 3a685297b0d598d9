#include "driver/trace/player/array_sizes.h"

#include "driver/context/context.h"
#include "driver/trace/player/names.h"

#include <algorithm>

namespace ffgpu::trace {
namespace {

using gl::Context;
using gl::PixelStore;

// Factors and sums are cut at HugeArray squared at most, so that nothing overflows.
std::uint64_t size_of(const Call& call, std::size_t argument) {
    const auto size = to_number<std::int64_t>(call.argument(argument));
    return static_cast<std::uint64_t>(
        std::clamp<std::int64_t>(size, 0, static_cast<std::int64_t>(HugeArray)));
}

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    return std::min(std::min(a, HugeArray) * std::min(b, HugeArray), HugeArray);
}

GLenum enum_of(const Call& call, std::size_t argument) {
    return to_number<GLenum>(call.argument(argument));
}

// Of glCallLists' names, of indices, and of pixels' elements.
std::uint64_t type_bytes(GLenum type) {
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
    case GL_UNSIGNED_BYTE_3_3_2:
    case GL_UNSIGNED_BYTE_2_3_3_REV:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_2_BYTES:
    case GL_HALF_FLOAT:
    case GL_UNSIGNED_SHORT_5_6_5:
    case GL_UNSIGNED_SHORT_5_6_5_REV:
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
    case GL_UNSIGNED_SHORT_5_5_5_1:
    case GL_UNSIGNED_SHORT_1_5_5_5_REV:
        return 2;
    case GL_3_BYTES:
        return 3;
    default:
        return 4;
    }
}

bool is_packed(GLenum type) {
    switch (type) {
    case GL_UNSIGNED_BYTE_3_3_2:
    case GL_UNSIGNED_BYTE_2_3_3_REV:
    case GL_UNSIGNED_SHORT_5_6_5:
    case GL_UNSIGNED_SHORT_5_6_5_REV:
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
    case GL_UNSIGNED_SHORT_5_5_5_1:
    case GL_UNSIGNED_SHORT_1_5_5_5_REV:
    case GL_UNSIGNED_INT_8_8_8_8:
    case GL_UNSIGNED_INT_8_8_8_8_REV:
    case GL_UNSIGNED_INT_10_10_10_2:
    case GL_UNSIGNED_INT_2_10_10_10_REV:
    case GL_UNSIGNED_INT_24_8:
        return true;
    default:
        return false;
    }
}

std::uint64_t components(GLenum format) {
    switch (format) {
    case GL_RGBA:
    case GL_BGRA:
    case GL_ABGR_EXT:
        return 4;
    case GL_RGB:
    case GL_BGR:
        return 3;
    case GL_LUMINANCE_ALPHA:
    case GL_RG:
        return 2;
    default:
        return 1;
    }
}

struct Pixels {
    std::uint64_t width, height, depth;
    GLenum format, type;
};

// Up to the last byte of the last row, rounded up to whole rows (GL 1.5, 3.6.4).
std::uint64_t image_bytes(const Pixels& pixels, const PixelStore& store) {
    const auto positive = [](GLint value) {
        return static_cast<std::uint64_t>(std::max(value, 0));
    };
    const std::uint64_t across = store.row_length > 0 ? positive(store.row_length) : pixels.width;
    const std::uint64_t rows =
        store.image_height > 0 ? positive(store.image_height) : pixels.height;
    const std::uint64_t pixel_bytes =
        type_bytes(pixels.type) * (is_packed(pixels.type) ? 1 : components(pixels.format));
    const std::uint64_t unaligned =
        pixels.type == GL_BITMAP ? (across + 7) / 8 : product(across, pixel_bytes);
    const std::uint64_t alignment = std::max<std::uint64_t>(1, positive(store.alignment));
    const std::uint64_t row_bytes = (unaligned + alignment - 1) / alignment * alignment;
    const std::uint64_t skipped =
        positive(store.skip_rows) + product(positive(store.skip_images), rows);
    const std::uint64_t all_rows =
        pixels.depth > 1 ? product(pixels.depth, rows) + pixels.height : pixels.height;
    return product(row_bytes, all_rows + skipped) +
           product(positive(store.skip_pixels), pixel_bytes);
}

// Positions of width, height, depth (or none), format and type among the parameters.
template <int Width, int Height, int Depth, int Format>
std::uint64_t image_size(const Call& call, const Context& context) {
    const auto size = [&](int argument) {
        return argument < 0 ? std::uint64_t{1} : size_of(call, static_cast<std::size_t>(argument));
    };
    return image_bytes({.width = size(Width),
                        .height = size(Height),
                        .depth = size(Depth),
                        .format = enum_of(call, Format),
                        .type = enum_of(call, Format + 1)},
                       context.client.pixel_store.unpack);
}

std::uint64_t read_pixels_size(const Call& call, const Context& context) {
    return image_bytes({.width = size_of(call, 2),
                        .height = size_of(call, 3),
                        .depth = 1,
                        .format = enum_of(call, 4),
                        .type = enum_of(call, 5)},
                       context.client.pixel_store.pack);
}

std::uint64_t bitmap_size(const Call& call, const Context& context) {
    return image_bytes({.width = size_of(call, 0),
                        .height = size_of(call, 1),
                        .depth = 1,
                        .format = GL_COLOR_INDEX,
                        .type = GL_BITMAP},
                       context.client.pixel_store.unpack);
}

std::uint64_t stipple_size(const Call&, const Context& context) {
    return image_bytes(
        {.width = 32, .height = 32, .depth = 1, .format = GL_COLOR_INDEX, .type = GL_BITMAP},
        context.client.pixel_store.unpack);
}

template <std::size_t Argument>
std::uint64_t count(const Call& call, const Context&) {
    return size_of(call, Argument);
}

template <std::size_t Count, std::size_t Type>
std::uint64_t typed_count(const Call& call, const Context&) {
    return product(size_of(call, Count), type_bytes(enum_of(call, Type)));
}

std::uint64_t map1_size(const Call& call, const Context&) {
    return product(size_of(call, 3), size_of(call, 4)) + UsualArraySize;
}

std::uint64_t map2_size(const Call& call, const Context&) {
    return product(size_of(call, 3), size_of(call, 4)) +
           product(size_of(call, 7), size_of(call, 8)) + UsualArraySize;
}

struct Rule {
    std::string_view name; // without a vendor's suffix
    ArraySize size;
};

constexpr Rule Rules[] = {
    {"Bitmap", bitmap_size},
    {"BufferData", count<1>},
    {"BufferSubData", count<2>},
    {"CallLists", typed_count<0, 1>},
    {"CompressedTexImage1D", count<5>},
    {"CompressedTexImage2D", count<6>},
    {"CompressedTexImage3D", count<7>},
    {"CompressedTexSubImage1D", count<5>},
    {"CompressedTexSubImage2D", count<7>},
    {"CompressedTexSubImage3D", count<9>},
    {"DeleteBuffers", count<0>},
    {"DeleteFramebuffers", count<0>},
    {"DeleteQueries", count<0>},
    {"DeleteRenderbuffers", count<0>},
    {"DeleteTextures", count<0>},
    {"DeleteVertexArrays", count<0>},
    {"DrawElements", typed_count<1, 2>},
    {"DrawElementsBaseVertex", typed_count<1, 2>},
    {"DrawPixels", image_size<0, 1, -1, 2>},
    {"DrawRangeElements", typed_count<3, 4>},
    {"DrawRangeElementsBaseVertex", typed_count<3, 4>},
    {"Map1d", map1_size},
    {"Map1f", map1_size},
    {"Map2d", map2_size},
    {"Map2f", map2_size},
    {"MultiDrawArrays", count<3>},
    {"MultiDrawElements", count<4>},
    {"MultiDrawElementsBaseVertex", count<4>},
    {"PixelMapfv", count<1>},
    {"PixelMapuiv", count<1>},
    {"PixelMapusv", count<1>},
    {"PolygonStipple", stipple_size},
    {"PrioritizeTextures", count<0>},
    {"ReadPixels", read_pixels_size},
    {"TexImage1D", image_size<3, -1, -1, 5>},
    {"TexImage2D", image_size<3, 4, -1, 6>},
    {"TexImage3D", image_size<3, 4, 5, 7>},
    {"TexSubImage1D", image_size<3, -1, -1, 4>},
    {"TexSubImage2D", image_size<4, 5, -1, 6>},
    {"TexSubImage3D", image_size<5, 6, 7, 8>},
};

} // namespace

std::uint64_t longest_index_array(const Call& call) {
    std::uint64_t longest = 0;
    const auto see = [&](const Value& value) {
        longest = std::max<std::uint64_t>(longest, to_number<GLuint>(value));
    };
    if (call.argument(1).kind == ValueKind::Array) Call::for_each(call.argument(1), see);
    return product(longest, type_bytes(enum_of(call, 2)));
}

ArraySize find_array_size(std::string_view name) {
    const std::string_view base = without_vendor(name);
    for (const Rule& rule : Rules)
        if (rule.name == base) return rule.size;
    return nullptr;
}

} // namespace ffgpu::trace
