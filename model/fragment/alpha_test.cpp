#include "model/fragment/alpha_test.h"

namespace ffgpu {

FragmentMask alpha_test_scalar(const FragmentControl& control, const FragmentBatch& batch) {
    FragmentMask passed;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        if (batch.live.test(lane) && passes_alpha_test(control, batch.color.a[lane]))
            passed.set(lane);
    return passed;
}

} // namespace ffgpu
