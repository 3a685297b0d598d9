#include "driver/trace/player/array_sizes.h"

#include "driver/context/context.h"
#include "driver/lists/array_length.h"
#include "driver/pixel/pixel_format.h"
#include "driver/pixel/pixel_layout.h"
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

std::uint64_t image_bytes(
    const PixelStore& store, gl::ImageSize size, GLenum format, GLenum type, bool three_d = false) {
    const std::uint64_t end = gl::pixel_layout(store, size, format, type, three_d).end;
    return std::min(end, HugeArray);
}

// Positions of width, height, depth (or none), format and type among the parameters.
template <int Width, int Height, int Depth, int Format>
std::uint64_t image_size(const Call& call, const Context& context) {
    const auto size = [&](int argument) {
        return argument < 0 ? GLsizei{1}
                            : to_number<GLsizei>(call.argument(static_cast<std::size_t>(argument)));
    };
    return image_bytes(context.client.pixel_store.unpack,
                       {size(Width), size(Height), size(Depth)},
                       enum_of(call, Format),
                       enum_of(call, Format + 1),
                       Depth >= 0);
}

std::uint64_t read_pixels_size(const Call& call, const Context& context) {
    return image_bytes(
        context.client.pixel_store.pack,
        {to_number<GLsizei>(call.argument(2)), to_number<GLsizei>(call.argument(3)), 1},
        enum_of(call, 4),
        enum_of(call, 5));
}

std::uint64_t bitmap_size(const Call& call, const Context& context) {
    return image_bytes(
        context.client.pixel_store.unpack,
        {to_number<GLsizei>(call.argument(0)), to_number<GLsizei>(call.argument(1)), 1},
        GL_COLOR_INDEX,
        GL_BITMAP);
}

std::uint64_t stipple_size(const Call&, const Context& context) {
    return image_bytes(context.client.pixel_store.unpack, {32, 32, 1}, GL_COLOR_INDEX, GL_BITMAP);
}

template <std::size_t Argument>
std::uint64_t count(const Call& call, const Context&) {
    return size_of(call, Argument);
}

template <std::size_t Count, std::size_t Type>
std::uint64_t typed_count(const Call& call, const Context&) {
    return product(size_of(call, Count), gl::type_bytes(enum_of(call, Type)));
}

std::uint64_t list_names_size(const Call& call, const Context&) {
    return product(size_of(call, 0), gl::list_name_bytes(enum_of(call, 1)));
}

std::uint64_t map1_size(const Call& call, const Context&) {
    return product(size_of(call, 3), size_of(call, 4)) + UsualArraySize;
}

std::uint64_t map2_size(const Call& call, const Context&) {
    return product(size_of(call, 3), size_of(call, 4)) +
           product(size_of(call, 7), size_of(call, 8)) + UsualArraySize;
}

// No vertex's attribute has more components.
std::uint64_t components(const Call&, const Context&) {
    return 4;
}

// Vertex3fv, Color4ubv, Normal3fVertex3fv, ..: a number of components, their type, and a v.
bool reads_components(std::string_view name) {
    const std::size_t digit = name.find_last_of("1234");
    return name.ends_with("v") && digit != std::string_view::npos &&
           name.find_first_not_of("bdfisu", digit + 1) == name.size() - 1;
}

struct Rule {
    std::string_view name; // without a vendor's suffix
    ArraySize size;
};

constexpr Rule Rules[] = {
    {"Bitmap", bitmap_size},
    {"BufferData", count<1>},
    {"BufferSubData", count<2>},
    {"CallLists", list_names_size},
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
    return product(longest, gl::type_bytes(enum_of(call, 2)));
}

ArraySize find_array_size(std::string_view name) {
    const std::string_view base = without_vendor(name);
    for (const Rule& rule : Rules)
        if (rule.name == base) return rule.size;
    return reads_components(base) ? components : nullptr;
}

} // namespace ffgpu::trace
