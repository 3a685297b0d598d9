// Texture images from the framebuffer (GL 1.5, 3.8.2). Where no pixel transfer changes them, the
// device copies the pixels; else they take the way of glReadPixels and glTexSubImage.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/images/read_target.h"
#include "driver/texel/block_codec.h"
#include "driver/texel/texel_codec.h"

namespace ffgpu::gl::api {
namespace {

bool is_depth(BaseFormat base) {
    return base == BaseFormat::Depth || base == BaseFormat::DepthStencil;
}

// What is copied, and where the first pixel goes in stored texels.
struct Copy {
    Surface source;
    PixelRectangle pixels; // inside of the source
    TexelBox box;          // of the same size
};

// Pixels outside of the framebuffer are undefined: their texels stay as they are.
Copy clip_copy(const Surface& source, const PixelRectangle& asked, TexelBox box) {
    const PixelRectangle inside = clip_to(source, asked);
    box.x += static_cast<std::uint32_t>(inside.x - asked.x);
    box.y += static_cast<std::uint32_t>(inside.y - asked.y);
    box.width = static_cast<std::uint32_t>(inside.width);
    box.height = static_cast<std::uint32_t>(inside.height);
    return {source, inside, box};
}

// Luminance and intensity are read as red (GL 1.5, table 6.1 in place of 4.3), where the device's
// copies spread them over red, green and blue.
bool is_red_alone(Format format) {
    return format == Format::Luminance8 || format == Format::LuminanceAlpha8 ||
           format == Format::Intensity8;
}

bool copy_on_device(Context& context, TextureObject& texture, ImageName name, const Copy& copy) {
    const Format format = texture.level(name.face, name.level).format.format;
    const PixelState& transfer = context.state.pixel;
    const bool depth = format_info(format).is_depth;
    if (is_compressed(format) || (depth ? !keeps_depths(transfer) : !keeps_colors(transfer)))
        return false;
    if (is_red_alone(copy.source.format) && copy.source.format != format) return false;
    const Surface destination = image_memory(context.device_memory(), texture, name, copy.box.z);
    if (destination.format == Format::None) return false;
    CommandStream commands;
    commands.add(CopyRectangleCommand{.source = copy.source,
                                      .destination = destination,
                                      .source_x = static_cast<std::uint16_t>(copy.pixels.x),
                                      .source_y = static_cast<std::uint16_t>(copy.pixels.y),
                                      .destination_x = static_cast<std::uint16_t>(copy.box.x),
                                      .destination_y = static_cast<std::uint16_t>(copy.box.y),
                                      .width = static_cast<std::uint16_t>(copy.pixels.width),
                                      .height = static_cast<std::uint16_t>(copy.pixels.height)});
    context.submit(commands);
    return true;
}

std::vector<std::byte>
converted_pixels(const PixelState& transfer, const Copy& copy, const std::byte* pixels, Format to) {
    const std::size_t count = std::size_t{copy.box.width} * copy.box.height;
    const Format stored = is_compressed(to) ? Format::Rgba8 : to;
    std::vector<std::byte> texels(count * format_info(stored).block_bytes);
    if (format_info(to).is_depth) {
        std::vector<double> depths(count);
        decode_depths(copy.source.format, pixels, depths);
        transfer_depths(transfer, depths);
        encode_depths(stored, depths, texels.data());
        return texels;
    }
    std::vector<PixelColor> colors(count);
    decode_colors(copy.source.format, pixels, colors);
    transfer_colors(transfer, colors);
    encode_colors(stored, colors, texels.data());
    if (!is_compressed(to)) return texels;
    return compress(to, texels.data(), {copy.box.width, copy.box.height});
}

// The surface that an image of this format is copied from; the error is recorded where there is
// none.
std::optional<Surface> find_source(Context& context, BaseFormat base) {
    const ReadTarget target = find_read_target(context);
    if (const GLenum error = target.pixels_error()) {
        context.error(error);
        return std::nullopt;
    }
    const bool found = is_depth(base)
                           ? target.has_depth && (base == BaseFormat::Depth || target.has_stencil)
                           : target.color.format != Format::None;
    if (!found) {
        context.error(GL_INVALID_OPERATION);
        return std::nullopt;
    }
    return is_depth(base) ? target.pixel_depths() : target.pixel_colors();
}

// The error of the source has been looked for.
void copy_texels(Context& context,
                 TextureObject& texture,
                 ImageName name,
                 const PixelRectangle& asked,
                 const TexelBox& box) {
    // First, because the source may be another level of the texture, which then moves with it.
    make_resident(context.device_memory(), texture);
    const InternalFormat format = texture.level(name.face, name.level).format;
    const auto source = find_source(context, format.base);
    if (!source) return;
    const Copy copy = clip_copy(*source, asked, box);
    if (copy.pixels.empty() || copy_on_device(context, texture, name, copy)) return;
    const auto pixels = read_surface(context.device(), copy.source, copy.pixels);
    write_texels(context.device_memory(),
                 texture,
                 name,
                 copy.box,
                 converted_pixels(context.state.pixel, copy, pixels.data(), format.format));
}

void copy_image(Context& context,
                unsigned dimensions,
                GLenum token,
                ImageDefinition definition,
                GLint x,
                GLint y) {
    const auto target = image_target_of(token, dimensions);
    if (!target || target->proxy) return context.error(GL_INVALID_ENUM);
    definition.target = *target;
    const BaseFormat base = texture_format(definition.internal_format).base;
    if (base == BaseFormat::None || definition.internal_format <= 4)
        return context.error(GL_INVALID_ENUM);
    if (const GLenum error = definition_error(definition)) return context.error(error);
    if (is_too_large(definition)) return context.error(GL_INVALID_VALUE);
    if (!find_source(context, base)) return;

    TextureObject& texture = bound_texture(context, *target);
    const ImageName name{target->face, static_cast<unsigned>(definition.level)};
    define_image(context.device_memory(), texture, name, level_of(definition), {});
    const PixelRectangle asked{x, y, definition.size.width, definition.size.height};
    copy_texels(context, texture, name, asked, whole_box(texture.level(name.face, name.level)));
    finish_image_change(context, texture, name, true);
}

void copy_part(Context& context,
               unsigned dimensions,
               GLenum token,
               GLint level,
               const ImagePart& part,
               GLint x,
               GLint y) {
    const auto target = image_target_of(token, dimensions);
    if (!target || target->proxy) return context.error(GL_INVALID_ENUM);
    if (const GLenum error = level_error(*target, level)) return context.error(error);
    TextureObject& texture = bound_texture(context, *target);
    const ImageName name{target->face, static_cast<unsigned>(level)};
    const TextureLevel& image = texture.level(name.face, name.level);
    if (const GLenum error = part_error(image, *target, part)) return context.error(error);
    if (!find_source(context, image.format.base) || part.size.empty()) return;
    const PixelRectangle asked{x, y, part.size.width, part.size.height};
    copy_texels(context, texture, name, asked, box_of(image, *target, part));
    finish_image_change(context, texture, name, false);
}

} // namespace

void CopyTexImage1D(Context& context,
                    GLenum target,
                    GLint level,
                    GLenum internalformat,
                    GLint x,
                    GLint y,
                    GLsizei width,
                    GLint border) {
    copy_image(context, 1, target, {{}, level, internalformat, {width, 1, 1}, border}, x, y);
}

void CopyTexImage2D(Context& context,
                    GLenum target,
                    GLint level,
                    GLenum internalformat,
                    GLint x,
                    GLint y,
                    GLsizei width,
                    GLsizei height,
                    GLint border) {
    copy_image(context, 2, target, {{}, level, internalformat, {width, height, 1}, border}, x, y);
}

void CopyTexSubImage1D(
    Context& context, GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width) {
    copy_part(context, 1, target, level, {xoffset, 0, 0, {width, 1, 1}}, x, y);
}

void CopyTexSubImage2D(Context& context,
                       GLenum target,
                       GLint level,
                       GLint xoffset,
                       GLint yoffset,
                       GLint x,
                       GLint y,
                       GLsizei width,
                       GLsizei height) {
    copy_part(context, 2, target, level, {xoffset, yoffset, 0, {width, height, 1}}, x, y);
}

void CopyTexSubImage3D(Context& context,
                       GLenum target,
                       GLint level,
                       GLint xoffset,
                       GLint yoffset,
                       GLint zoffset,
                       GLint x,
                       GLint y,
                       GLsizei width,
                       GLsizei height) {
    copy_part(context, 3, target, level, {xoffset, yoffset, zoffset, {width, height, 1}}, x, y);
}

} // namespace ffgpu::gl::api
