// The commands with an image in the application's memory: which of their arguments describe it.

#pragma once

#include "driver/commands/command.h"
#include "driver/gl_types.h"
#include "driver/pixel/pixel_layout.h"

namespace ffgpu::gl {

struct ImageArguments {
    ImageSize size;
    GLenum format = GL_COLOR_INDEX;
    GLenum type = GL_BITMAP;
    bool three_d = false;
    bool is_proxy = false; // Only asks whether the texture would fit.
};

constexpr bool is_proxy_target(GLenum target) {
    return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D ||
           target == GL_PROXY_TEXTURE_3D || target == GL_PROXY_TEXTURE_CUBE_MAP ||
           target == GL_PROXY_TEXTURE_RECTANGLE;
}

// Known<Id>: the command has an image, which is of(the command's arguments).
template <Command Id>
struct ImageOf {
    static constexpr bool Known = false;
};

template <>
struct ImageOf<Command::Bitmap> {
    static constexpr bool Known = true;
    static ImageArguments
    of(GLsizei width, GLsizei height, GLfloat, GLfloat, GLfloat, GLfloat, const void*) {
        return {.size = {width, height}};
    }
};

template <>
struct ImageOf<Command::PolygonStipple> {
    static constexpr bool Known = true;
    static ImageArguments of(const void*) { return {.size = {32, 32}}; }
};

template <>
struct ImageOf<Command::DrawPixels> {
    static constexpr bool Known = true;
    static ImageArguments
    of(GLsizei width, GLsizei height, GLenum format, GLenum type, const void*) {
        return {.size = {width, height}, .format = format, .type = type};
    }
};

template <>
struct ImageOf<Command::TexImage1D> {
    static constexpr bool Known = true;
    static ImageArguments
    of(GLenum target, GLint, GLint, GLsizei width, GLint, GLenum format, GLenum type, const void*) {
        return {
            .size = {width}, .format = format, .type = type, .is_proxy = is_proxy_target(target)};
    }
};

template <>
struct ImageOf<Command::TexImage2D> {
    static constexpr bool Known = true;
    static ImageArguments of(GLenum target,
                             GLint,
                             GLint,
                             GLsizei width,
                             GLsizei height,
                             GLint,
                             GLenum format,
                             GLenum type,
                             const void*) {
        return {.size = {width, height},
                .format = format,
                .type = type,
                .is_proxy = is_proxy_target(target)};
    }
};

template <>
struct ImageOf<Command::TexImage3D> {
    static constexpr bool Known = true;
    static ImageArguments of(GLenum target,
                             GLint,
                             GLint,
                             GLsizei width,
                             GLsizei height,
                             GLsizei depth,
                             GLint,
                             GLenum format,
                             GLenum type,
                             const void*) {
        return {.size = {width, height, depth},
                .format = format,
                .type = type,
                .three_d = true,
                .is_proxy = is_proxy_target(target)};
    }
};

template <>
struct ImageOf<Command::TexSubImage1D> {
    static constexpr bool Known = true;
    static ImageArguments
    of(GLenum, GLint, GLint, GLsizei width, GLenum format, GLenum type, const void*) {
        return {.size = {width}, .format = format, .type = type};
    }
};

template <>
struct ImageOf<Command::TexSubImage2D> {
    static constexpr bool Known = true;
    static ImageArguments of(GLenum,
                             GLint,
                             GLint,
                             GLint,
                             GLsizei width,
                             GLsizei height,
                             GLenum format,
                             GLenum type,
                             const void*) {
        return {.size = {width, height}, .format = format, .type = type};
    }
};

template <>
struct ImageOf<Command::TexSubImage3D> {
    static constexpr bool Known = true;
    static ImageArguments of(GLenum,
                             GLint,
                             GLint,
                             GLint,
                             GLint,
                             GLsizei width,
                             GLsizei height,
                             GLsizei depth,
                             GLenum format,
                             GLenum type,
                             const void*) {
        return {.size = {width, height, depth}, .format = format, .type = type, .three_d = true};
    }
};

} // namespace ffgpu::gl
