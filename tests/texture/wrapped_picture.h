// What the tests of wide filters share: pictures whose texels are found by walking there, and
// single pixels with their footprints.

#pragma once

#include "tests/texture/texture_fixture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::test {

constexpr int BorderTexel = -1;

inline bool clamps(Wrap wrap) {
    return wrap != Wrap::Repeat && wrap != Wrap::MirroredRepeat;
}

// The texel that stands for texel `index` of an axis that is clamped.
inline int clamped(Wrap wrap, int index, int size) {
    const bool mirrors = wrap == Wrap::MirrorClamp || wrap == Wrap::MirrorClampToEdge ||
                         wrap == Wrap::MirrorClampToBorder;
    if (mirrors && index < 0) index = -1 - index;
    if (index >= 0 && index < size) return index;
    if (wrap == Wrap::ClampToEdge || wrap == Wrap::MirrorClampToEdge)
        return index < 0 ? 0 : size - 1;
    return BorderTexel;
}

// GL 1.5, 3.8.7: GL_CLAMP and its mirrored form hold the coordinate, here in texels, in the image.
inline double held(Wrap wrap, double at, int size) {
    if (wrap == Wrap::Clamp) return std::clamp(at, 0.0, double(size));
    if (wrap == Wrap::MirrorClamp) return std::clamp(at, -double(size), double(size));
    return at;
}

// The texel that stands for texel `index`: by walking there, step by step.
inline int walked(Wrap wrap, int index, int size) {
    int at = 0, step = 1;
    if (clamps(wrap)) return clamped(wrap, index, size);
    const int forward = index >= 0 ? 1 : -1;
    if (wrap == Wrap::Repeat) {
        for (int i = 0; i != index; i += forward)
            at = (at + forward + size) % size;
        return at;
    }
    // Mirrored: turn round at each end, where the edge's texel comes twice. Backwards from texel 0
    // stands texel 0 again.
    if (index < 0) index = -1 - index;
    for (int i = 0; i != index; ++i) {
        if (at + step < 0 || at + step >= size) {
            step = -step;
        } else {
            at += step;
        }
    }
    return at;
}

struct Picture {
    int width = 0, height = 0;
    std::vector<std::array<int, 4>> texels;
    std::array<int, 4> border{200, 3, 77, 140};

    // Of the picture itself.
    const std::array<int, 4>& texel(int x, int y) const {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }

    double at(Wrap wrap, int x, int y, unsigned channel) const {
        const int column = walked(wrap, x, width), row = walked(wrap, y, height);
        if (column == BorderTexel || row == BorderTexel) return border[channel];
        return texel(column, row)[channel];
    }
};

inline Picture random_picture(Random& random, int width, int height) {
    Picture picture{.width = width, .height = height, .texels = {}};
    for (int i = 0; i < width * height; ++i) {
        std::array<int, 4> texel{};
        for (int& channel : texel)
            channel = static_cast<int>(below(random, 256));
        picture.texels.push_back(texel);
    }
    return picture;
}

inline std::uint32_t rgba8(const std::array<int, 4>& texel) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i)
        word |= static_cast<std::uint32_t>(texel[i]) << (8 * i);
    return word;
}

// Where a picture begins.
struct PictureCorner {
    unsigned level = 0, x = 0, y = 0;
};

inline void put(const Picture& picture, const PictureCorner& at, TextureMemory& memory) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            memory.put_rgba8(at.level,
                             0,
                             at.x + static_cast<unsigned>(x),
                             at.y + static_cast<unsigned>(y),
                             rgba8(picture.texel(x, y)));
}

// A pixel in texels of level 0: its place, and its steps for a pixel in x and in y.
struct Pixel {
    double u = 0, v = 0, ux = 0, vx = 0, uy = 0, vy = 0;
};

inline Color
sample_pixel(const TextureUnit& unit, const Pixel& pixel, TexelFootprints* footprints) {
    const auto planes = make_planes(1, [&](unsigned lane) {
        const double x = lane % 2, y = lane >> 1;
        return Coordinates{
            static_cast<float>((pixel.u + x * pixel.ux + y * pixel.uy) / unit.size[0]),
            static_cast<float>((pixel.v + x * pixel.vx + y * pixel.vy) / unit.size[1])};
    });
    ColorPlanes out;
    sample(unit, *planes, all_quads(1), out, footprints);
    return color_of(out, 0);
}

// Multiples of 2^-8, which the texture unit keeps exactly in textures of 32 x 16.
inline double place(Random& random, int size) {
    return (static_cast<int>(below(random, static_cast<std::uint32_t>(768 * size))) - 256 * size) /
           256.0;
}

} // namespace ffgpu::test
