// GL's tokens for textures and their images.

#pragma once

#include "driver/gl_types.h"
#include "driver/state/texture_state.h"

#include <cstdint>
#include <optional>

namespace ffgpu::gl {

constexpr unsigned CubeFaces = 6;

// What glBindTexture and glTexParameter take.
std::optional<TextureTarget> find_texture_target(GLenum token);

// What glTexImage*, glGetTexImage ... take: a face of a cube map, or a proxy.
struct ImageTarget {
    TextureTarget target = TextureTarget::TwoD;
    unsigned face = 0;
    bool proxy = false;
    unsigned dimensions = 2; // of the glTexImage that defines it
};

std::optional<ImageTarget> find_image_target(GLenum token);

GLenum texture_token(TextureTarget target); // GL_TEXTURE_2D ...

// The largest size of level 0, in texels without border, and how many levels there may be.
std::uint32_t max_texture_size(TextureTarget target);
unsigned max_texture_levels(TextureTarget target);

} // namespace ffgpu::gl
