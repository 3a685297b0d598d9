// The texture units' registers: image, sampler and combiner of each.

#pragma once

#include "model/device/registers.h"

namespace ffgpu::gl {

class Context;

// Textures in use become resident; a unit whose texture is incomplete is off. Called when Textures
// or Environments are dirty, and before the targets are lowered: a texture may move, and then
// Targets become dirty, as a framebuffer object may draw to it.
void lower_textures(Context& context, Registers& registers);

} // namespace ffgpu::gl
