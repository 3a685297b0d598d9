// The step before textures are lowered: those that the units sample come into device memory.

#pragma once

#include "driver/objects/texture_object.h"

#include <array>

namespace ffgpu::gl {

class DeviceContext;

// By unit; null: the unit is off, or its texture is incomplete or found no room (the error is
// recorded).
using TexturesInUse = std::array<const TextureObject*, TextureUnits>;

// Called when Textures or Environments are dirty, and before the draw target is found: a texture
// may move, and then Targets become dirty, as a framebuffer object may draw to it.
TexturesInUse bring_textures(DeviceContext& context);

} // namespace ffgpu::gl
