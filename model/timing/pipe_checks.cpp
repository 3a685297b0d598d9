#include "model/timing/pipe_checks.h"

#include "model/base/input_error.h"
#include "model/packets/work_stream.h"

#include <string>

namespace ffgpu::timing {
namespace {

void expect(bool holds, const char* what) {
    if (!holds) throw InputError(what);
}

void check_walk(const RasterConfig& raster) {
    if (raster.walk == Walk::Box) return;
    expect(raster.architecture == Architecture::Immediate &&
               raster.granularity == work::Granularity::Quad && raster.quads_per_cycle == 1,
           "raster.walk: tiles are walked by an immediate machine that makes a quad a cycle "
           "(raster.architecture, granularity, quads_per_cycle)");
    expect(raster.traversal == Traversal::Nested && raster.tile_width == PieceBox::BlockWidth,
           "raster.walk: tiles are walked with raster.traversal nested and raster.tile_width 8");
}

void check_past_cache(const TimingConfig& config) {
    expect((config.color_cache.enable && config.depth_cache.enable) ||
               config.raster.architecture == Architecture::Immediate,
           "color_cache.enable, depth_cache.enable: off are of immediate machines "
           "(raster.architecture): a tile's pixels are on the chip");
    expect(config.color_cache.enable || config.raster.quads_per_cycle == 1,
           "color_cache.enable: off is of one pipe (raster.quads_per_cycle 1)");
    expect(config.color_cache.enable || !config.color_blocks.is_on(),
           "color_cache.enable: off leaves color_blocks off");
    if (config.depth_cache.enable) return;
    expect(config.depth.test == work::DepthTest::Late && config.raster.quads_per_cycle == 1,
           "depth_cache.enable: off is of one pipe (raster.quads_per_cycle 1) that tests late "
           "(depth.test)");
    expect(!config.hierarchical_depth.is_on() && !config.depth_blocks.is_on() &&
               !config.color_blocks.is_on(),
           "depth_cache.enable: off leaves hierarchical_depth, depth_blocks and color_blocks off");
}

} // namespace

void check_pipe(const TimingConfig& config) {
    expect(config.raster.architecture == Architecture::Immediate ||
               (config.setup.plane_cycles == 0 && !config.interpolator.is_on()),
           "setup.plane_cycles and interpolator.value_cycles are of immediate machines "
           "(raster.architecture)");
    check_walk(config.raster);
    check_past_cache(config);
    expect(config.texture.rate == TexelRate::Samples || config.texture.units == 1,
           "texture.rate: texels are taken by one unit (texture.units 1)");
}

} // namespace ffgpu::timing
