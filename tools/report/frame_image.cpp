#include "tools/report/frame_image.h"

namespace ffgpu::tools {
namespace {

// 5 or 6 bits to 8: the top bits again below, so that all ones become 255.
std::uint8_t widen(unsigned value, unsigned bits) {
    const unsigned shifted = value << (8 - bits);
    return static_cast<std::uint8_t>(shifted | shifted >> bits);
}

void convert_565(const std::byte* from, std::uint8_t* to) {
    const unsigned pixel = std::to_integer<unsigned>(from[0]) | std::to_integer<unsigned>(from[1])
                                                                    << 8;
    to[0] = widen(pixel >> 11, 5);
    to[1] = widen(pixel >> 5 & 0x3f, 6);
    to[2] = widen(pixel & 0x1f, 5);
}

void convert_8(const std::byte* from, std::uint8_t* to) {
    for (unsigned c = 0; c < 3; ++c)
        to[c] = std::to_integer<std::uint8_t>(from[c]);
}

} // namespace

Image read_surface(Device& device, const Surface& surface) {
    if (surface.format == Format::None) return {};
    std::vector<std::byte> bytes(std::size_t{surface.stride} * surface.height);
    device.read_memory(surface.address, bytes);
    const std::size_t pixel_bytes = row_bytes(surface.format, 1);
    const auto convert = surface.format == Format::Rgb565 ? convert_565 : convert_8;
    Image image(surface.width, surface.height);
    for (std::size_t y = 0; y < image.height; ++y) {
        const std::byte* from = bytes.data() + surface.stride * (image.height - 1 - y);
        std::uint8_t* to = image.rgb.data() + 3 * image.width * y;
        for (std::size_t x = 0; x < image.width; ++x, from += pixel_bytes, to += 3)
            convert(from, to);
    }
    return image;
}

} // namespace ffgpu::tools
