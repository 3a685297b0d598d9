/* Off-screen rendering into memory of the program: the calls of Mesa's libOSMesa, so that programs
 * written for it run unchanged. Link with libOSMesa.so.8 of this installation.
 *
 * A picture is complete in the program's buffer after glFinish() or glFlush(). */

#ifndef FFGPU_OSMESA_H
#define FFGPU_OSMESA_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

#define OSMESA_MAJOR_VERSION 11
#define OSMESA_MINOR_VERSION 2
#define OSMESA_PATCH_VERSION 0

/* Orders of a pixel's channels in the buffer, for OSMesaCreateContext. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* OSMesaPixelStore. */
#define OSMESA_ROW_LENGTH 0x10 /* pixels from a row to the next; 0: the width */
#define OSMESA_Y_UP 0x11       /* 1 (default): the first row is the lowest */

/* OSMesaGetIntegerv. */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_FORMAT 0x22
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

/* OSMesaCreateContextAttribs: pairs of name and value, ended by 0. */
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

// NOLINTBEGIN(modernize-*): C programs include this.
typedef struct osmesa_context* OSMesaContext;
typedef void (*OSMESAproc)(void);
// NOLINTEND(modernize-*)

OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext sharelist);
OSMesaContext OSMesaCreateContextExt(
    GLenum format, GLint depthBits, GLint stencilBits, GLint accumBits, OSMesaContext sharelist);
OSMesaContext OSMesaCreateContextAttribs(const int* attribList, OSMesaContext sharelist);
void OSMesaDestroyContext(OSMesaContext ctx);

/* type: GL_UNSIGNED_BYTE, or GL_UNSIGNED_SHORT_5_6_5 with OSMESA_RGB_565. */
GLboolean
OSMesaMakeCurrent(OSMesaContext ctx, void* buffer, GLenum type, GLsizei width, GLsizei height);
OSMesaContext OSMesaGetCurrentContext(void);
void OSMesaPixelStore(GLint pname, GLint value);
void OSMesaGetIntegerv(GLint pname, GLint* value);
GLboolean OSMesaGetDepthBuffer(
    OSMesaContext c, GLint* width, GLint* height, GLint* bytesPerValue, void** buffer);
GLboolean
OSMesaGetColorBuffer(OSMesaContext c, GLint* width, GLint* height, GLint* format, void** buffer);
OSMESAproc OSMesaGetProcAddress(const char* funcName);
void OSMesaColorClamp(GLboolean enable); /* no effect */
void OSMesaPostprocess(OSMesaContext osmesa,
                       const char* filter,
                       unsigned enable_value); /* no effect */

#ifdef __cplusplus
}
#endif

#endif
