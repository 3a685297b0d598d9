// What glPushAttrib(GL_TEXTURE_BIT) saves: the units, and the parameters of the textures bound to
// them (GL 1.5, table 6.13).

#pragma once

#include "driver/objects/texture_object.h"

#include <array>

namespace ffgpu::gl {

struct SavedTextures {
    TextureState state;
    std::array<std::array<TextureParameters, TextureTargets>, TextureUnits> parameters;
};

SavedTextures save_textures(const TextureState& state);

// A texture that was deleted meanwhile is not bound again.
void restore_textures(const SavedTextures& saved, TextureState& state);

} // namespace ffgpu::gl
