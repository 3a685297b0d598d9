// The filter of a texture object: GL_FFGPU_texture_filter (docs/texture_filters.md).

#pragma once

#include "driver/objects/texture_object.h"
#include "model/device/registers/texture.h"

namespace ffgpu::gl {

// What the texture's parameter, or the control panel, asks for and its images allow. The size of a
// table is limited as a texture's is: sources up to 1024 texels wide have a summed-area table, up
// to 2048 x 2048 a rip-map.
TextureFilter filter_in_force(const TextureObject& texture);

// The table that its filter reads; null: it needs none, or has none.
const FilterTable* table_in_force(const TextureObject& texture);

} // namespace ffgpu::gl
