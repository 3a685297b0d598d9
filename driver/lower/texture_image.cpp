#include "driver/lower/texture_image.h"

#include "driver/objects/texture_filter.h"

namespace ffgpu::gl {

TextureImage lower_texture_image(const TextureObject& texture) {
    if (const FilterTable* const table = table_in_force(texture))
        return {.shape = table->shape, .address = table->block.address()};
    const TextureChain& chain = texture.chain();
    const TextureObject::Resident& resident = texture.resident;
    const unsigned skipped = chain.base - resident.root; // Levels larger than the base level.

    TextureImage image;
    image.shape = resident.shape;
    image.shape.width = level_size(image.shape.width, skipped);
    image.shape.height = level_size(image.shape.height, skipped);
    image.shape.depth = level_size(image.shape.depth, skipped);
    image.shape.levels = chain.last - chain.base + 1;
    image.address = static_cast<DeviceAddress>(resident.block.address() +
                                               level_layout(resident.shape, skipped).offset);
    image.srgb = chain.srgb;
    return image;
}

} // namespace ffgpu::gl
