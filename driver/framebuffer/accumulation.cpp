#include "driver/framebuffer/accumulation.h"

#include "driver/math/conversion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {
namespace {

constexpr double One = 32767;

std::int16_t saturate(std::int64_t value) {
    return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, -32767, 32767));
}

// Nearest, halves up; what is not a number is 0. Bounded so that sums of two fit.
std::int64_t to_fixed(double value) {
    if (!(value == value)) return 0;
    return static_cast<std::int64_t>(std::floor(std::clamp(value, -4.0, 4.0) * One + 0.5));
}

// The value of each 8-bit colour, times `factor`.
std::array<std::int64_t, 256> scaled_colors(float factor) {
    std::array<std::int64_t, 256> table;
    for (unsigned c = 0; c < 256; ++c)
        table[c] = to_fixed(c / 255.0 * static_cast<double>(factor));
    return table;
}

DeviceAddress pixel_address(const Surface& surface, unsigned x, unsigned y) {
    return surface.address + y * surface.stride + x * format_info(surface.format).block_bytes;
}

bool is_accumulable(Format format) {
    return format == Format::Rgba8 || format == Format::Rgbx8;
}

} // namespace

// change(channel, value, pixel in the row) for the first `pixels` of row y of the area.
template <class Change>
void Accumulation::change_row(unsigned y, unsigned pixels, Change change) {
    const std::size_t first =
        (std::size_t{y} * drawable_.width() + static_cast<unsigned>(area_.x)) * 4;
    std::int16_t* const row = drawable_.accumulation().data() + first;
    for (unsigned i = 0; i < pixels; ++i) {
        for (unsigned channel = 0; channel < 4; ++channel)
            change(channel, row[4 * i + channel], i);
    }
}

template <class Change>
void Accumulation::change(Change change) {
    for (unsigned y = 0; y < area_.height; ++y)
        change_row(static_cast<unsigned>(area_.y) + y, area_.width, change);
}

void Accumulation::clear(const std::array<float, 4>& value) {
    std::array<std::int16_t, 4> fixed;
    for (std::size_t i = 0; i < 4; ++i)
        fixed[i] = saturate(to_fixed(static_cast<double>(value[i])));
    change([&](unsigned channel, std::int16_t& pixel, unsigned) { pixel = fixed[channel]; });
}

void Accumulation::add(float value) {
    const std::int64_t fixed = to_fixed(static_cast<double>(value));
    change([&](unsigned, std::int16_t& pixel, unsigned) { pixel = saturate(pixel + fixed); });
}

void Accumulation::multiply(float factor) {
    const double times = static_cast<double>(factor) / One;
    change([&](unsigned, std::int16_t& pixel, unsigned) {
        pixel = saturate(to_fixed(pixel * times));
    });
}

void Accumulation::load(const Surface& source, float factor) {
    read(source, factor, [](std::int16_t&, std::int64_t color) { return color; });
}

void Accumulation::accumulate(const Surface& source, float factor) {
    read(source, factor, [](std::int16_t& pixel, std::int64_t color) { return pixel + color; });
}

template <class Combine>
void Accumulation::read(const Surface& source, float factor, Combine combine) {
    if (!is_accumulable(source.format)) return;
    const auto x = static_cast<unsigned>(area_.x), bottom = static_cast<unsigned>(area_.y);
    const unsigned width = std::min<unsigned>(x + area_.width, source.width);
    const unsigned top = std::min<unsigned>(bottom + area_.height, source.height);
    if (width <= x) return;
    const std::array<std::int64_t, 256> colors = scaled_colors(factor);
    const bool has_alpha = source.format == Format::Rgba8;
    std::vector<std::byte> row(std::size_t{4} * (width - x));
    for (unsigned y = bottom; y < top; ++y) {
        device_.read_memory(pixel_address(source, x, y), row);
        change_row(y, width - x, [&](unsigned channel, std::int16_t& pixel, unsigned i) {
            const unsigned color =
                channel == 3 && !has_alpha ? 255 : std::to_integer<unsigned>(row[4 * i + channel]);
            pixel = saturate(combine(pixel, colors[color]));
        });
    }
}

void Accumulation::give_back(const Surface& destination, float factor, unsigned write_mask) {
    if (!is_accumulable(destination.format) || area_.width == 0) return;
    const double times = static_cast<double>(factor) / One;
    std::vector<std::byte> row(std::size_t{4} * area_.width);
    const auto x = static_cast<unsigned>(area_.x);
    for (unsigned i = 0; i < area_.height; ++i) {
        const unsigned y = static_cast<unsigned>(area_.y) + i;
        const DeviceAddress address = pixel_address(destination, x, y);
        if (write_mask != 0xf) device_.read_memory(address, row);
        change_row(y, area_.width, [&](unsigned channel, std::int16_t& pixel, unsigned column) {
            if (write_mask >> channel & 1)
                row[4 * column + channel] = static_cast<std::byte>(unorm(pixel * times, 8));
        });
        device_.write_memory(address, row);
    }
}

} // namespace ffgpu::gl
