// AddressMap: gives textures and surfaces their places in the explored machine's address space, in
// the layouts of the configuration. Places are handed out in the order of first use and never
// reused; a texture level that the driver writes again gets a new place, so that its next reads are
// compulsory misses, as they are on a real bus.

#pragma once

#include "model/device/registers.h"
#include "model/work/config.h"
#include "model/work/level_lines.h"
#include "model/work/placed_level.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace ffgpu::work {

class AddressMap {
public:
    explicit AddressMap(const TexelCacheShape& textures)
        : texture_shape_(textures) {}

    // The levels of a texture; the reference holds until the next call.
    const std::vector<PlacedLevel>& texture(const TextureImage& image) {
        return placed(image).levels;
    }
    // The same with the lines of the texel cache.
    const TextureLines& texture_lines(const TextureImage& image) { return placed(image); }

    // A colour or depth target, in the layout of its cache; a pixel's samples lie together.
    const PlacedLevel& surface(const Surface& surface, const CacheShape& cache);

    // The driver wrote [at, at + bytes) of device memory.
    void memory_written(std::uint64_t at, std::uint64_t bytes);

private:
    struct Texture : TextureLines {
        TextureImage image;
        std::uint64_t bytes = 0;
    };

    std::uint64_t place(std::uint64_t bytes);
    const Texture& placed(const TextureImage& image);
    PlacedLevel place_level(const TextureImage& image, std::uint32_t level);

    const TexelCacheShape texture_shape_;
    std::map<DeviceAddress, Texture> textures_;
    std::map<std::tuple<DeviceAddress, Format, std::uint32_t, std::uint32_t, std::uint32_t>,
             PlacedLevel>
        surfaces_;
    std::uint64_t next_ = std::uint64_t{1} << 32; // Above all device addresses.
};

} // namespace ffgpu::work
