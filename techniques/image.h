// What the techniques read and make: fields of real numbers, and texels as glTexImage takes them.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::techniques {

// One real number a texel, rows from the bottom. It repeats: any index names a texel.
struct Field {
    int width = 0, height = 0;
    std::vector<double> values;

    Field(int columns, int rows, double value = 0)
        : width(columns)
        , height(rows)
        , values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

    double& at(int x, int y) { return values[index(x, y)]; }
    double at(int x, int y) const { return values[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        const int column = (x % width + width) % width;
        const int row = (y % height + height) % height;
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

// 8 bits a channel, tightly packed (GL_UNPACK_ALIGNMENT 1), rows from the bottom, slice after
// slice.
struct Texels {
    int width = 0, height = 0, depth = 1, channels = 3;
    std::vector<std::uint8_t> bytes;
};

// Of [0, 1] to the nearest of 0 .. 255; clamped, and a NaN is 0.
inline std::uint8_t to_byte(double value) {
    if (!(value > 0)) return 0;
    return static_cast<std::uint8_t>(std::floor(std::min(value, 1.0) * 255 + 0.5));
}

// One channel: low becomes 0, high 255.
inline Texels to_texels(const Field& field, double low = 0, double high = 1) {
    Texels texels{field.width, field.height, 1, 1, {}};
    texels.bytes.reserve(field.values.size());
    for (const double value : field.values)
        texels.bytes.push_back(to_byte((value - low) / (high - low)));
    return texels;
}

} // namespace ffgpu::techniques
