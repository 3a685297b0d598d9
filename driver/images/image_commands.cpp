#include "driver/images/image_commands.h"

#include "driver/device_context/device_context.h"
#include "driver/texture/mipmap.h"

namespace ffgpu::gl {

namespace {

// A proxy takes the image's size and format if such a texture could be had, else nothing. Half of
// the device's memory is left to all else: targets, vertices, other textures.
void define_proxy(DeviceContext& context, const ImageDefinition& definition) {
    const TextureTarget target = definition.target.target;
    TextureObject& proxy = *context.state.texture.proxies[static_cast<std::size_t>(target)];
    TextureLevel level = level_of(definition);
    std::uint64_t bytes = 0;
    const bool fits = !is_too_large(definition);
    if (fits) bytes = box_bytes(level.format.format, whole_box(level));
    const bool possible = fits && bytes * proxy.faces() <= context.device().memory_size() / 2;
    proxy.level(0, static_cast<unsigned>(definition.level)) = possible ? level : TextureLevel{};
}

} // namespace

TextureObject& bound_texture(DeviceContext& context, const ImageTarget& target) {
    return *context.state.texture.active().bound[static_cast<std::size_t>(target.target)];
}

void mark_textures(DeviceContext& context) {
    context.dirty.mark(Dirty::Textures);
    context.dirty.mark(Dirty::Environments);
    if (context.state.framebuffer.draw_object) context.dirty.mark(Dirty::Targets);
}

void finish_image_change(DeviceContext& context,
                         TextureObject& texture,
                         ImageName name,
                         bool defined) {
    const bool generates = texture.parameters.generate_mipmap &&
                           static_cast<GLint>(name.level) == texture.parameters.base_level;
    if (generates) generate_mipmaps(context.device_memory(), texture, name.face);
    if (defined || generates || texture.filter_table.block) mark_textures(context);
}

void define_bound_image(DeviceContext& context,
                        const ImageDefinition& definition,
                        std::vector<std::byte> texels) {
    if (definition.target.proxy) return define_proxy(context, definition);
    TextureObject& texture = bound_texture(context, definition.target);
    const ImageName name{definition.target.face, static_cast<unsigned>(definition.level)};
    define_image(context.device_memory(), texture, name, level_of(definition), std::move(texels));
    finish_image_change(context, texture, name, true);
}

} // namespace ffgpu::gl
