// The fragment pipe's tests and writes where targets have several samples a pixel: what
// fragment_pipe.h's functions do then. A fragment was shaded once; from here on each of its samples
// goes its own way, plane by plane with the stages of single-sampled targets.

#pragma once

#include "model/fragment/fragment_pipe.h"

namespace ffgpu {

void early_depth_test_samples(const FragmentPipe& pipe, FragmentBatch& batch, const ProbeTap* tap);
void write_samples(const FragmentPipe& pipe,
                   FragmentBatch& batch,
                   FragmentFates& fates,
                   const ProbeTap* tap);

} // namespace ffgpu
