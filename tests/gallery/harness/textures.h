// Images become texture objects.

#pragma once

#include "techniques/image.h"
#include "tests/gallery/harness/images.h"
#include "tests/gallery/harness/opengl.h"

#include <array>

namespace ffgpu::gallery {

// Bound on return; without mip maps: both filters are `filter`. It repeats.
GLuint texture_2d(const Image& image, GLint filter = GL_LINEAR);
GLuint texture_2d(const techniques::Texels& texels, GLint filter = GL_LINEAR);
GLuint texture_3d(const techniques::Texels& texels, GLint filter = GL_LINEAR);
// +x, -x, +y, -y, +z, -z; clamped to the edges.
GLuint cube_map(const std::array<Image, 6>& faces);
GLuint cube_map(const std::array<techniques::Texels, 6>& faces);

// Filters and the same wrap mode in all directions, of the texture that is bound.
void set_filters(GLenum target, GLint minifying, GLint magnifying);
void set_wrap(GLenum target, GLint mode);

// A filter of GL_FFGPU_texture_filter for the 2-D texture that is bound. Where this OpenGL does not
// have the extension the texture stays as it is, and stderr says so.
void set_wide_filter(GLint filter);

// The coordinates (s, t, r, q) of the unit that is active are the vertex (x, y, z, w) itself.
void coordinates_are_places();

} // namespace ffgpu::gallery
