// Reading texture images and what is known of them (GL 1.5, 6.1.3 and 6.1.4).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/images/pixel_memory.h"
#include "driver/pixel/pixel_format.h"
#include "driver/texture/image_upload.h"

namespace ffgpu::gl::api {
namespace {

bool is_depth(BaseFormat base) {
    return base == BaseFormat::Depth || base == BaseFormat::DepthStencil;
}

GLenum download_error(GLenum format, GLenum type, BaseFormat base) {
    const PixelKind kind = component_order(format).kind;
    if (kind == PixelKind::Index || kind == PixelKind::Stencil || type == GL_BITMAP)
        return GL_INVALID_ENUM;
    if (const GLenum error = format_type_error(format, type)) return error;
    switch (kind) {
    case PixelKind::Depth:
        return is_depth(base) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    case PixelKind::DepthStencil:
        return base == BaseFormat::DepthStencil ? GL_NO_ERROR : GL_INVALID_OPERATION;
    default:
        return is_depth(base) ? GL_INVALID_OPERATION : GL_NO_ERROR;
    }
}

GLint component_type(GLenum name, const ComponentBits& bits, BaseFormat base) {
    const unsigned present = name == GL_TEXTURE_RED_TYPE         ? bits.red
                             : name == GL_TEXTURE_GREEN_TYPE     ? bits.green
                             : name == GL_TEXTURE_BLUE_TYPE      ? bits.blue
                             : name == GL_TEXTURE_ALPHA_TYPE     ? bits.alpha
                             : name == GL_TEXTURE_LUMINANCE_TYPE ? bits.luminance
                             : name == GL_TEXTURE_INTENSITY_TYPE ? bits.intensity
                             : is_depth(base)                    ? 1
                                                                 : 0;
    return present != 0 ? GL_UNSIGNED_NORMALIZED : GL_NONE;
}

GLint compressed_bytes(const TextureLevel& image) {
    return static_cast<GLint>(box_bytes(image.format.format, whole_box(image)));
}

// False: there is no such parameter.
bool level_parameter(const TextureLevel& image, bool proxy, GLenum name, GLint& value) {
    const ComponentBits bits = component_bits(image.format);
    const bool compressed = is_compressed(image.format.format);
    switch (name) {
    case GL_TEXTURE_WIDTH:
        value = image.width;
        return true;
    case GL_TEXTURE_HEIGHT:
        value = image.height;
        return true;
    case GL_TEXTURE_DEPTH:
        value = image.depth;
        return true;
    case GL_TEXTURE_BORDER:
        value = image.border;
        return true;
    case GL_TEXTURE_INTERNAL_FORMAT:
        value = static_cast<GLint>(queried_format(image.internal_format));
        return true;
    case GL_TEXTURE_RED_SIZE:
        value = bits.red;
        return true;
    case GL_TEXTURE_GREEN_SIZE:
        value = bits.green;
        return true;
    case GL_TEXTURE_BLUE_SIZE:
        value = bits.blue;
        return true;
    case GL_TEXTURE_ALPHA_SIZE:
        value = bits.alpha;
        return true;
    case GL_TEXTURE_LUMINANCE_SIZE:
        value = bits.luminance;
        return true;
    case GL_TEXTURE_INTENSITY_SIZE:
        value = bits.intensity;
        return true;
    case GL_TEXTURE_DEPTH_SIZE:
        value = bits.depth;
        return true;
    case GL_TEXTURE_STENCIL_SIZE:
        value = bits.stencil;
        return true;
    case GL_TEXTURE_RED_TYPE:
    case GL_TEXTURE_GREEN_TYPE:
    case GL_TEXTURE_BLUE_TYPE:
    case GL_TEXTURE_ALPHA_TYPE:
    case GL_TEXTURE_LUMINANCE_TYPE:
    case GL_TEXTURE_INTENSITY_TYPE:
    case GL_TEXTURE_DEPTH_TYPE:
        value = component_type(name, bits, image.format.base);
        return true;
    case GL_TEXTURE_COMPRESSED:
        value = compressed;
        return true;
    case GL_TEXTURE_COMPRESSED_IMAGE_SIZE:
        value = compressed && !proxy ? compressed_bytes(image) : 0;
        return true;
    default:
        return false;
    }
}

template <class Value>
void get_level_parameter(Context& context, GLenum token, GLint level, GLenum name, Value* params) {
    const auto target = find_image_target(token);
    if (!target) return context.error(GL_INVALID_ENUM);
    if (const GLenum error = level_error(*target, level)) return context.error(error);
    const TextureObject& texture =
        target->proxy ? *context.state.texture.proxies[static_cast<std::size_t>(target->target)]
                      : bound_texture(context, *target);
    const TextureLevel& image = texture.level(target->face, static_cast<unsigned>(level));
    GLint value = 0;
    if (!level_parameter(image, target->proxy, name, value)) return context.error(GL_INVALID_ENUM);
    const bool asks_bytes = name == GL_TEXTURE_COMPRESSED_IMAGE_SIZE;
    if (asks_bytes && (target->proxy || !is_compressed(image.format.format)))
        return context.error(GL_INVALID_OPERATION);
    *params = static_cast<Value>(value);
}

} // namespace

void GetTexImage(
    Context& context, GLenum token, GLint level, GLenum format, GLenum type, void* pixels) {
    const auto target = find_image_target(token);
    if (!target || target->proxy) return context.error(GL_INVALID_ENUM);
    if (const GLenum error = level_error(*target, level)) return context.error(error);
    TextureObject& texture = bound_texture(context, *target);
    const ImageName name{target->face, static_cast<unsigned>(level)};
    const TextureLevel& image = texture.level(name.face, name.level);
    if (const GLenum error = download_error(format, type, image.format.base))
        return context.error(error);
    if (!image.defined()) return;

    const ImageSize size{image.width, image.height, image.depth};
    auto destination =
        pixel_destination(context, pixels, size, format, type, target->dimensions == 3);
    if (!destination || !destination->memory) return;
    destination->sums_luminance = false;
    const auto texels = read_texels(context.device_memory(), texture, name, whole_box(image));
    pack_texels(*destination, image.format, texels.data());
}

void GetTexLevelParameteriv(
    Context& context, GLenum target, GLint level, GLenum pname, GLint* params) {
    get_level_parameter(context, target, level, pname, params);
}

void GetTexLevelParameterfv(
    Context& context, GLenum target, GLint level, GLenum pname, GLfloat* params) {
    get_level_parameter(context, target, level, pname, params);
}

} // namespace ffgpu::gl::api
