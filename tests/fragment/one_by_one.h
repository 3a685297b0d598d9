// The fragment pipe one fragment after the other, each from the samples to its pixels, made of the
// stages' scalar functions: a statement of the pipe's order that knows neither batches nor tables.

#pragma once

#include "model/fragment/fragment_pipe.h"

namespace ffgpu::test {

void early_depth_test_one_by_one(const FragmentPipe& pipe, FragmentBatch& batch);
void shade_one_by_one(const FragmentPipe& pipe, FragmentBatch& batch);
void write_one_by_one(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates);

} // namespace ffgpu::test
