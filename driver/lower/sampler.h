// A texture object's parameters as the sampler register of a unit.

#pragma once

#include "driver/objects/texture_object.h"
#include "model/device/registers/texture.h"

namespace ffgpu::gl {

Sampler lower_sampler(const TextureObject& texture, float unit_lod_bias);

// What the texture environment sees: depth textures are read as their depth mode says.
BaseFormat sampled_format(const TextureObject& texture);

} // namespace ffgpu::gl
