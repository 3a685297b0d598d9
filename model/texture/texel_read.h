// One texel of an image: where it lies, or that the border colour stands for it.

#pragma once

#include "model/texture/filter.h"
#include "model/texture/texture_unit.h"

#include <cstdint>

namespace ffgpu {

// A texel after wrapping: x, y, z count from the image's first texel, -1 and the size are border
// texels. z is the slice of a 3-D texture, face the face of a cube map.
struct TexelPlace {
    unsigned level = 0;
    unsigned face = 0;
    std::int32_t x = 0, y = 0, z = 0;
};

// Coordinates as TexelAccess has them: in the stored image, that is, counted from its border if it
// has one; BorderTexel for what only the border colour stands for.
std::uint16_t stored_coordinate(const TextureUnit& unit, std::int32_t index, std::int32_t size);

// Size of a level along an axis.
constexpr std::int32_t level_extent(const TextureUnit& unit, unsigned axis, unsigned level) {
    const std::int32_t size = unit.size[axis] >> level;
    return size < 1 ? 1 : size;
}

// A texel of level 0 of a 2-D image at its stored coordinates; BorderTexel: the border colour.
struct StoredTexel {
    std::uint32_t x = 0, y = 0, layer = 0;
};
Rgba read_stored_texel(const TextureUnit& unit, const StoredTexel& texel, TexelObserver* observer);

// `reference`: the fragment's r as a depth, for comparisons.
Rgba read_texel(const TextureUnit& unit,
                const TexelPlace& place,
                std::uint32_t reference,
                TexelObserver* observer);

} // namespace ffgpu
