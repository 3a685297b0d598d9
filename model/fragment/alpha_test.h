// The alpha test: a fragment whose alpha fails the comparison with the reference dies (GL 1.5,
// 4.1.4). Both are 0 .. 255.

#pragma once

#include "model/device/compare.h"
#include "model/device/registers/fragment.h"
#include "model/packets/fragment_batch.h"

#include <cstdint>

namespace ffgpu {

constexpr bool passes_alpha_test(const FragmentControl& control, std::uint32_t alpha) {
    return !control.alpha_test || compare(control.alpha_compare, alpha, control.alpha_reference);
}

// The fragments of batch.live that pass.
FragmentMask alpha_test(const FragmentControl& control, const FragmentBatch& batch);
FragmentMask alpha_test_scalar(const FragmentControl& control, const FragmentBatch& batch);

} // namespace ffgpu
