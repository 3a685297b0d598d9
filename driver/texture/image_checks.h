// The errors of commands that define or change texture images (GL 1.5, 3.8.1 to 3.8.3). Each
// function returns GL_NO_ERROR or the error.

#pragma once

#include "driver/objects/texture_object.h"
#include "driver/pixel/pixel_layout.h"
#include "driver/texture/residency.h"
#include "driver/texture/texture_target.h"

namespace ffgpu::gl {

// What glTexImage*, glCopyTexImage* and glCompressedTexImage* say of an image.
struct ImageDefinition {
    ImageTarget target;
    GLint level = 0;
    GLenum internal_format = 0;
    ImageSize size; // with the border
    GLint border = 0;
};

// Nothing: images of so many dimensions have no such target (GL_INVALID_ENUM).
std::optional<ImageTarget> image_target_of(GLenum token, unsigned dimensions);

GLenum level_error(const ImageTarget& target, GLint level);

// All but the internal format's existence, whose error differs between the commands, and but
// whether the size is too large: a proxy tells that without an error.
GLenum definition_error(const ImageDefinition& definition);
bool is_too_large(const ImageDefinition& definition);

// Whether pixels of `format` and `type` can become texels of `internal`.
GLenum pixels_error(GLenum format, GLenum type, InternalFormat internal);

// A part of an image, in GL's coordinates: -border is the first texel.
struct ImagePart {
    GLint x = 0, y = 0, z = 0;
    ImageSize size;
};

// The image is defined, the part lies in it and, of a compressed image, keeps to its blocks.
GLenum part_error(const TextureLevel& image, const ImageTarget& target, const ImagePart& part);

TexelBox box_of(const TextureLevel& image, const ImageTarget& target, const ImagePart& part);

TextureLevel level_of(const ImageDefinition& definition);

} // namespace ffgpu::gl
