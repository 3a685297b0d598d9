#include "driver/texture/texture_target.h"

#include "model/device/layout/limits.h"

#include <bit>

namespace ffgpu::gl {

std::optional<TextureTarget> find_texture_target(GLenum token) {
    switch (token) {
    case GL_TEXTURE_1D:
        return TextureTarget::OneD;
    case GL_TEXTURE_2D:
        return TextureTarget::TwoD;
    case GL_TEXTURE_RECTANGLE:
        return TextureTarget::Rectangle;
    case GL_TEXTURE_3D:
        return TextureTarget::ThreeD;
    case GL_TEXTURE_CUBE_MAP:
        return TextureTarget::Cube;
    default:
        return std::nullopt;
    }
}

std::optional<ImageTarget> find_image_target(GLenum token) {
    if (token >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && token <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)
        return ImageTarget{TextureTarget::Cube, token - GL_TEXTURE_CUBE_MAP_POSITIVE_X, false, 2};
    switch (token) {
    case GL_TEXTURE_1D:
        return ImageTarget{TextureTarget::OneD, 0, false, 1};
    case GL_PROXY_TEXTURE_1D:
        return ImageTarget{TextureTarget::OneD, 0, true, 1};
    case GL_TEXTURE_2D:
        return ImageTarget{TextureTarget::TwoD, 0, false, 2};
    case GL_PROXY_TEXTURE_2D:
        return ImageTarget{TextureTarget::TwoD, 0, true, 2};
    case GL_TEXTURE_RECTANGLE:
        return ImageTarget{TextureTarget::Rectangle, 0, false, 2};
    case GL_PROXY_TEXTURE_RECTANGLE:
        return ImageTarget{TextureTarget::Rectangle, 0, true, 2};
    case GL_PROXY_TEXTURE_CUBE_MAP:
        return ImageTarget{TextureTarget::Cube, 0, true, 2};
    case GL_TEXTURE_3D:
        return ImageTarget{TextureTarget::ThreeD, 0, false, 3};
    case GL_PROXY_TEXTURE_3D:
        return ImageTarget{TextureTarget::ThreeD, 0, true, 3};
    default:
        return std::nullopt;
    }
}

GLenum texture_token(TextureTarget target) {
    switch (target) {
    case TextureTarget::OneD:
        return GL_TEXTURE_1D;
    case TextureTarget::TwoD:
        return GL_TEXTURE_2D;
    case TextureTarget::Rectangle:
        return GL_TEXTURE_RECTANGLE;
    case TextureTarget::ThreeD:
        return GL_TEXTURE_3D;
    default:
        return GL_TEXTURE_CUBE_MAP;
    }
}

std::uint32_t max_texture_size(TextureTarget target) {
    return target == TextureTarget::ThreeD ? MaxTexture3dSize : MaxTextureSize;
}

unsigned max_texture_levels(TextureTarget target) {
    if (target == TextureTarget::Rectangle) return 1;
    return static_cast<unsigned>(std::bit_width(max_texture_size(target)));
}

} // namespace ffgpu::gl
