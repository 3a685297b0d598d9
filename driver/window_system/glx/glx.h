// GLX's own header without X's macros, and how its functions are exported.

#pragma once

#include "driver/window_system/x11/xlib.h"

#include <GL/glx.h>
#include <GL/glxext.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#define FFGPU_GLX extern "C" __attribute__((visibility("default")))
