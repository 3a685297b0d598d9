#include "tests/gallery/harness/textures.h"

#include "driver/ffgpu_texture_filter.h"

#include <cstdio>
#include <cstring>

namespace ffgpu::gallery {
namespace {

GLuint new_texture(GLenum target, GLint filter, GLint wrap) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    set_filters(target, filter, filter);
    set_wrap(target, wrap);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return name;
}

void load(GLenum target, const Image& image) {
    glTexImage2D(target,
                 0,
                 GL_RGBA8,
                 image.width,
                 image.height,
                 0,
                 GL_RGBA,
                 GL_UNSIGNED_BYTE,
                 image.rgba.data());
}

void load(GLenum target, const techniques::Texels& texels) {
    const bool grey = texels.channels == 1;
    glTexImage2D(target,
                 0,
                 grey ? GL_LUMINANCE8 : GL_RGB8,
                 texels.width,
                 texels.height,
                 0,
                 grey ? GL_LUMINANCE : GL_RGB,
                 GL_UNSIGNED_BYTE,
                 texels.bytes.data());
}

template <class Face>
GLuint load_cube(const std::array<Face, 6>& faces) {
    const GLuint name = new_texture(GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_CLAMP_TO_EDGE);
    GLenum target = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    for (const Face& face : faces)
        load(target++, face);
    return name;
}

} // namespace

void set_filters(GLenum target, GLint minifying, GLint magnifying) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minifying);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnifying);
}

void set_wrap(GLenum target, GLint mode) {
    for (const auto direction : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(target, static_cast<GLenum>(direction), mode);
}

void set_wide_filter(GLint filter) {
    const auto* const names = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    if (names && std::strstr(names, "GL_FFGPU_texture_filter")) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, filter);
    } else {
        std::fputs("no GL_FFGPU_texture_filter here: OpenGL's own filter is drawn\n", stderr);
    }
}

void coordinates_are_places() {
    for (int i = 0; i < 4; ++i) {
        GLfloat plane[4] = {};
        plane[i] = 1;
        const auto coordinate = static_cast<GLenum>(GL_S + i);
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        glTexGenfv(coordinate, GL_OBJECT_PLANE, plane);
        glEnable(static_cast<GLenum>(GL_TEXTURE_GEN_S + i));
    }
}

GLuint texture_2d(const Image& image, GLint filter) {
    const GLuint name = new_texture(GL_TEXTURE_2D, filter, GL_REPEAT);
    load(GL_TEXTURE_2D, image);
    return name;
}

GLuint texture_2d(const techniques::Texels& texels, GLint filter) {
    const GLuint name = new_texture(GL_TEXTURE_2D, filter, GL_REPEAT);
    load(GL_TEXTURE_2D, texels);
    return name;
}

GLuint texture_3d(const techniques::Texels& texels, GLint filter) {
    const GLuint name = new_texture(GL_TEXTURE_3D, filter, GL_REPEAT);
    const bool grey = texels.channels == 1, alpha = texels.channels == 4;
    glTexImage3D(GL_TEXTURE_3D,
                 0,
                 grey    ? GL_LUMINANCE8
                 : alpha ? GL_RGBA8
                         : GL_RGB8,
                 texels.width,
                 texels.height,
                 texels.depth,
                 0,
                 grey    ? GL_LUMINANCE
                 : alpha ? GL_RGBA
                         : GL_RGB,
                 GL_UNSIGNED_BYTE,
                 texels.bytes.data());
    return name;
}

GLuint cube_map(const std::array<Image, 6>& faces) {
    return load_cube(faces);
}

GLuint cube_map(const std::array<techniques::Texels, 6>& faces) {
    return load_cube(faces);
}

} // namespace ffgpu::gallery
