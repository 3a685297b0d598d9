#include "tests/experiments/figures/miss_machine.h"

namespace ffgpu::experiments {

work::WorkConfig MissMachine::config() const {
    work::WorkConfig config;
    config.raster.granularity = granularity;
    config.raster.traversal = order.traversal;
    config.raster.tile_width = order.tile;
    config.texel_cache.layout = placing.layout;
    config.texel_cache.block_width = placing.block;
    config.texel_cache.line_bytes = line_bytes;
    return config;
}

} // namespace ffgpu::experiments
