// The pictures that the programs put on things, made by formulas. No file is needed.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::gallery {

// RGBA of 8 bits, rows from the bottom, as glTexImage2D takes them.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    Image(int columns, int rows)
        : width(columns)
        , height(rows)
        , rgba(4 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 255) {}

    std::uint8_t* texel(int x, int y) { return rgba.data() + offset(x, y); }
    const std::uint8_t* texel(int x, int y) const { return rgba.data() + offset(x, y); }
    void set(int x, int y, int red, int green, int blue, int alpha = 255);

private:
    std::size_t offset(int x, int y) const {
        return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x));
    }
};

// Each texel a colour of its own.
Image random_colours(int size, std::uint32_t seed);
// squares x squares, in two colours; each texel of one square is alike.
Image checker(int size, int squares);
// Slow waves of red, green and blue, without a seam.
Image waves(int size);
// u as red, v as green, and a blue chequer: where on the picture am I?
Image chart(int size);
// A window with bars on black, for a projector.
Image slide(int size);
// Noise at all scales, periodic: what shows a filter's faults.
Image gravel(int size, std::uint32_t seed);

} // namespace ffgpu::gallery
