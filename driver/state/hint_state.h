// Hints (GL 1.5, 5.6; state table 6.30). All of it is GL_HINT_BIT.

#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct HintState {
    GLenum perspective_correction = GL_DONT_CARE;
    GLenum point_smooth = GL_DONT_CARE;
    GLenum line_smooth = GL_DONT_CARE;
    GLenum polygon_smooth = GL_DONT_CARE;
    GLenum fog = GL_DONT_CARE;
    GLenum generate_mipmap = GL_DONT_CARE;
    GLenum texture_compression = GL_DONT_CARE;
};

} // namespace ffgpu::gl
