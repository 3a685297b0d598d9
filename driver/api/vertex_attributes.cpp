// The commands that specify vertices and their attributes (GL 1.5, 2.7), in all their types.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/vertex/component.h"
#include "driver/vertex/vertex_assembler.h"

namespace ffgpu::gl::api {
namespace {

// For a texture unit that does not exist the result is undefined (GL 1.5, 2.7): nothing happens.
template <unsigned N>
void set_tex_coord(
    Context& context, GLenum target, float s, float t = 0, float r = 0, float q = 1) {
    const GLenum unit = target - GL_TEXTURE0;
    if (unit < TextureUnits) context.vertices().set<N>(tex_coord(unit), s, t, r, q);
}

} // namespace

// Each family: its commands of 1 to 4 components, as values and as an array.
#define VERTEX_COMMANDS(suffix, type)                                                              \
    void Vertex2##suffix(Context& context, type x, type y) {                                       \
        context.vertices().vertex<2>(plain(x), plain(y));                                          \
    }                                                                                              \
    void Vertex3##suffix(Context& context, type x, type y, type z) {                               \
        context.vertices().vertex<3>(plain(x), plain(y), plain(z));                                \
    }                                                                                              \
    void Vertex4##suffix(Context& context, type x, type y, type z, type w) {                       \
        context.vertices().vertex<4>(plain(x), plain(y), plain(z), plain(w));                      \
    }                                                                                              \
    void Vertex2##suffix##v(Context& context, const type* v) {                                     \
        Vertex2##suffix(context, v[0], v[1]);                                                      \
    }                                                                                              \
    void Vertex3##suffix##v(Context& context, const type* v) {                                     \
        Vertex3##suffix(context, v[0], v[1], v[2]);                                                \
    }                                                                                              \
    void Vertex4##suffix##v(Context& context, const type* v) {                                     \
        Vertex4##suffix(context, v[0], v[1], v[2], v[3]);                                          \
    }

#define TEX_COORD_COMMANDS(suffix, type)                                                           \
    void TexCoord1##suffix(Context& context, type s) {                                             \
        context.vertices().set<1>(Attribute::TexCoord0, plain(s));                                 \
    }                                                                                              \
    void TexCoord2##suffix(Context& context, type s, type t) {                                     \
        context.vertices().set<2>(Attribute::TexCoord0, plain(s), plain(t));                       \
    }                                                                                              \
    void TexCoord3##suffix(Context& context, type s, type t, type r) {                             \
        context.vertices().set<3>(Attribute::TexCoord0, plain(s), plain(t), plain(r));             \
    }                                                                                              \
    void TexCoord4##suffix(Context& context, type s, type t, type r, type q) {                     \
        context.vertices().set<4>(Attribute::TexCoord0, plain(s), plain(t), plain(r), plain(q));   \
    }                                                                                              \
    void TexCoord1##suffix##v(Context& context, const type* v) {                                   \
        TexCoord1##suffix(context, v[0]);                                                          \
    }                                                                                              \
    void TexCoord2##suffix##v(Context& context, const type* v) {                                   \
        TexCoord2##suffix(context, v[0], v[1]);                                                    \
    }                                                                                              \
    void TexCoord3##suffix##v(Context& context, const type* v) {                                   \
        TexCoord3##suffix(context, v[0], v[1], v[2]);                                              \
    }                                                                                              \
    void TexCoord4##suffix##v(Context& context, const type* v) {                                   \
        TexCoord4##suffix(context, v[0], v[1], v[2], v[3]);                                        \
    }                                                                                              \
    void MultiTexCoord1##suffix(Context& context, GLenum target, type s) {                         \
        set_tex_coord<1>(context, target, plain(s));                                               \
    }                                                                                              \
    void MultiTexCoord2##suffix(Context& context, GLenum target, type s, type t) {                 \
        set_tex_coord<2>(context, target, plain(s), plain(t));                                     \
    }                                                                                              \
    void MultiTexCoord3##suffix(Context& context, GLenum target, type s, type t, type r) {         \
        set_tex_coord<3>(context, target, plain(s), plain(t), plain(r));                           \
    }                                                                                              \
    void MultiTexCoord4##suffix(Context& context, GLenum target, type s, type t, type r, type q) { \
        set_tex_coord<4>(context, target, plain(s), plain(t), plain(r), plain(q));                 \
    }                                                                                              \
    void MultiTexCoord1##suffix##v(Context& context, GLenum target, const type* v) {               \
        MultiTexCoord1##suffix(context, target, v[0]);                                             \
    }                                                                                              \
    void MultiTexCoord2##suffix##v(Context& context, GLenum target, const type* v) {               \
        MultiTexCoord2##suffix(context, target, v[0], v[1]);                                       \
    }                                                                                              \
    void MultiTexCoord3##suffix##v(Context& context, GLenum target, const type* v) {               \
        MultiTexCoord3##suffix(context, target, v[0], v[1], v[2]);                                 \
    }                                                                                              \
    void MultiTexCoord4##suffix##v(Context& context, GLenum target, const type* v) {               \
        MultiTexCoord4##suffix(context, target, v[0], v[1], v[2], v[3]);                           \
    }

#define COLOR_COMMANDS(suffix, type)                                                               \
    void Color3##suffix(Context& context, type r, type g, type b) {                                \
        context.vertices().set<3>(Attribute::Color, normalized(r), normalized(g), normalized(b));  \
    }                                                                                              \
    void Color4##suffix(Context& context, type r, type g, type b, type a) {                        \
        context.vertices().set<4>(                                                                 \
            Attribute::Color, normalized(r), normalized(g), normalized(b), normalized(a));         \
    }                                                                                              \
    void SecondaryColor3##suffix(Context& context, type r, type g, type b) {                       \
        context.vertices().set<3>(                                                                 \
            Attribute::SecondaryColor, normalized(r), normalized(g), normalized(b));               \
    }                                                                                              \
    void Color3##suffix##v(Context& context, const type* v) {                                      \
        Color3##suffix(context, v[0], v[1], v[2]);                                                 \
    }                                                                                              \
    void Color4##suffix##v(Context& context, const type* v) {                                      \
        Color4##suffix(context, v[0], v[1], v[2], v[3]);                                           \
    }                                                                                              \
    void SecondaryColor3##suffix##v(Context& context, const type* v) {                             \
        SecondaryColor3##suffix(context, v[0], v[1], v[2]);                                        \
    }

#define NORMAL_COMMANDS(suffix, type)                                                              \
    void Normal3##suffix(Context& context, type x, type y, type z) {                               \
        context.vertices().set<3>(Attribute::Normal, normalized(x), normalized(y), normalized(z)); \
    }                                                                                              \
    void Normal3##suffix##v(Context& context, const type* v) {                                     \
        Normal3##suffix(context, v[0], v[1], v[2]);                                                \
    }

#define FOG_COMMANDS(suffix, type)                                                                 \
    void FogCoord##suffix(Context& context, type coord) {                                          \
        context.vertices().set<1>(Attribute::FogCoordinate, plain(coord));                         \
    }                                                                                              \
    void FogCoord##suffix##v(Context& context, const type* coord) {                                \
        FogCoord##suffix(context, *coord);                                                         \
    }

#define INDEX_COMMANDS(suffix, type)                                                               \
    void Index##suffix(Context& context, type c) {                                                 \
        context.vertices().set_color_index(plain(c));                                              \
    }                                                                                              \
    void Index##suffix##v(Context& context, const type* c) {                                       \
        Index##suffix(context, *c);                                                                \
    }

VERTEX_COMMANDS(s, GLshort)
VERTEX_COMMANDS(i, GLint)
VERTEX_COMMANDS(f, GLfloat)
VERTEX_COMMANDS(d, GLdouble)

TEX_COORD_COMMANDS(s, GLshort)
TEX_COORD_COMMANDS(i, GLint)
TEX_COORD_COMMANDS(f, GLfloat)
TEX_COORD_COMMANDS(d, GLdouble)

COLOR_COMMANDS(b, GLbyte)
COLOR_COMMANDS(s, GLshort)
COLOR_COMMANDS(i, GLint)
COLOR_COMMANDS(f, GLfloat)
COLOR_COMMANDS(d, GLdouble)
COLOR_COMMANDS(ub, GLubyte)
COLOR_COMMANDS(us, GLushort)
COLOR_COMMANDS(ui, GLuint)

NORMAL_COMMANDS(b, GLbyte)
NORMAL_COMMANDS(s, GLshort)
NORMAL_COMMANDS(i, GLint)
NORMAL_COMMANDS(f, GLfloat)
NORMAL_COMMANDS(d, GLdouble)

FOG_COMMANDS(f, GLfloat)
FOG_COMMANDS(d, GLdouble)

INDEX_COMMANDS(s, GLshort)
INDEX_COMMANDS(i, GLint)
INDEX_COMMANDS(f, GLfloat)
INDEX_COMMANDS(d, GLdouble)
INDEX_COMMANDS(ub, GLubyte)

void EdgeFlag(Context& context, GLboolean flag) {
    context.vertices().set<1>(Attribute::EdgeFlag, flag ? 1.0f : 0.0f);
}

void EdgeFlagv(Context& context, const GLboolean* flag) {
    EdgeFlag(context, *flag);
}

} // namespace ffgpu::gl::api
