#include "model/fragment/color_sum.h"

#include "model/fragment/lane_access.h"

namespace ffgpu {

void add_secondary_scalar(FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        set_lane_color(
            batch.color,
            lane,
            add_secondary(lane_color(batch.color, lane), lane_color(batch.secondary, lane)));
}

void apply_coverage_scalar(FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        set_lane_color(batch.color,
                       lane,
                       apply_coverage(lane_color(batch.color, lane), batch.antialias[lane]));
}

} // namespace ffgpu
