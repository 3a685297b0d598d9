// Texture completeness (GL 1.5, 3.8.10) and the chain of levels that fit together.

#pragma once

#include "driver/objects/texture_object.h"

namespace ffgpu::gl {

// The longest run of consistent levels around the base level, and whether the texture can be used
// with its present filters.
TextureChain find_chain(const TextureObject& texture);

// The token of a minification filter that reads more levels than the base level.
bool is_mipmap_filter(GLenum min_filter);

} // namespace ffgpu::gl
