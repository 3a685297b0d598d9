#include "model/gpu/bin_sequence.h"

#include <algorithm>

namespace ffgpu {

void BinSequence::busy_tiles(std::vector<std::uint32_t>& tiles) const {
    tiles.clear();
    for (const auto& bin : bins)
        tiles.insert(tiles.end(), bin->busy_tiles().begin(), bin->busy_tiles().end());
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

} // namespace ffgpu
