// Texture images in S3TC blocks (GL 1.5, 3.8.3; EXT_texture_compression_s3tc). The blocks go to the
// device as they are.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/images/pixel_memory.h"

#include <cstring>

namespace ffgpu::gl::api {
namespace {

struct Blocks {
    GLsizei bytes;
    const void* data;
};

std::size_t blocks_bytes(Format format, ImageSize size) {
    return box_bytes(format,
                     {.width = static_cast<std::uint32_t>(size.width),
                      .height = static_cast<std::uint32_t>(size.height),
                      .depth = static_cast<std::uint32_t>(size.depth)});
}

void define_compressed(Context& context,
                       unsigned dimensions,
                       GLenum token,
                       ImageDefinition definition,
                       const Blocks& blocks) {
    const auto target = image_target_of(token, dimensions);
    if (!target || !is_specific_compressed(definition.internal_format))
        return context.error(GL_INVALID_ENUM);
    definition.target = *target;
    if (const GLenum error = definition_error(definition)) {
        return context.error(definition.border != 0 ? GL_INVALID_VALUE : error);
    }
    if (!target->proxy && is_too_large(definition)) return context.error(GL_INVALID_VALUE);
    if (target->proxy) return define_bound_image(context, definition, {});
    const std::size_t bytes =
        blocks_bytes(texture_format(definition.internal_format).format, definition.size);
    if (blocks.bytes < 0 || static_cast<std::size_t>(blocks.bytes) != bytes)
        return context.error(GL_INVALID_VALUE);
    const auto memory = source_memory(context, blocks.data, bytes, 1);
    if (!memory) return;
    std::vector<std::byte> texels;
    if (*memory) texels.assign(*memory, *memory + bytes);
    define_bound_image(context, definition, std::move(texels));
}

void change_compressed(Context& context,
                       unsigned dimensions,
                       GLenum token,
                       GLint level,
                       const ImagePart& part,
                       GLenum format,
                       const Blocks& blocks) {
    const auto target = image_target_of(token, dimensions);
    if (!target || target->proxy || !is_specific_compressed(format))
        return context.error(GL_INVALID_ENUM);
    if (const GLenum error = level_error(*target, level)) return context.error(error);
    TextureObject& texture = bound_texture(context, *target);
    const ImageName name{target->face, static_cast<unsigned>(level)};
    const TextureLevel& image = texture.level(name.face, name.level);
    if (image.internal_format != format) return context.error(GL_INVALID_OPERATION);
    if (const GLenum error = part_error(image, *target, part)) return context.error(error);
    const std::size_t bytes = blocks_bytes(image.format.format, part.size);
    if (blocks.bytes < 0 || static_cast<std::size_t>(blocks.bytes) != bytes)
        return context.error(GL_INVALID_VALUE);
    if (part.size.empty()) return;
    const auto memory = source_memory(context, blocks.data, bytes, 1);
    if (!memory || !*memory) return;
    write_texels(context.device_memory(),
                 texture,
                 name,
                 box_of(image, *target, part),
                 std::span(*memory, bytes));
    finish_image_change(context, texture, name, false);
}

} // namespace

void CompressedTexImage1D(Context& context,
                          GLenum target,
                          GLint level,
                          GLenum internalformat,
                          GLsizei width,
                          GLint border,
                          GLsizei imageSize,
                          const void* data) {
    define_compressed(
        context, 1, target, {{}, level, internalformat, {width, 1, 1}, border}, {imageSize, data});
}

void CompressedTexImage2D(Context& context,
                          GLenum target,
                          GLint level,
                          GLenum internalformat,
                          GLsizei width,
                          GLsizei height,
                          GLint border,
                          GLsizei imageSize,
                          const void* data) {
    define_compressed(context,
                      2,
                      target,
                      {{}, level, internalformat, {width, height, 1}, border},
                      {imageSize, data});
}

void CompressedTexImage3D(Context& context,
                          GLenum target,
                          GLint level,
                          GLenum internalformat,
                          GLsizei width,
                          GLsizei height,
                          GLsizei depth,
                          GLint border,
                          GLsizei imageSize,
                          const void* data) {
    define_compressed(context,
                      3,
                      target,
                      {{}, level, internalformat, {width, height, depth}, border},
                      {imageSize, data});
}

void CompressedTexSubImage1D(Context& context,
                             GLenum target,
                             GLint level,
                             GLint xoffset,
                             GLsizei width,
                             GLenum format,
                             GLsizei imageSize,
                             const void* data) {
    change_compressed(
        context, 1, target, level, {xoffset, 0, 0, {width, 1, 1}}, format, {imageSize, data});
}

void CompressedTexSubImage2D(Context& context,
                             GLenum target,
                             GLint level,
                             GLint xoffset,
                             GLint yoffset,
                             GLsizei width,
                             GLsizei height,
                             GLenum format,
                             GLsizei imageSize,
                             const void* data) {
    change_compressed(context,
                      2,
                      target,
                      level,
                      {xoffset, yoffset, 0, {width, height, 1}},
                      format,
                      {imageSize, data});
}

void CompressedTexSubImage3D(Context& context,
                             GLenum target,
                             GLint level,
                             GLint xoffset,
                             GLint yoffset,
                             GLint zoffset,
                             GLsizei width,
                             GLsizei height,
                             GLsizei depth,
                             GLenum format,
                             GLsizei imageSize,
                             const void* data) {
    change_compressed(context,
                      3,
                      target,
                      level,
                      {xoffset, yoffset, zoffset, {width, height, depth}},
                      format,
                      {imageSize, data});
}

void GetCompressedTexImage(Context& context, GLenum token, GLint level, void* img) {
    const auto target = find_image_target(token);
    if (!target || target->proxy) return context.error(GL_INVALID_ENUM);
    if (const GLenum error = level_error(*target, level)) return context.error(error);
    TextureObject& texture = bound_texture(context, *target);
    const ImageName name{target->face, static_cast<unsigned>(level)};
    const TextureLevel& image = texture.level(name.face, name.level);
    if (!image.defined() || !is_compressed(image.format.format))
        return context.error(GL_INVALID_OPERATION);
    const std::size_t bytes = box_bytes(image.format.format, whole_box(image));
    const auto memory = destination_memory(context, img, bytes, 1);
    if (!memory || !*memory) return;
    const auto blocks = read_texels(context.device_memory(), texture, name, whole_box(image));
    std::memcpy(*memory, blocks.data(), bytes);
}

} // namespace ffgpu::gl::api
