#include "model/gpu/bin_sequence.h"

#include <algorithm>

namespace ffgpu {

std::vector<std::uint32_t> BinSequence::busy_tiles() const {
    std::vector<std::uint32_t> tiles;
    for (const auto& bin : bins)
        tiles.insert(tiles.end(), bin->busy_tiles().begin(), bin->busy_tiles().end());
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    return tiles;
}

} // namespace ffgpu
