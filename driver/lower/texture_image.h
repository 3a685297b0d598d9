// A texture object as the image register of a unit.

#pragma once

#include "driver/objects/texture_object.h"
#include "model/device/registers/texture.h"

namespace ffgpu::gl {

// The texture must be resident (driver/texture/residency.h).
TextureImage lower_texture_image(const TextureObject& texture);

} // namespace ffgpu::gl
