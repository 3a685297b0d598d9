// Vertex arrays, the commands that draw from them, glBegin, evaluators.

#include "model/device/layout/limits.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr GLenum UB = GL_UNSIGNED_BYTE, Tri = GL_TRIANGLES;

constexpr RefusedCall Arrays[] = {
    REFUSED(GL_INVALID_ENUM, ClientActiveTexture, GL_TEXTURE0 + TextureUnits),
    REFUSED(GL_INVALID_ENUM, EnableClientState, GL_TEXTURE_2D),
    REFUSED(GL_INVALID_ENUM, DisableClientState, GL_TEXTURE_2D),
    REFUSED(GL_INVALID_VALUE, VertexPointer, 1, GL_FLOAT, 0, bytes),
    REFUSED(GL_INVALID_VALUE, VertexPointer, 5, GL_FLOAT, 0, bytes),
    REFUSED(GL_INVALID_ENUM, VertexPointer, 3, UB, 0, bytes),
    REFUSED(GL_INVALID_VALUE, VertexPointer, 3, GL_FLOAT, -1, bytes),
    REFUSED(GL_INVALID_VALUE, VertexPointerEXT, 3, GL_FLOAT, 0, -1, bytes),
    REFUSED(GL_INVALID_ENUM, NormalPointer, UB, 0, bytes),
    REFUSED(GL_INVALID_VALUE, NormalPointer, GL_FLOAT, -1, bytes),
    REFUSED(GL_INVALID_VALUE, NormalPointerEXT, GL_FLOAT, 0, -1, bytes),
    REFUSED(GL_INVALID_VALUE, ColorPointer, 2, GL_FLOAT, 0, bytes),
    REFUSED(GL_INVALID_VALUE, ColorPointer, GL_BGRA, GL_FLOAT, 0, bytes),
    REFUSED(GL_INVALID_ENUM, ColorPointer, 4, GL_BITMAP, 0, bytes),
    REFUSED(GL_INVALID_VALUE, ColorPointer, 4, GL_FLOAT, -1, bytes),
    REFUSED(GL_INVALID_VALUE, ColorPointerEXT, 4, GL_FLOAT, 0, -1, bytes),
    REFUSED(GL_INVALID_VALUE, SecondaryColorPointer, 4, GL_FLOAT, 0, bytes),
    REFUSED(GL_INVALID_ENUM, SecondaryColorPointer, 3, GL_BITMAP, 0, bytes),
    REFUSED(GL_INVALID_ENUM, FogCoordPointer, GL_INT, 0, bytes),
    REFUSED(GL_INVALID_VALUE, FogCoordPointer, GL_FLOAT, -1, bytes),
    REFUSED(GL_INVALID_ENUM, IndexPointer, GL_BYTE, 0, bytes),
    REFUSED(GL_INVALID_VALUE, IndexPointer, GL_FLOAT, -1, bytes),
    REFUSED(GL_INVALID_VALUE, IndexPointerEXT, GL_FLOAT, 0, -1, bytes),
    REFUSED(GL_INVALID_VALUE, EdgeFlagPointer, -1, bytes),
    REFUSED(GL_INVALID_VALUE, EdgeFlagPointerEXT, 0, -1, flags),
    REFUSED(GL_INVALID_VALUE, TexCoordPointer, 0, GL_FLOAT, 0, bytes),
    REFUSED(GL_INVALID_ENUM, TexCoordPointer, 2, UB, 0, bytes),
    REFUSED(GL_INVALID_VALUE, TexCoordPointer, 2, GL_FLOAT, -1, bytes),
    REFUSED(GL_INVALID_VALUE, TexCoordPointerEXT, 2, GL_FLOAT, 0, -1, bytes),
    REFUSED(GL_INVALID_ENUM, InterleavedArrays, GL_V2F - 1, 0, bytes),
    REFUSED(GL_INVALID_ENUM, InterleavedArrays, GL_T4F_C4F_N3F_V4F + 1, 0, bytes),
    REFUSED(GL_INVALID_VALUE, InterleavedArrays, GL_V3F, -1, bytes),
    REFUSED(GL_INVALID_VALUE, LockArraysEXT, -1, 1),
    REFUSED(GL_INVALID_VALUE, LockArraysEXT, 0, 0),
    REFUSED(GL_INVALID_OPERATION, UnlockArraysEXT),
    REFUSED(GL_INVALID_OPERATION, BindVertexArray, 99),
    REFUSED(GL_INVALID_VALUE, GenVertexArrays, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteVertexArrays, -1, names),
    REFUSED(GL_INVALID_VALUE, StringMarkerGREMEDY, -1, bytes),
};

constexpr RefusedCall Draws[] = {
    REFUSED(GL_INVALID_ENUM, Begin, GL_POLYGON + 1),
    REFUSED(GL_INVALID_OPERATION, End),
    REFUSED(GL_INVALID_OPERATION, PrimitiveRestartNV),
    REFUSED(GL_INVALID_ENUM, DrawArrays, GL_POLYGON + 1, 0, 3),
    REFUSED(GL_INVALID_VALUE, DrawArrays, Tri, 0, -1),
    REFUSED(GL_INVALID_VALUE, DrawArrays, Tri, -1, 3),
    REFUSED(GL_INVALID_VALUE, ArrayElement, -1),
    REFUSED(GL_INVALID_ENUM, DrawElements, GL_POLYGON + 1, 3, UB, bytes),
    REFUSED(GL_INVALID_VALUE, DrawElements, Tri, -1, UB, bytes),
    REFUSED(GL_INVALID_ENUM, DrawElements, Tri, 3, GL_FLOAT, bytes),
    REFUSED(GL_INVALID_ENUM, DrawElementsBaseVertex, Tri, 3, GL_FLOAT, bytes, 0),
    REFUSED(GL_INVALID_VALUE, DrawElementsBaseVertex, Tri, -1, UB, bytes, 0),
    REFUSED(GL_INVALID_ENUM, DrawElementsInstancedBaseVertex, Tri, 3, GL_INT, bytes, 1, 0),
    REFUSED(GL_INVALID_VALUE, DrawElementsInstancedBaseVertex, Tri, 3, UB, bytes, -1, 0),
    REFUSED(GL_INVALID_VALUE, DrawRangeElements, Tri, 2, 1, 3, UB, bytes),
    REFUSED(GL_INVALID_ENUM, DrawRangeElements, Tri, 0, 2, 3, GL_SHORT, bytes),
    REFUSED(GL_INVALID_VALUE, DrawRangeElementsBaseVertex, Tri, 2, 1, 3, UB, bytes, 0),
    REFUSED(GL_INVALID_VALUE, MultiDrawArrays, Tri, ints, ints, -1),
    REFUSED(GL_INVALID_ENUM, MultiDrawArrays, GL_POLYGON + 1, ints, ints, 1),
    REFUSED(GL_INVALID_VALUE, MultiDrawElements, Tri, ints, UB, pointers, -1),
    REFUSED(GL_INVALID_ENUM, MultiDrawElements, Tri, ints, GL_FLOAT, pointers, 1),
    REFUSED(GL_INVALID_VALUE, MultiDrawElementsBaseVertex, Tri, ints, UB, pointers, -1, ints),
};

void map_the_vertices() {
    entry::BindBuffer(GL_ARRAY_BUFFER, 1);
    entry::BufferData(GL_ARRAY_BUFFER, 64, bytes, GL_STATIC_DRAW);
    entry::VertexPointer(3, GL_FLOAT, 0, nullptr);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::LockArraysEXT(0, 3);
    entry::MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
}

constexpr RefusedCall MappedVertices[] = {
    REFUSED(GL_INVALID_OPERATION, LockArraysEXT, 0, 3),
    REFUSED(GL_INVALID_OPERATION, ArrayElement, 0),
    REFUSED(GL_INVALID_OPERATION, DrawArrays, Tri, 0, 3),
    REFUSED(GL_INVALID_OPERATION, DrawElements, Tri, 3, UB, bytes),
};

constexpr RefusedCall Evaluators[] = {
    REFUSED(GL_INVALID_ENUM, EvalMesh1, GL_FILL, 0, 1),
    REFUSED(GL_INVALID_ENUM, EvalMesh2, GL_QUADS, 0, 1, 0, 1),
    REFUSED(GL_INVALID_ENUM, Map1d, GL_MAP2_VERTEX_3, 0, 1, 3, 2, doubles),
    REFUSED(GL_INVALID_VALUE, Map1d, GL_MAP1_VERTEX_3, 1, 1, 3, 2, doubles),
    REFUSED(GL_INVALID_VALUE, Map1f, GL_MAP1_VERTEX_3, 0, 1, 2, 2, floats),
    REFUSED(GL_INVALID_VALUE, Map1f, GL_MAP1_VERTEX_3, 0, 1, 3, 0, floats),
    REFUSED(GL_INVALID_VALUE, Map1f, GL_MAP1_VERTEX_3, 0, 1, 3, 31, floats),
    REFUSED(GL_INVALID_ENUM, Map2d, GL_MAP1_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, doubles),
    REFUSED(GL_INVALID_VALUE, Map2d, GL_MAP2_VERTEX_3, 0, 1, 3, 2, 1, 1, 6, 2, doubles),
    REFUSED(GL_INVALID_VALUE, Map2f, GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 2, 2, floats),
    REFUSED(GL_INVALID_VALUE, Map2f, GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 31, floats),
    REFUSED(GL_INVALID_VALUE, MapGrid1d, 0, 0, 1),
    REFUSED(GL_INVALID_VALUE, MapGrid1f, 0, 0, 1),
    REFUSED(GL_INVALID_VALUE, MapGrid2d, 1, 0, 1, 0, 0, 1),
    REFUSED(GL_INVALID_VALUE, MapGrid2f, 0, 0, 1, 1, 0, 1),
};

constexpr RefusedCall OtherUnit[] = {
    REFUSED(GL_INVALID_OPERATION, Map1f, GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 2, floats),
    REFUSED(GL_INVALID_OPERATION, Map2f, GL_MAP2_TEXTURE_COORD_1, 0, 1, 1, 2, 0, 1, 2, 2, floats),
};

} // namespace

std::span<const Scene> drawing_scenes() {
    static const std::array all{
        Scene{"a fresh context: arrays", [] {}, Arrays},
        Scene{"a fresh context: draws", [] {}, Draws},
        Scene{"the vertices are locked, and in a mapped buffer", map_the_vertices, MappedVertices},
        Scene{"a fresh context: evaluators", [] {}, Evaluators},
        Scene{"unit 1 is active", [] { entry::ActiveTexture(GL_TEXTURE1); }, OtherUnit},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
