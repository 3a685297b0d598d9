#include "model/raster/interpolator.h"

namespace ffgpu {

void interpolate_depth(std::span<const BatchRun> runs, FragmentBatch& batch) {
    interpolate_depth_scalar(runs, batch);
}

void interpolate_perspective(std::span<const BatchRun> runs,
                             const FragmentBatch& batch,
                             PerspectivePlanes& perspective) {
    interpolate_perspective_scalar(runs, batch, perspective);
}

void interpolate_colors(const InterpolantLayout& layout,
                        std::span<const BatchRun> runs,
                        const PerspectivePlanes& perspective,
                        FragmentBatch& batch) {
    interpolate_colors_scalar(layout, runs, perspective, batch);
}

void interpolate_tex_coords(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    interpolate_tex_coords_scalar(layout, unit, runs, perspective, batch, out);
}

} // namespace ffgpu
