// Texture objects and images.

#include "model/device/layout/limits.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr GLenum T1 = GL_TEXTURE_1D, T2 = GL_TEXTURE_2D, T3 = GL_TEXTURE_3D;
constexpr GLenum UB = GL_UNSIGNED_BYTE, Dxt1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
constexpr GLint TooDeep = MaxTextureLevels;
constexpr GLsizei TooWide = MaxTextureSize + 1;

constexpr RefusedCall Objects[] = {
    REFUSED(GL_INVALID_ENUM, BindTexture, GL_TEXTURE, 1),
    REFUSED(GL_INVALID_ENUM, BindTexture, GL_PROXY_TEXTURE_2D, 1),
    REFUSED(GL_INVALID_VALUE, GenTextures, -1, names),
    REFUSED(GL_INVALID_VALUE, GenTexturesEXT, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteTextures, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteTexturesEXT, -1, names),
    REFUSED(GL_INVALID_VALUE, PrioritizeTextures, -1, names, floats),
    REFUSED(GL_INVALID_VALUE, AreTexturesResident, -1, names, flags),
    REFUSED(GL_INVALID_VALUE, AreTexturesResident, 1, names, flags),
    REFUSED(GL_INVALID_VALUE, AreTexturesResidentEXT, -1, names, flags),
    REFUSED(GL_INVALID_ENUM, GenerateMipmap, GL_TEXTURE_RECTANGLE),
    REFUSED(GL_INVALID_OPERATION, GenerateMipmap, GL_TEXTURE_CUBE_MAP),
};

constexpr RefusedCall Images[] = {
    REFUSED(GL_INVALID_ENUM, TexImage1D, T2, 0, GL_RGBA, 4, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage1D, T1, -1, GL_RGBA, 4, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage1D, T1, TooDeep, GL_RGBA, 4, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage1D, T1, 0, GL_RGBA, -1, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage1D, T1, 0, 5, 4, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage1D, T1, 0, GL_RGBA, TooWide, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, TexImage2D, T3, 0, GL_RGBA, 4, 4, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage2D, T2, 0, GL_RGBA, 4, 4, 2, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage2D, T2, 0, GL_RGBA, 4, -1, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage2D, T2, 0, GL_RGBA, 4, TooWide, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, TexImage2D, T2, 0, GL_RGBA, 4, 4, 0, GL_FRONT, UB, bytes),
    REFUSED(GL_INVALID_ENUM, TexImage2D, T2, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_RGBA, bytes),
    REFUSED(GL_INVALID_ENUM, TexImage2D, T2, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_BITMAP, bytes),
    REFUSED(GL_INVALID_OPERATION,
            TexImage2D,
            T2,
            0,
            GL_RGBA,
            4,
            4,
            0,
            GL_RGBA,
            GL_UNSIGNED_SHORT_5_6_5,
            bytes),
    REFUSED(
        GL_INVALID_OPERATION, TexImage2D, T2, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_COMPONENT, UB, bytes),
    REFUSED(GL_INVALID_VALUE,
            TexImage2D,
            GL_TEXTURE_CUBE_MAP_POSITIVE_X,
            0,
            GL_RGBA,
            4,
            2,
            0,
            GL_RGBA,
            UB,
            bytes),
    REFUSED(GL_INVALID_VALUE,
            TexImage2D,
            GL_TEXTURE_RECTANGLE,
            1,
            GL_RGBA,
            4,
            4,
            0,
            GL_RGBA,
            UB,
            bytes),
    REFUSED(GL_INVALID_ENUM, TexImage3D, T2, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexImage3D, T3, 0, GL_RGBA, 4, 4, -1, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_OPERATION,
            TexImage3D,
            T3,
            0,
            GL_DEPTH_COMPONENT,
            4,
            4,
            4,
            0,
            GL_DEPTH_COMPONENT,
            UB,
            bytes),
    REFUSED(GL_INVALID_ENUM, CompressedTexImage1D, T1, 0, Dxt1, 4, 0, 8, bytes),
    REFUSED(GL_INVALID_ENUM, CompressedTexImage2D, T2, 0, GL_RGBA, 4, 4, 0, 8, bytes),
    REFUSED(GL_INVALID_VALUE, CompressedTexImage2D, T2, 0, Dxt1, 4, 4, 0, 7, bytes),
    REFUSED(GL_INVALID_VALUE, CompressedTexImage2D, T2, 0, Dxt1, 4, 4, 0, -1, bytes),
    REFUSED(GL_INVALID_VALUE, CompressedTexImage2D, T2, 0, Dxt1, 4, 4, 1, 8, bytes),
    REFUSED(GL_INVALID_OPERATION, CompressedTexImage3D, T3, 0, Dxt1, 4, 4, 1, 0, 8, bytes),
    REFUSED(GL_INVALID_ENUM, CopyTexImage1D, T2, 0, GL_RGBA, 0, 0, 4, 0),
    REFUSED(GL_INVALID_ENUM, CopyTexImage1D, T1, 0, 4, 0, 0, 4, 0),
    REFUSED(GL_INVALID_VALUE, CopyTexImage1D, T1, 0, GL_RGBA, 0, 0, 4, 2),
    REFUSED(GL_INVALID_ENUM, CopyTexImage2D, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0),
    REFUSED(GL_INVALID_VALUE, CopyTexImage2D, T2, 0, GL_RGBA, 0, 0, -1, 4, 0),
    REFUSED(GL_INVALID_VALUE, CopyTexImage2D, T2, TooDeep, GL_RGBA, 0, 0, 4, 4, 0),
};

// Texture 1: 4 x 4 RGBA; 2: one face of a cube; 3: 4 x 4 x 4; 4: DXT1; 5: 4 texels in a row.
void make_textures() {
    entry::BindTexture(T3, 3);
    entry::TexImage3D(T3, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, UB, bytes);
    entry::BindTexture(GL_TEXTURE_CUBE_MAP, 2);
    entry::TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 4, 0, GL_RGBA, UB, bytes);
    entry::BindTexture(T1, 5);
    entry::TexImage1D(T1, 0, GL_RGBA, 4, 0, GL_RGBA, UB, bytes);
    entry::BindTexture(T2, 1);
    entry::TexImage2D(T2, 0, GL_RGBA, 4, 4, 0, GL_RGBA, UB, bytes);
}

constexpr RefusedCall Parts[] = {
    REFUSED(GL_INVALID_OPERATION, BindTexture, T2, 3),
    REFUSED(GL_INVALID_OPERATION, GenerateMipmap, GL_TEXTURE_CUBE_MAP),
    REFUSED(GL_INVALID_ENUM, TexSubImage1D, T2, 0, 0, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexSubImage1D, T1, 0, 1, 4, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_OPERATION, TexSubImage1D, T1, 1, 0, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, TexSubImage2D, GL_PROXY_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexSubImage2D, T2, 0, -1, 0, 1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexSubImage2D, T2, 0, 0, 2, 1, 3, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, TexSubImage2D, T2, 0, 0, 0, -1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_OPERATION, TexSubImage2D, T2, 1, 0, 0, 1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, TexSubImage2D, T2, 0, 0, 0, 1, 1, GL_RGBA, GL_RGBA, bytes),
    REFUSED(GL_INVALID_VALUE, TexSubImage3D, T3, 0, 0, 0, 1, 4, 4, 4, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, TexSubImage3D, T2, 0, 0, 0, 0, 1, 1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, CopyTexSubImage1D, T2, 0, 0, 0, 0, 1),
    REFUSED(GL_INVALID_VALUE, CopyTexSubImage1D, T1, 0, 1, 0, 0, 4),
    REFUSED(GL_INVALID_ENUM, CopyTexSubImage2D, T3, 0, 0, 0, 0, 0, 1, 1),
    REFUSED(GL_INVALID_VALUE, CopyTexSubImage2D, T2, 0, 4, 0, 0, 0, 1, 1),
    REFUSED(GL_INVALID_OPERATION, CopyTexSubImage2D, T2, 1, 0, 0, 0, 0, 1, 1),
    REFUSED(GL_INVALID_ENUM, CopyTexSubImage3D, T2, 0, 0, 0, 0, 0, 0, 1, 1),
    REFUSED(GL_INVALID_VALUE, CopyTexSubImage3D, T3, 0, 0, 0, 4, 0, 0, 1, 1),
    REFUSED(GL_INVALID_ENUM, GetTexImage, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_VALUE, GetTexImage, T2, -1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, GetTexImage, T2, 0, GL_STENCIL_INDEX, UB, bytes),
    REFUSED(GL_INVALID_ENUM, GetTexImage, T2, 0, GL_RGBA, GL_BITMAP, bytes),
    REFUSED(GL_INVALID_OPERATION, GetTexImage, T2, 0, GL_DEPTH_COMPONENT, UB, bytes),
    REFUSED(GL_INVALID_ENUM, GetCompressedTexImage, GL_PROXY_TEXTURE_2D, 0, bytes),
    REFUSED(GL_INVALID_VALUE, GetCompressedTexImage, T2, TooDeep, bytes),
    REFUSED(GL_INVALID_OPERATION, GetCompressedTexImage, T2, 0, bytes),
    REFUSED(GL_INVALID_ENUM, CompressedTexSubImage1D, T1, 0, 0, 4, GL_RGBA, 8, bytes),
    REFUSED(GL_INVALID_ENUM, CompressedTexSubImage2D, T2, 0, 0, 0, 4, 4, GL_RGBA, 8, bytes),
    REFUSED(GL_INVALID_OPERATION, CompressedTexSubImage2D, T2, 0, 0, 0, 4, 4, Dxt1, 8, bytes),
    REFUSED(GL_INVALID_ENUM, CompressedTexSubImage3D, T3, 0, 0, 0, 0, 4, 4, 1, GL_RGBA, 8, bytes),
    REFUSED(GL_INVALID_OPERATION,
            GetTexLevelParameteriv,
            T2,
            0,
            GL_TEXTURE_COMPRESSED_IMAGE_SIZE,
            ints),
};

void make_compressed_texture() {
    entry::BindTexture(T2, 4);
    entry::CompressedTexImage2D(T2, 0, Dxt1, 8, 8, 0, 32, bytes);
}

constexpr RefusedCall CompressedParts[] = {
    REFUSED(GL_INVALID_VALUE, CompressedTexSubImage2D, T2, 0, 0, 0, 4, 4, Dxt1, 9, bytes),
    REFUSED(GL_INVALID_VALUE, CompressedTexSubImage2D, T2, 0, 8, 0, 4, 4, Dxt1, 8, bytes),
    REFUSED(GL_INVALID_OPERATION, CompressedTexSubImage2D, T2, 0, 2, 0, 4, 4, Dxt1, 8, bytes),
    REFUSED(GL_INVALID_OPERATION, TexSubImage2D, T2, 0, 1, 1, 4, 4, GL_RGBA, UB, bytes),
};

} // namespace

std::span<const Scene> texture_scenes() {
    static const std::array all{
        Scene{"a fresh context: objects", [] {}, Objects},
        Scene{"a fresh context: images", [] {}, Images},
        Scene{"textures with images", make_textures, Parts},
        Scene{"a compressed texture", make_compressed_texture, CompressedParts},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
