#include "tests/gallery/harness/images.h"

#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

constexpr double TwoPi = 2 * std::numbers::pi;

int byte(double value) {
    return static_cast<int>(std::lround(255 * value));
}

// The numerical recipes' generator; its upper bits.
int next(std::uint32_t& state, int below) {
    state = state * 1664525u + 1013904223u;
    return static_cast<int>((state >> 16) % static_cast<std::uint32_t>(below));
}

} // namespace

void Image::set(int x, int y, int red, int green, int blue, int alpha) {
    std::uint8_t* const place = texel(x, y);
    place[0] = static_cast<std::uint8_t>(red);
    place[1] = static_cast<std::uint8_t>(green);
    place[2] = static_cast<std::uint8_t>(blue);
    place[3] = static_cast<std::uint8_t>(alpha);
}

Image random_colours(int size, std::uint32_t seed) {
    Image image(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int red = next(seed, 256), green = next(seed, 256);
            image.set(x, y, red, green, next(seed, 256));
        }
    }
    return image;
}

Image checker(int size, int squares) {
    Image image(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const bool dark = (x * squares / size + y * squares / size) % 2 != 0;
            if (dark)
                image.set(x, y, 40, 50, 110);
            else
                image.set(x, y, 240, 220, 170);
        }
    }
    return image;
}

Image waves(int size) {
    Image image(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double u = TwoPi * (x + 0.5) / size, v = TwoPi * (y + 0.5) / size;
            image.set(x,
                      y,
                      byte(0.5 + 0.5 * std::cos(3 * u)),
                      byte(0.5 + 0.4 * std::sin(2 * v)),
                      byte(0.5 + 0.25 * std::sin(2 * u + 3 * v)));
        }
    }
    return image;
}

Image chart(int size) {
    Image image(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const bool odd = (x * 8 / size + y * 8 / size) % 2 != 0;
            image.set(x, y, byte((x + 0.5) / size), byte((y + 0.5) / size), odd ? 200 : 60);
        }
    }
    return image;
}

Image slide(int size) {
    Image image(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double u = (x + 0.5) / size, v = (y + 0.5) / size;
            const bool frame = u < 0.08 || u > 0.92 || v < 0.08 || v > 0.92;
            const bool bar = std::abs(u - 0.5) < 0.04 || std::abs(v - 0.62) < 0.04;
            if (frame || bar)
                image.set(x, y, 0, 0, 0);
            else
                image.set(x, y, v > 0.62 ? 160 : 90, 120, u < 0.5 ? 40 : 150);
        }
    }
    return image;
}

Image gravel(int size, std::uint32_t seed) {
    Image image(size, size);
    std::vector<double> grey(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.5);
    for (int cell = 1; cell < size; cell *= 2) {
        const int cells = size / cell;
        std::vector<double> values(static_cast<std::size_t>(cells) *
                                   static_cast<std::size_t>(cells));
        for (double& value : values)
            value = (next(seed, 1000) - 499.5) / 999;
        for (int i = 0; i < size * size; ++i) {
            const int x = i % size, y = i / size, around = y / cell * cells + x / cell;
            grey[static_cast<std::size_t>(i)] += 0.3 * values[static_cast<std::size_t>(around)];
        }
    }
    for (int i = 0; i < size * size; ++i) {
        const double value = std::fmin(1, std::fmax(0, grey[static_cast<std::size_t>(i)]));
        image.set(i % size, i / size, byte(value), byte(0.85 * value), byte(0.65 * value));
    }
    return image;
}

} // namespace ffgpu::gallery
