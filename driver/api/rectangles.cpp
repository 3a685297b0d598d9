// Rectangles (GL 1.5, 2.10): four vertices of a polygon at z = 0.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/vertex/component.h"
#include "driver/vertex/immediate_vertices.h"

namespace ffgpu::gl::api {
namespace {

void rectangle(Context& context, float x1, float y1, float x2, float y2) {
    if (context.fails_inside_begin()) return;
    ImmediateVertices& vertices = context.immediate();
    vertices.begin(GL_POLYGON);
    vertices.vertex<2>(x1, y1);
    vertices.vertex<2>(x2, y1);
    vertices.vertex<2>(x2, y2);
    vertices.vertex<2>(x1, y2);
    vertices.end();
}

} // namespace

#define RECTANGLE_COMMANDS(suffix, type)                                                           \
    void Rect##suffix(Context& context, type x1, type y1, type x2, type y2) {                      \
        rectangle(context, plain(x1), plain(y1), plain(x2), plain(y2));                            \
    }                                                                                              \
    void Rect##suffix##v(Context& context, const type* v1, const type* v2) {                       \
        Rect##suffix(context, v1[0], v1[1], v2[0], v2[1]);                                         \
    }

RECTANGLE_COMMANDS(s, GLshort)
RECTANGLE_COMMANDS(i, GLint)
RECTANGLE_COMMANDS(f, GLfloat)
RECTANGLE_COMMANDS(d, GLdouble)

} // namespace ffgpu::gl::api
