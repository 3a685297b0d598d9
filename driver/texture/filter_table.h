// The images that a rip-map or a summed-area filter reads in place of the texture's own
// (model/device/filter_tables.h says how they are laid out).

#pragma once

#include "driver/objects/texture_filter.h"
#include "driver/texture/residency.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {

// r g b a bytes, rows without padding.
struct ColorImage {
    std::uint32_t width = 0, height = 0;
    std::vector<std::byte> texels;
};

ColorImage make_rip_map(const ColorImage& source);

// The source is at most 4096 x 4096 texels: no sum exceeds 32 bits.
ColorImage make_summed_area_table(const ColorImage& source);

// Makes the table of a resident texture whose filter needs one, where it is not there or the texels
// changed since. Without room in device memory there is none, and the filter is the standard one.
void bring_filter_table(DeviceMemory memory, TextureObject& texture);

} // namespace ffgpu::gl
