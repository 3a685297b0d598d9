// glGenerateMipmap (EXT_framebuffer_object, 4.4.7; ARB_framebuffer_object).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/texture/mipmap.h"

namespace ffgpu::gl::api {
namespace {

// The faces of a cube map's base level are equal squares.
bool is_cube_complete(const TextureObject& texture, unsigned level) {
    const TextureLevel& first = texture.level(0, level);
    for (unsigned face = 0; face < texture.faces(); ++face) {
        const TextureLevel& image = texture.level(face, level);
        if (!image.defined() || image.width != first.width || image.height != first.width ||
            image.internal_format != first.internal_format || image.border != first.border) {
            return false;
        }
    }
    return true;
}

} // namespace

void GenerateMipmap(Context& context, GLenum target) {
    const auto wanted = find_texture_target(target);
    if (!wanted || *wanted == TextureTarget::Rectangle) return context.error(GL_INVALID_ENUM);
    TextureObject& texture =
        *context.state.texture.active().bound[static_cast<std::size_t>(*wanted)];
    const GLint base = texture.parameters.base_level;
    if (base < 0 || base >= GLint{MaxTextureLevels}) return;
    if (*wanted == TextureTarget::Cube && !is_cube_complete(texture, static_cast<unsigned>(base)))
        return context.error(GL_INVALID_OPERATION);
    // Stencil indices have no mean.
    if (texture.level(0, static_cast<unsigned>(base)).format.base == BaseFormat::DepthStencil)
        return context.error(GL_INVALID_OPERATION);
    for (unsigned face = 0; face < texture.faces(); ++face)
        generate_mipmaps(context.device_memory(), texture, face);
    mark_textures(context);
}

} // namespace ffgpu::gl::api
