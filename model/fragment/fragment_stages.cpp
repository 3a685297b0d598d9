#include "model/fragment/fragment_stages.h"

#include "model/fragment/alpha_test.h"
#include "model/fragment/color_sum.h"
#include "model/fragment/depth_target.h"

namespace ffgpu {

constinit const FragmentStages FastFragmentStages{
    .run_environment = run_environment,
    .add_secondary = add_secondary,
    .apply_fog = apply_fog,
    .apply_coverage = apply_coverage,
    .alpha_test = alpha_test,
    .test_depth_target = test_depth_target,
    .write_color = write_color,
};

constinit const FragmentStages ReferenceFragmentStages{
    .run_environment = run_environment_scalar,
    .add_secondary = add_secondary_scalar,
    .apply_fog = apply_fog_scalar,
    .apply_coverage = apply_coverage_scalar,
    .alpha_test = alpha_test_scalar,
    .test_depth_target = test_depth_target_scalar,
    .write_color = write_color_scalar,
};

} // namespace ffgpu
