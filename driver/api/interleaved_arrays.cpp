// glInterleavedArrays (GL 1.5, 2.8, table 2.5).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"

#include <array>

namespace ffgpu::gl::api {
namespace {

// Components and offsets in bytes; 0 components: the array is disabled.
struct InterleavedFormat {
    GLint tex_coord = 0, color = 0, normal = 0, vertex = 0;
    GLenum color_type = GL_FLOAT;
    unsigned color_at = 0, normal_at = 0, vertex_at = 0;
    GLsizei stride = 0;
};

constexpr unsigned F = sizeof(GLfloat);
constexpr unsigned C = 4 * sizeof(GLubyte); // A multiple of F already.

constexpr GLenum UB = GL_UNSIGNED_BYTE;

// In the order of the tokens from GL_V2F on.
constexpr std::array<InterleavedFormat, 14> Formats{{
    {.vertex = 2, .stride = 2 * F},
    {.vertex = 3, .stride = 3 * F},
    {.color = 4, .vertex = 2, .color_type = UB, .vertex_at = C, .stride = C + 2 * F},
    {.color = 4, .vertex = 3, .color_type = UB, .vertex_at = C, .stride = C + 3 * F},
    {.color = 3, .vertex = 3, .vertex_at = 3 * F, .stride = 6 * F},
    {.normal = 3, .vertex = 3, .vertex_at = 3 * F, .stride = 6 * F},
    {.color = 4,
     .normal = 3,
     .vertex = 3,
     .normal_at = 4 * F,
     .vertex_at = 7 * F,
     .stride = 10 * F},
    {.tex_coord = 2, .vertex = 3, .vertex_at = 2 * F, .stride = 5 * F},
    {.tex_coord = 4, .vertex = 4, .vertex_at = 4 * F, .stride = 8 * F},
    {.tex_coord = 2,
     .color = 4,
     .vertex = 3,
     .color_type = UB,
     .color_at = 2 * F,
     .vertex_at = C + 2 * F,
     .stride = C + 5 * F},
    {.tex_coord = 2,
     .color = 3,
     .vertex = 3,
     .color_at = 2 * F,
     .vertex_at = 5 * F,
     .stride = 8 * F},
    {.tex_coord = 2,
     .normal = 3,
     .vertex = 3,
     .normal_at = 2 * F,
     .vertex_at = 5 * F,
     .stride = 8 * F},
    {.tex_coord = 2,
     .color = 4,
     .normal = 3,
     .vertex = 3,
     .color_at = 2 * F,
     .normal_at = 6 * F,
     .vertex_at = 9 * F,
     .stride = 12 * F},
    {.tex_coord = 4,
     .color = 4,
     .normal = 3,
     .vertex = 4,
     .color_at = 4 * F,
     .normal_at = 8 * F,
     .vertex_at = 11 * F,
     .stride = 15 * F},
}};

} // namespace

void InterleavedArrays(Context& context, GLenum format, GLsizei stride, const void* pointer) {
    const GLenum number = format - GL_V2F;
    if (number >= Formats.size()) return context.error(GL_INVALID_ENUM);
    if (stride < 0) return context.error(GL_INVALID_VALUE);
    const InterleavedFormat& f = Formats[number];
    const GLsizei step = stride == 0 ? f.stride : stride;
    // With a buffer bound, `pointer` is an offset: a number, not an address.
    const auto at = [&](unsigned offset) {
        return reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(pointer) + offset);
    };
    const auto set = [&](GLenum array, bool used) {
        used ? EnableClientState(context, array) : DisableClientState(context, array);
    };

    set(GL_EDGE_FLAG_ARRAY, false);
    set(GL_INDEX_ARRAY, false);
    set(GL_SECONDARY_COLOR_ARRAY, false);
    set(GL_FOG_COORD_ARRAY, false);
    set(GL_TEXTURE_COORD_ARRAY, f.tex_coord != 0);
    set(GL_COLOR_ARRAY, f.color != 0);
    set(GL_NORMAL_ARRAY, f.normal != 0);
    set(GL_VERTEX_ARRAY, true);
    if (f.tex_coord != 0) TexCoordPointer(context, f.tex_coord, GL_FLOAT, step, at(0));
    if (f.color != 0) ColorPointer(context, f.color, f.color_type, step, at(f.color_at));
    if (f.normal != 0) NormalPointer(context, GL_FLOAT, step, at(f.normal_at));
    VertexPointer(context, f.vertex, GL_FLOAT, step, at(f.vertex_at));
}

} // namespace ffgpu::gl::api
