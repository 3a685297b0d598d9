// OpenGL's types and tokens, from the system's headers. Nothing below driver/ may include this.

#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
