#include "model/texture/texel_decode.h"

namespace ffgpu {

Rgba decode_color_texel(Format format, const std::byte* at) {
    return unpack_rgba8(load_rgba8(format, at));
}

std::uint32_t decode_depth_texel(Format format, const std::byte* at) {
    std::uint32_t depth = 0;
    load_depth24(format, at, std::span(&depth, 1));
    return depth;
}

} // namespace ffgpu
