// Texture environments as programs of the combiner (GL 1.5, 3.8.13).

#pragma once

#include "driver/state/texture_state.h"
#include "driver/texel/internal_format.h"
#include "model/device/registers/texture.h"

#include <array>

namespace ffgpu::gl {

// Of each unit what its texture's samples hold; None: the unit is off.
using SampledFormats = std::array<BaseFormat, TextureUnits>;

Combiner
lower_combiner(const TextureEnvironment& environment, unsigned unit, const SampledFormats& formats);

} // namespace ffgpu::gl
