// Numbers of the GLX protocol (GLX 1.4's protocol encoding), for the X errors that a program's
// handler sees. Not from GL/glxproto.h, which wants macros that Xlib's users do without.

#pragma once

namespace ffgpu::gl {

enum GlxError : int {
    GlxBadContext = 0,
    GlxBadDrawable = 2,
    GlxBadPixmap = 3,
    GlxBadFbConfig = 9,
    GlxBadPbuffer = 10,
    GlxBadWindow = 12,
    GlxBadProfile = 13,
};

enum GlxRequest : unsigned {
    RequestCreateContext = 3,
    RequestDestroyContext = 4,
    RequestMakeCurrent = 5,
    RequestCopyContext = 10,
    RequestSwapBuffers = 11,
    RequestUseXFont = 12,
    RequestCreateGlxPixmap = 13,
    RequestDestroyGlxPixmap = 15,
    RequestCreatePixmap = 22,
    RequestDestroyPixmap = 23,
    RequestCreateNewContext = 24,
    RequestQueryContext = 25,
    RequestMakeContextCurrent = 26,
    RequestCreatePbuffer = 27,
    RequestDestroyPbuffer = 28,
    RequestGetDrawableAttributes = 29,
    RequestCreateWindow = 31,
    RequestDestroyWindow = 32,
    RequestCreateContextAttribs = 34,
};

} // namespace ffgpu::gl
