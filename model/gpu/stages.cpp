#include "model/gpu/stages.h"

namespace ffgpu {
namespace {

void sample_without_observer(const TextureUnit& unit,
                             TexCoordPlanes& coordinates,
                             const SampleQuads& quads,
                             ColorPlanes& out,
                             TexelFootprints* footprints) {
    sample_scalar(unit, coordinates, quads, out, footprints);
}

} // namespace

constinit const Stages FastStages{
    .shade_vertices = shade_vertices_simd,
    .set_up_triangles = set_up_triangles,
    .cover_tile = cover_tile,
    .cover_tile_samples = cover_tile_samples,
    .cover_windows = cover_windows,
    .pack_quads = pack_quads,
    .smooth_block = smooth_block,
    .interpolate_depth = interpolate_depth,
    .interpolate_sample_depths = interpolate_sample_depths,
    .interpolate_perspective = interpolate_perspective,
    .interpolate_colors = interpolate_colors,
    .interpolate_tex_coords = interpolate_tex_coords,
    .interpolate_directions = interpolate_directions,
    .sample = sample,
    .fragment = &FastFragmentStages,
    .packs_kept_colors = true,
    .passes_over_hidden = true,
    .remembers_clears = true,
};

constinit const Stages ReferenceStages{
    .shade_vertices = shade_vertices_scalar,
    .set_up_triangles = set_up_triangles_scalar,
    .cover_tile = cover_tile_scalar,
    .cover_tile_samples = cover_tile_samples_scalar,
    .cover_windows = cover_windows_scalar,
    .pack_quads = pack_quads_scalar,
    .smooth_block = smooth_block_scalar,
    .interpolate_depth = interpolate_depth_scalar,
    .interpolate_sample_depths = interpolate_sample_depths_scalar,
    .interpolate_perspective = interpolate_perspective_scalar,
    .interpolate_colors = interpolate_colors_scalar,
    .interpolate_tex_coords = interpolate_tex_coords_scalar,
    .interpolate_directions = interpolate_directions_scalar,
    .sample = sample_without_observer,
    .fragment = &ReferenceFragmentStages,
    .packs_kept_colors = false,
    .passes_over_hidden = false,
    .remembers_clears = false,
};

} // namespace ffgpu
