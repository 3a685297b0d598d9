#include "driver/window_system/x11/convert_rows.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace ffgpu::gl {
namespace {

// What each value of a channel contributes to a pixel.
using Channel = std::array<unsigned long, 256>;

Channel channel(unsigned long mask) {
    Channel table{};
    if (mask == 0) return table;
    const int shift = std::countr_zero(mask);
    const unsigned long largest = mask >> shift;
    for (unsigned long value = 0; value < table.size(); ++value)
        table[value] = (value * largest + 127) / 255 << shift;
    return table;
}

bool is_bgrx(const XImage& image, const Visual& visual) {
    return image.bits_per_pixel == 32 && image.byte_order == LSBFirst &&
           visual.red_mask == 0xff0000 && visual.green_mask == 0xff00 && visual.blue_mask == 0xff;
}

// One loop over words, so that the compiler makes vector code of it.
void convert_bgrx(const std::byte* from, char* to, std::size_t pixels) {
    for (std::size_t i = 0; i < pixels; ++i) {
        std::uint32_t rgbx = 0;
        std::memcpy(&rgbx, from + 4 * i, 4);
        const std::uint32_t bgrx = (rgbx & 0xff) << 16 | (rgbx & 0xff00) | (rgbx >> 16 & 0xff);
        std::memcpy(to + 4 * i, &bgrx, 4);
    }
}

} // namespace

void convert_rows(std::span<const std::byte> rows,
                  std::size_t stride,
                  XImage& to,
                  const Visual& visual) {
    const auto upside_down = [&](int y) {
        return rows.data() + stride * static_cast<std::size_t>(to.height - 1 - y);
    };
    if (is_bgrx(to, visual)) {
        for (int y = 0; y < to.height; ++y)
            convert_bgrx(upside_down(y),
                         to.data + std::ptrdiff_t{y} * to.bytes_per_line,
                         static_cast<std::size_t>(to.width));
        return;
    }
    const Channel red = channel(visual.red_mask), green = channel(visual.green_mask),
                  blue = channel(visual.blue_mask);
    for (int y = 0; y < to.height; ++y) {
        const std::byte* from = upside_down(y);
        for (int x = 0; x < to.width; ++x, from += 4)
            XPutPixel(&to,
                      x,
                      y,
                      red[std::to_integer<unsigned>(from[0])] |
                          green[std::to_integer<unsigned>(from[1])] |
                          blue[std::to_integer<unsigned>(from[2])]);
    }
}

} // namespace ffgpu::gl
