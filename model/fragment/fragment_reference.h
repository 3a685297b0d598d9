// The fragment pipe one fragment after the other, made of the stages' scalar specifications.
// The batch functions of fragment_pipe.h yield the same bits; tests compare the two.

#pragma once

#include "model/fragment/fragment_pipe.h"

namespace ffgpu {

void early_depth_test_reference(const FragmentPipe& pipe, FragmentBatch& batch);
void shade_reference(const FragmentPipe& pipe, FragmentBatch& batch);
void write_reference(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates);

} // namespace ffgpu
