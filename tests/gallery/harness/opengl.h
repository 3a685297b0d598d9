// OpenGL 1.5 and GLU, with the functions declared and not only their types.

#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glu.h>
