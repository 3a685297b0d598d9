// Appends a batch's values to its work, for a work stream with values
// (model/packets/quad_values.h).

#pragma once

#include "model/packets/fragment_batch.h"
#include "model/packets/work_stream.h"

#include <cstddef>
#include <span>

namespace ffgpu {

struct BatchToRecord {
    const Registers& registers;
    const FragmentBatch& fragments; // after the last stage
    const SampleMasks& tested;      // what came to the stencil and depth tests
    std::span<const std::byte> memory;
};

// `work` has its quads.
void record_values(const BatchToRecord& batch, WorkBatch& work);

} // namespace ffgpu
