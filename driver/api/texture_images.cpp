// Defining texture images and parts of them from the application's pixels (GL 1.5, 3.8.1, 3.8.2).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/images/pixel_memory.h"
#include "driver/texture/image_upload.h"

namespace ffgpu::gl::api {
namespace {

struct ClientPixels {
    GLenum format, type;
    const void* pixels;
};

void define_image_from(Context& context,
                       unsigned dimensions,
                       GLenum token,
                       ImageDefinition definition,
                       const ClientPixels& client) {
    const auto target = image_target_of(token, dimensions);
    if (!target) return context.error(GL_INVALID_ENUM);
    definition.target = *target;
    const InternalFormat internal = texture_format(definition.internal_format);
    if (internal.base == BaseFormat::None) return context.error(GL_INVALID_VALUE);
    if (const GLenum error = definition_error(definition)) return context.error(error);
    if (const GLenum error = pixels_error(client.format, client.type, internal))
        return context.error(error);
    if (target->proxy) return define_bound_image(context, definition, {});
    if (is_too_large(definition)) return context.error(GL_INVALID_VALUE);

    const auto source = pixel_source(
        context, client.pixels, definition.size, client.format, client.type, dimensions == 3);
    if (!source) return;
    std::vector<std::byte> texels;
    if (source->memory) texels = unpack_texels(*source, context.state.pixel, internal);
    define_bound_image(context, definition, std::move(texels));
}

void change_image_from(Context& context,
                       unsigned dimensions,
                       GLenum token,
                       GLint level,
                       const ImagePart& part,
                       const ClientPixels& client) {
    const auto target = image_target_of(token, dimensions);
    if (!target || target->proxy) return context.error(GL_INVALID_ENUM);
    if (const GLenum error = level_error(*target, level)) return context.error(error);
    TextureObject& texture = bound_texture(context, *target);
    const ImageName name{target->face, static_cast<unsigned>(level)};
    const TextureLevel& image = texture.level(name.face, name.level);
    if (const GLenum error = part_error(image, *target, part)) return context.error(error);
    if (const GLenum error = pixels_error(client.format, client.type, image.format))
        return context.error(error);
    if (part.size.empty()) return;

    const auto source = pixel_source(
        context, client.pixels, part.size, client.format, client.type, dimensions == 3);
    if (!source || !source->memory) return;
    write_texels(context.device_memory(),
                 texture,
                 name,
                 box_of(image, *target, part),
                 unpack_texels(*source, context.state.pixel, image.format));
    finish_image_change(context, texture, name, false);
}

} // namespace

void TexImage1D(Context& context,
                GLenum target,
                GLint level,
                GLint internalformat,
                GLsizei width,
                GLint border,
                GLenum format,
                GLenum type,
                const void* pixels) {
    define_image_from(context,
                      1,
                      target,
                      {{}, level, static_cast<GLenum>(internalformat), {width, 1, 1}, border},
                      {format, type, pixels});
}

void TexImage2D(Context& context,
                GLenum target,
                GLint level,
                GLint internalformat,
                GLsizei width,
                GLsizei height,
                GLint border,
                GLenum format,
                GLenum type,
                const void* pixels) {
    define_image_from(context,
                      2,
                      target,
                      {{}, level, static_cast<GLenum>(internalformat), {width, height, 1}, border},
                      {format, type, pixels});
}

void TexImage3D(Context& context,
                GLenum target,
                GLint level,
                GLint internalformat,
                GLsizei width,
                GLsizei height,
                GLsizei depth,
                GLint border,
                GLenum format,
                GLenum type,
                const void* pixels) {
    define_image_from(
        context,
        3,
        target,
        {{}, level, static_cast<GLenum>(internalformat), {width, height, depth}, border},
        {format, type, pixels});
}

void TexSubImage1D(Context& context,
                   GLenum target,
                   GLint level,
                   GLint xoffset,
                   GLsizei width,
                   GLenum format,
                   GLenum type,
                   const void* pixels) {
    change_image_from(
        context, 1, target, level, {xoffset, 0, 0, {width, 1, 1}}, {format, type, pixels});
}

void TexSubImage2D(Context& context,
                   GLenum target,
                   GLint level,
                   GLint xoffset,
                   GLint yoffset,
                   GLsizei width,
                   GLsizei height,
                   GLenum format,
                   GLenum type,
                   const void* pixels) {
    change_image_from(context,
                      2,
                      target,
                      level,
                      {xoffset, yoffset, 0, {width, height, 1}},
                      {format, type, pixels});
}

void TexSubImage3D(Context& context,
                   GLenum target,
                   GLint level,
                   GLint xoffset,
                   GLint yoffset,
                   GLint zoffset,
                   GLsizei width,
                   GLsizei height,
                   GLsizei depth,
                   GLenum format,
                   GLenum type,
                   const void* pixels) {
    change_image_from(context,
                      3,
                      target,
                      level,
                      {xoffset, yoffset, zoffset, {width, height, depth}},
                      {format, type, pixels});
}

} // namespace ffgpu::gl::api
