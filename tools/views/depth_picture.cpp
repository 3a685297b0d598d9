#include "tools/views/depth_picture.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <vector>

namespace ffgpu::tools {
namespace {

constexpr double FurthestGrey = 48;

struct Planes { // the top row first
    std::vector<std::uint32_t> depth, stencil;
    std::uint32_t far = 0;
};

Planes read_planes(Device& device, const Surface& target) {
    const std::uint32_t pixel_bytes = row_bytes(target.format, 1);
    std::vector<std::byte> bytes(std::size_t{target.stride} * target.height);
    device.read_memory(target.address, bytes); // plane 0 of several
    Planes planes;
    planes.far = target.format == Format::Depth16 ? 0xffff : 0xffffff;
    for (unsigned row = 0; row < target.height; ++row) {
        const std::byte* from = bytes.data() + target.stride * (target.height - 1u - row);
        for (unsigned x = 0; x < target.width; ++x, from += pixel_bytes) {
            std::uint32_t value = 0;
            std::memcpy(&value, from, pixel_bytes);
            const bool has_stencil = target.format == Format::Depth24Stencil8;
            planes.depth.push_back(has_stencil ? value >> 8 : value);
            planes.stencil.push_back(has_stencil ? value & 0xff : 0);
        }
    }
    return planes;
}

Image grey_picture(const Surface& target,
                   const std::vector<std::uint32_t>& values,
                   const std::function<double(std::uint32_t)>& grey) {
    Image image(target.width, target.height);
    for (std::size_t i = 0; i < values.size(); ++i)
        std::fill_n(&image.rgb[3 * i], 3, static_cast<std::uint8_t>(grey(values[i]) + 0.5));
    return image;
}

} // namespace

Image depth_picture(Device& device, const Surface& target) {
    const Planes planes = read_planes(device, target);
    std::uint32_t nearest = planes.far, furthest = 0;
    for (const std::uint32_t depth : planes.depth) {
        nearest = std::min(nearest, depth);
        if (depth != planes.far) furthest = std::max(furthest, depth);
    }
    return grey_picture(target, planes.depth, [&](std::uint32_t depth) {
        if (depth == planes.far) return 0.0;
        if (nearest == furthest) return 255.0;
        return 255 - (255 - FurthestGrey) * (depth - nearest) / (furthest - nearest);
    });
}

Image stencil_picture(Device& device, const Surface& target) {
    const Planes planes = read_planes(device, target);
    const std::uint32_t most =
        planes.stencil.empty() ? 0 : *std::ranges::max_element(planes.stencil);
    return grey_picture(target, planes.stencil, [most](std::uint32_t value) {
        return most == 0 ? 0.0 : 255.0 * value / most;
    });
}

} // namespace ffgpu::tools
