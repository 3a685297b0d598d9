// EGL's own headers without X's types (a window is a number, a display a pointer), and how its
// functions are exported.

#pragma once

#ifndef EGL_NO_X11
#define EGL_NO_X11
#endif
#ifndef MESA_EGL_NO_X11_HEADERS
#define MESA_EGL_NO_X11_HEADERS
#endif
#include <EGL/egl.h>
#include <EGL/eglext.h>

#define FFGPU_EGL extern "C" __attribute__((visibility("default")))
