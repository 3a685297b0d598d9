// A texture object as the image register of a unit.

#pragma once

#include "driver/objects/texture_object.h"
#include "model/device/registers/texture.h"

namespace ffgpu::gl {

// Of the enabled targets of a unit the one of the highest precedence (GL 1.5, 3.8.15). Null: none.
TextureObject* texture_in_force(const TextureUnit& unit);

// The texture must be resident (driver/texture/residency.h).
TextureImage lower_texture_image(TextureObject& texture);

} // namespace ffgpu::gl
