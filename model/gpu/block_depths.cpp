#include "model/gpu/block_depths.h"

#include "model/fragment/depth_target.h"
#include "model/memory/pixel_format.h"
#include "model/raster/coverage.h"

#include <algorithm>

namespace ffgpu {

std::uint32_t
farthest_depth(const Surface& target, unsigned x, unsigned y, std::span<const std::byte> memory) {
    static const FarthestInRows form = choose_farthest_in_rows();
    return form(memory.data() + pixel_place(target, x, y), target.stride, target.format);
}

std::uint32_t farthest_depth_scalar(const Surface& target,
                                    unsigned x,
                                    unsigned y,
                                    std::span<const std::byte> memory) {
    std::uint32_t farthest = 0;
    for (unsigned row = 0; row < BlockSize; ++row)
        for (unsigned column = 0; column < BlockSize; ++column) {
            const std::byte* const at = memory.data() + pixel_place(target, x + column, y + row);
            farthest = std::max(farthest, load_stencil_depth(target.format, at).depth);
        }
    return farthest;
}

} // namespace ffgpu
