// One probe of the texture: a sample as the minifying or magnifying filter takes it, between two
// levels where the choice says so.

#pragma once

#include "model/texture/filter_witness.h"
#include "model/texture/level_of_detail.h"

namespace ffgpu {

Rgba filter_levels(const TextureUnit& unit,
                   const SampledFragment& fragment,
                   const QuadSampling& quad,
                   const FilterWitness& witness);

} // namespace ffgpu
