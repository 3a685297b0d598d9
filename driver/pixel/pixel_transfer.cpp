#include "driver/pixel/pixel_transfer.h"

#include "driver/math/conversion.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

constexpr std::array<float, 4> Ones{1, 1, 1, 1};
constexpr std::array<float, 4> Zeros{0, 0, 0, 0};

float look_up_color(const std::vector<float>& map, float value) {
    const double last = static_cast<double>(map.size() - 1);
    return map[static_cast<std::size_t>(clamp_unit(static_cast<double>(value)) * last + 0.5)];
}

// The size of an index map is a power of two.
float look_up_index(const std::vector<float>& map, std::int32_t index) {
    return map[static_cast<std::uint32_t>(index) & (map.size() - 1)];
}

std::int32_t shift_and_offset(const PixelState& transfer, std::int32_t index) {
    const GLint shift = transfer.index_shift;
    std::int64_t value = index;
    if (shift > 31 || shift < -31) {
        value = 0;
    } else {
        value = shift >= 0 ? value * (std::int64_t{1} << shift) : value >> -shift;
    }
    return static_cast<std::int32_t>(value + transfer.index_offset);
}

} // namespace

bool keeps_colors(const PixelState& transfer) {
    return !transfer.map_color && transfer.scale == Ones && transfer.bias == Zeros;
}

bool keeps_depths(const PixelState& transfer) {
    return transfer.depth_scale == 1 && transfer.depth_bias == 0;
}

void transfer_colors(const PixelState& transfer, std::span<PixelColor> row) {
    if (transfer.scale != Ones || transfer.bias != Zeros) {
        for (PixelColor& pixel : row) {
            for (std::size_t i = 0; i < 4; ++i)
                pixel[i] = pixel[i] * transfer.scale[i] + transfer.bias[i];
        }
    }
    if (!transfer.map_color) return;
    constexpr auto First = static_cast<std::size_t>(PixelMapName::RToR);
    for (PixelColor& pixel : row) {
        for (std::size_t i = 0; i < 4; ++i)
            pixel[i] = look_up_color(transfer.maps[First + i], pixel[i]);
    }
}

void transfer_depths(const PixelState& transfer, std::span<double> row) {
    const double scale = static_cast<double>(transfer.depth_scale);
    const double bias = static_cast<double>(transfer.depth_bias);
    for (double& depth : row)
        depth = clamp_unit(depth * scale + bias);
}

void transfer_stencil(const PixelState& transfer, std::span<std::int32_t> row) {
    const std::vector<float>& map = transfer.map(PixelMapName::SToS);
    for (std::int32_t& index : row) {
        index = shift_and_offset(transfer, index);
        if (transfer.map_stencil)
            index = round_to_int(static_cast<double>(look_up_index(map, index)));
    }
}

void transfer_indices(const PixelState& transfer, std::span<std::int32_t> row, PixelColor* colors) {
    constexpr auto First = static_cast<std::size_t>(PixelMapName::IToR);
    for (std::int32_t& index : row) {
        index = shift_and_offset(transfer, index);
        PixelColor& color = *colors++;
        for (std::size_t i = 0; i < 4; ++i)
            color[i] = look_up_index(transfer.maps[First + i], index);
    }
}

} // namespace ffgpu::gl
