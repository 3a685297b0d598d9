// Image: a picture of 8 bits a channel, as files hold it: the top row first.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct Image {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgb; // 3 bytes a pixel

    Image() = default;
    Image(unsigned columns, unsigned rows)
        : width(columns)
        , height(rows)
        , rgb(std::size_t{3} * columns * rows) {}

    std::size_t pixels() const { return std::size_t{width} * height; }
};

constexpr std::size_t MaxImagePixels = std::size_t{1} << 28;

// A PNG, or any file that OpenImageIO reads; alpha is dropped, grey spread. Throws InputError.
Image read_image(const std::string& path);

// The file is there whole or not at all. Throws InputError if it cannot be written.
void write_png(const std::string& path, const Image& image);

} // namespace ffgpu::tools
