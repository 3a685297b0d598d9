// What the commands that define, change and copy texture images have in common.

#pragma once

#include "driver/texture/image_checks.h"

#include <cstddef>
#include <vector>

namespace ffgpu::gl {

class DeviceContext;

// The texture bound to the active unit's target.
TextureObject& bound_texture(DeviceContext& context, const ImageTarget& target);

// Gives the bound texture's image its size, format and texels (none: undefined). A proxy only
// learns whether that would work. The definition has no errors but its size.
void define_bound_image(DeviceContext& context,
                        const ImageDefinition& definition,
                        std::vector<std::byte> texels);

// To be called after texels of the base level have changed: generates mip maps where the texture
// asks for it. `defined`: sizes or formats may have changed as well.
void finish_image_change(DeviceContext& context,
                         TextureObject& texture,
                         ImageName name,
                         bool defined);

// What lowering depends on has changed in a texture.
void mark_textures(DeviceContext& context);

} // namespace ffgpu::gl
