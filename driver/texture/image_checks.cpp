#include "driver/texture/image_checks.h"

#include "driver/pixel/pixel_format.h"

namespace ffgpu::gl {

namespace {

bool is_depth(BaseFormat base) {
    return base == BaseFormat::Depth || base == BaseFormat::DepthStencil;
}

// Along one axis: the part lies in the image, and does not cut blocks.
struct Span {
    std::int64_t offset, count, size, border;

    bool inside() const {
        return offset >= -border && count >= 0 && offset + count <= size - border;
    }
    bool keeps_blocks(unsigned block) const {
        return offset % block == 0 && (count % block == 0 || offset + count == size);
    }
};

} // namespace

std::optional<ImageTarget> image_target_of(GLenum token, unsigned dimensions) {
    const auto target = find_image_target(token);
    return target && target->dimensions == dimensions ? target : std::nullopt;
}

GLenum level_error(const ImageTarget& target, GLint level) {
    const auto levels = static_cast<GLint>(max_texture_levels(target.target));
    return level < 0 || level >= levels ? GL_INVALID_VALUE : GL_NO_ERROR;
}

GLenum definition_error(const ImageDefinition& definition) {
    const auto& [target, level, internal_format, size, border] = definition;
    if (const GLenum error = level_error(target, level)) return error;
    if (border < 0 || border > 1) return GL_INVALID_VALUE;
    if (border != 0 && target.target == TextureTarget::Rectangle) return GL_INVALID_VALUE;
    if (size.width < 2 * border) return GL_INVALID_VALUE;
    if (target.dimensions >= 2 && size.height < 2 * border) return GL_INVALID_VALUE;
    if (target.dimensions == 3 && size.depth < 2 * border) return GL_INVALID_VALUE;
    if (target.target == TextureTarget::Cube && size.width != size.height) return GL_INVALID_VALUE;

    // Depth cube maps came with EXT_gpu_shader4 and GL 3.0; packed depth-stencil uses them earlier.
    const BaseFormat base = texture_format(internal_format).base;
    if (is_depth(base) && target.target == TextureTarget::ThreeD) return GL_INVALID_OPERATION;
    if (is_specific_compressed(internal_format)) { // Blocks are two-dimensional and have no border.
        if (target.target == TextureTarget::OneD || target.target == TextureTarget::Rectangle)
            return GL_INVALID_ENUM;
        const bool solid = target.target == TextureTarget::ThreeD;
        if (border != 0 || (solid && !is_fxt1(texture_format(internal_format).format)))
            return GL_INVALID_OPERATION;
    }
    return GL_NO_ERROR;
}

bool is_too_large(const ImageDefinition& definition) {
    const auto& [target, level, internal_format, size, border] = definition;
    const GLsizei limit = static_cast<GLsizei>(max_texture_size(target.target) >> level);
    const auto exceeds = [limit, borders = 2 * border](GLsizei extent) {
        return extent - borders > limit;
    };
    return exceeds(size.width) || (target.dimensions >= 2 && exceeds(size.height)) ||
           (target.dimensions == 3 && exceeds(size.depth));
}

GLenum pixels_error(GLenum format, GLenum type, InternalFormat internal) {
    if (const GLenum error = format_type_error(format, type)) return error;
    switch (component_order(format).kind) {
    case PixelKind::Stencil:
        return is_depth(internal.base) ? GL_INVALID_OPERATION : GL_INVALID_ENUM;
    case PixelKind::Depth:
    case PixelKind::DepthStencil:
        return is_depth(internal.base) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    default:
        return is_depth(internal.base) ? GL_INVALID_OPERATION : GL_NO_ERROR;
    }
}

GLenum part_error(const TextureLevel& image, const ImageTarget& target, const ImagePart& part) {
    if (image.format.base == BaseFormat::None) return GL_INVALID_OPERATION;
    const GLint border_y = target.dimensions >= 2 ? image.border : 0;
    const GLint border_z = target.dimensions == 3 ? image.border : 0;
    const Span x{part.x, part.size.width, image.width, image.border};
    const Span y{part.y, part.size.height, image.height, border_y};
    const Span z{part.z, part.size.depth, image.depth, border_z};
    if (!x.inside() || !y.inside() || !z.inside()) return GL_INVALID_VALUE;
    const FormatInfo& info = format_info(image.format.format);
    if (!x.keeps_blocks(info.block_width) || !y.keeps_blocks(info.block_height))
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

TexelBox box_of(const TextureLevel& image, const ImageTarget& target, const ImagePart& part) {
    const GLint border_y = target.dimensions >= 2 ? image.border : 0;
    const GLint border_z = target.dimensions == 3 ? image.border : 0;
    return {static_cast<std::uint32_t>(part.x + image.border),
            static_cast<std::uint32_t>(part.y + border_y),
            static_cast<std::uint32_t>(part.z + border_z),
            static_cast<std::uint32_t>(part.size.width),
            static_cast<std::uint32_t>(part.size.height),
            static_cast<std::uint32_t>(part.size.depth)};
}

TextureLevel level_of(const ImageDefinition& definition) {
    TextureLevel level;
    level.internal_format = definition.internal_format;
    level.format = texture_format(definition.internal_format);
    level.width = definition.size.width;
    level.height = definition.size.height;
    level.depth = definition.size.depth;
    level.border = definition.border;
    return level;
}

} // namespace ffgpu::gl
