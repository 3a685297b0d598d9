#include "tests/driver/draw_fixture.h"

#include <algorithm>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;
using Value = std::array<float, 4>;

namespace {

// Positions whose x is the vertex's number.
struct NumberedVertices {
    explicit NumberedVertices(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            positions.insert(positions.end(), {static_cast<float>(i), 0});
        entry::EnableClientState(GL_VERTEX_ARRAY);
        entry::VertexPointer(2, GL_FLOAT, 0, positions.data());
    }
    std::vector<float> positions;
};

} // namespace

TEST_CASE_METHOD(DrawFixture, "glDrawArrays draws a range of the arrays") {
    const NumberedVertices arrays(10);
    entry::DrawArrays(GL_TRIANGLES, 2, 7);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{2, 3, 4, 5, 6, 7});
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "glDrawElements draws by indices of every type") {
    const NumberedVertices arrays(1000);
    const auto drawn = [&](GLenum type, const void* indices) {
        entry::DrawElements(GL_TRIANGLES, 3, type, indices);
        const auto all = draws();
        REQUIRE(all.size() == 1);
        return names(all[0]);
    };
    const GLubyte bytes[] = {200, 7, 100};
    CHECK(drawn(GL_UNSIGNED_BYTE, bytes) == std::vector<float>{200, 7, 100});
    const GLushort shorts[] = {999, 1, 998};
    CHECK(drawn(GL_UNSIGNED_SHORT, shorts) == std::vector<float>{999, 1, 998});
    const GLuint ints[] = {5, 4, 6};
    CHECK(drawn(GL_UNSIGNED_INT, ints) == std::vector<float>{5, 4, 6});
}

TEST_CASE_METHOD(DrawFixture, "only the vertices that indices use are gathered") {
    const NumberedVertices arrays(1000);
    std::vector<GLushort> indices;
    for (GLushort i = 0; i < 60; ++i)
        indices.push_back(static_cast<GLushort>(500 + i % 20));
    entry::DrawElements(GL_TRIANGLES, 60, GL_UNSIGNED_SHORT, indices.data());
    const auto all = draws();
    CHECK(all[0].vertex_count == 20);
    CHECK(all[0].index_type == IndexType::U16);
    CHECK(names(all[0])[21] == 501);
}

TEST_CASE_METHOD(DrawFixture, "a base vertex is added to the indices") {
    const NumberedVertices arrays(100);
    const GLubyte indices[] = {0, 1, 2};
    entry::DrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices, 50);
    CHECK(names(draws()[0]) == std::vector<float>{50, 51, 52});
}

TEST_CASE_METHOD(DrawFixture, "multi draws draw one after the other") {
    const NumberedVertices arrays(100);
    const GLint first[] = {0, 10};
    const GLsizei count[] = {3, 6};
    entry::MultiDrawArrays(GL_TRIANGLES, first, count, 2);
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(names(all[1])[0] == 10);
    CHECK(all[1].count == 6);
}

TEST_CASE_METHOD(DrawFixture, "a restart index begins another primitive") {
    const NumberedVertices arrays(100);
    entry::EnableClientState(GL_PRIMITIVE_RESTART_NV);
    entry::PrimitiveRestartIndexNV(0xffff);
    const GLushort indices[] = {0, 1, 2, 0xffff, 10, 11, 12, 13};
    entry::DrawElements(GL_TRIANGLE_STRIP, 8, GL_UNSIGNED_SHORT, indices);
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2});
    CHECK(names(all[1]) == std::vector<float>{10, 11, 12, 13});
}

TEST_CASE_METHOD(DrawFixture, "array elements may be given one by one") {
    const NumberedVertices arrays(10);
    const GLubyte colors[] = {255, 0, 0, 0, 255, 0, 0, 0, 255};
    entry::EnableClientState(GL_COLOR_ARRAY);
    entry::ColorPointer(3, GL_UNSIGNED_BYTE, 0, colors);
    entry::Begin(GL_TRIANGLES);
    for (const GLint i : {2, 0, 1})
        entry::ArrayElement(i);
    entry::End();
    const auto all = draws();
    CHECK(names(all[0]) == std::vector<float>{2, 0, 1});
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{0, 0, 1, 1});
}

TEST_CASE_METHOD(DrawFixture, "arrays of every type and stride become the same floats") {
    struct Packed {
        GLshort position[3];
        GLubyte color[4];
        GLbyte normal[3];
        GLdouble tex_coord[2];
    };
    const std::vector<Packed> data{{{1, 2, 3}, {255, 0, 51, 255}, {127, -128, 0}, {0.5, 4}},
                                   {{4, 5, 6}, {0, 255, 0, 0}, {0, 0, 127}, {8, 16}},
                                   {{7, 8, 9}, {0, 0, 255, 51}, {0, 127, 0}, {32, 64}}};
    constexpr GLsizei Stride = sizeof(Packed);
    entry::VertexPointer(3, GL_SHORT, Stride, data[0].position);
    entry::ColorPointer(4, GL_UNSIGNED_BYTE, Stride, data[0].color);
    entry::NormalPointer(GL_BYTE, Stride, data[0].normal);
    entry::ClientActiveTexture(GL_TEXTURE2);
    entry::TexCoordPointer(2, GL_DOUBLE, Stride, data[0].tex_coord);
    for (const int array :
         {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
        entry::EnableClientState(static_cast<GLenum>(array));
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(position(all[0], 1) == Value{4, 5, 6, 1});
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{1, 0, 0.2f, 1});
    CHECK(attribute(all[0], 0, Attribute::Normal) == Value{1, -1, 1.0f / 255, 1});
    CHECK(attribute(all[0], 2, tex_coord(2)) == Value{32, 64, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "colours may lie as b g r a") {
    const NumberedVertices arrays(3);
    const GLubyte colors[] = {51, 0, 255, 255, 1, 2, 3, 4, 5, 6, 7, 8};
    entry::EnableClientState(GL_COLOR_ARRAY);
    entry::ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, colors);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    CHECK(attribute(draws()[0], 0, Attribute::Color) == Value{1, 0, 0.2f, 1});
}

TEST_CASE_METHOD(DrawFixture, "without a vertex array nothing is drawn") {
    const GLubyte colors[9] = {};
    entry::EnableClientState(GL_COLOR_ARRAY);
    entry::ColorPointer(3, GL_UNSIGNED_BYTE, 0, colors);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    CHECK(draws().empty());
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "interleaved arrays set and enable what their format names") {
    // GL_T2F_C4UB_V3F
    struct Vertex {
        GLfloat s, t;
        GLubyte color[4];
        GLfloat x, y, z;
    };
    const Vertex data[] = {{1, 2, {255, 0, 0, 51}, 3, 4, 5},
                           {6, 7, {0, 0, 0, 0}, 8, 9, 10},
                           {11, 12, {0, 0, 0, 0}, 13, 14, 15}};
    entry::EnableClientState(GL_NORMAL_ARRAY);
    entry::InterleavedArrays(GL_T2F_C4UB_V3F, 0, data);
    CHECK_FALSE(entry::IsEnabled(GL_NORMAL_ARRAY));
    CHECK(entry::IsEnabled(GL_TEXTURE_COORD_ARRAY));
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    const auto all = draws();
    CHECK(position(all[0], 2) == Value{13, 14, 15, 1});
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{1, 0, 0, 0.2f});
    CHECK(attribute(all[0], 1, Attribute::TexCoord0) == Value{6, 7, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "a draw too large for device memory at once is cut") {
    const NumberedVertices arrays(1500000);
    entry::DrawArrays(GL_LINE_STRIP, 0, 1500000);
    const auto all = draws();
    REQUIRE(all.size() > 1);
    std::uint32_t segments = 0;
    for (const DrawCommand& draw : all)
        segments += draw.count - 1;
    CHECK(segments == 1499999);
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "arrays and indices may lie in buffer objects") {
    const GLfloat positions[] = {9, 9, 0, 0, 1, 0, 2, 0};
    const GLushort indices[] = {7, 2, 1, 0};
    GLuint buffers[2] = {};
    entry::GenBuffers(2, buffers);
    entry::BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    entry::BufferData(GL_ARRAY_BUFFER, sizeof(positions), positions, GL_STATIC_DRAW);
    entry::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    entry::BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    const auto offset = [](std::uintptr_t bytes) { return reinterpret_cast<const void*>(bytes); };
    entry::VertexPointer(2, GL_FLOAT, 0, offset(8));
    entry::BindBuffer(GL_ARRAY_BUFFER, 0); // The pointer keeps its buffer.
    entry::DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, offset(2));
    auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{2, 1, 0});

    // Beyond the end: vertices read as zero, indices are an error.
    entry::DrawArrays(GL_TRIANGLES, 2, 3);
    all = draws();
    CHECK(names(all[0]) == std::vector<float>{2, 0, 0});
    entry::DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, offset(4));
    CHECK(error() == GL_INVALID_OPERATION);
    CHECK(draws().empty());
}

TEST_CASE_METHOD(DrawFixture, "buffers are written, read, copied and mapped") {
    entry::BindBuffer(GL_ARRAY_BUFFER, 5);
    const GLubyte data[] = {1, 2, 3, 4, 5, 6, 7, 8};
    entry::BufferData(GL_ARRAY_BUFFER, 8, data, GL_DYNAMIC_DRAW);
    const GLubyte two[] = {20, 30};
    entry::BufferSubData(GL_ARRAY_BUFFER, 1, 2, two);
    auto* mapped = static_cast<GLubyte*>(entry::MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE));
    REQUIRE(mapped);
    CHECK(mapped[2] == 30);
    mapped[7] = 80;
    entry::BufferSubData(GL_ARRAY_BUFFER, 0, 1, data);
    CHECK(error() == GL_INVALID_OPERATION); // It is mapped.
    void* pointer = nullptr;
    entry::GetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    CHECK(pointer == mapped);
    CHECK(entry::UnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE);
    CHECK(entry::UnmapBuffer(GL_ARRAY_BUFFER) == GL_FALSE);
    CHECK(error() == GL_INVALID_OPERATION);

    entry::CopyBufferSubData(GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, 6, 0, 2);
    GLubyte got[8] = {};
    entry::GetBufferSubData(GL_ARRAY_BUFFER, 0, 8, got);
    CHECK(got[0] == 7);
    CHECK(got[1] == 80);
    auto* part =
        static_cast<GLubyte*>(entry::MapBufferRange(GL_ARRAY_BUFFER, 2, 3, GL_MAP_WRITE_BIT));
    CHECK(part[0] == 30);
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "buffer commands report their errors") {
    GLubyte byte = 0;
    entry::BindBuffer(GL_TEXTURE_2D, 1);
    CHECK(error() == GL_INVALID_ENUM);
    entry::BufferData(GL_ARRAY_BUFFER, 1, &byte, GL_STATIC_DRAW);
    CHECK(error() == GL_INVALID_OPERATION);
    entry::BindBuffer(GL_ARRAY_BUFFER, 1);
    entry::BufferData(GL_ARRAY_BUFFER, -1, &byte, GL_STATIC_DRAW);
    CHECK(error() == GL_INVALID_VALUE);
    entry::BufferData(GL_ARRAY_BUFFER, 1, &byte, GL_FLOAT);
    CHECK(error() == GL_INVALID_ENUM);
    entry::BufferData(
        GL_ARRAY_BUFFER, std::numeric_limits<GLsizeiptr>::max(), nullptr, GL_STATIC_DRAW);
    CHECK(error() == GL_OUT_OF_MEMORY);
    entry::BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW);
    entry::BufferSubData(GL_ARRAY_BUFFER, 3, 2, &byte);
    CHECK(error() == GL_INVALID_VALUE);
    entry::BufferSubData(GL_ARRAY_BUFFER, -1, 1, &byte);
    CHECK(error() == GL_INVALID_VALUE);
    CHECK(entry::MapBuffer(GL_ARRAY_BUFFER, GL_STATIC_DRAW) == nullptr);
    CHECK(error() == GL_INVALID_ENUM);
    CHECK(entry::MapBufferRange(GL_ARRAY_BUFFER, 0, 5, GL_MAP_READ_BIT) == nullptr);
    CHECK(error() == GL_INVALID_VALUE);
    CHECK(entry::MapBufferRange(GL_ARRAY_BUFFER, 0, 4, 0) == nullptr);
    CHECK(error() == GL_INVALID_OPERATION);
    entry::CopyBufferSubData(GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, 0, 1, 2);
    CHECK(error() == GL_INVALID_VALUE); // They overlap.
}

TEST_CASE_METHOD(DrawFixture, "a deleted buffer is unbound everywhere") {
    entry::BindBuffer(GL_ARRAY_BUFFER, 1);
    entry::VertexPointer(2, GL_FLOAT, 0, nullptr);
    const GLuint name = 1;
    entry::DeleteBuffers(1, &name);
    GLint bound = -1;
    entry::GetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    CHECK(bound == 0);
    entry::GetIntegerv(GL_VERTEX_ARRAY_BUFFER_BINDING, &bound);
    CHECK(bound == 0);
    CHECK_FALSE(entry::IsBuffer(1));
}

TEST_CASE_METHOD(DrawFixture, "draws from a mapped buffer are errors") {
    entry::BindBuffer(GL_ARRAY_BUFFER, 1);
    entry::BufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
    entry::VertexPointer(2, GL_FLOAT, 0, nullptr);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    CHECK(error() == GL_INVALID_OPERATION);
    entry::UnmapBuffer(GL_ARRAY_BUFFER);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    CHECK(error() == GL_NO_ERROR);
    CHECK(draws().size() == 1);
}

TEST_CASE("A deleted array object that the client stack holds has its name again when popped") {
    DrawFixture f;
    GLuint object = 0;
    entry::GenVertexArrays(1, &object);
    entry::BindVertexArray(object);
    const GLfloat corners[3] = {};
    entry::VertexPointer(3, GL_FLOAT, 0, corners);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    entry::DeleteVertexArrays(1, &object);
    CHECK_FALSE(entry::IsVertexArray(object));
    CHECK_FALSE(entry::IsEnabled(GL_VERTEX_ARRAY));
    entry::PopClientAttrib();
    CHECK(entry::IsVertexArray(object));
    CHECK(entry::IsEnabled(GL_VERTEX_ARRAY));
    void* pointer = nullptr;
    entry::GetPointerv(GL_VERTEX_ARRAY_POINTER, &pointer);
    CHECK(pointer == corners);
    CHECK(f.error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "a vertex array object has pointers and enables of its own") {
    const NumberedVertices arrays(10);
    GLuint object = 0;
    entry::GenVertexArrays(1, &object);
    CHECK_FALSE(entry::IsVertexArray(object));
    entry::BindVertexArray(object);
    CHECK(entry::IsVertexArray(object));
    CHECK_FALSE(entry::IsEnabled(GL_VERTEX_ARRAY));
    entry::BindVertexArray(0);
    CHECK(entry::IsEnabled(GL_VERTEX_ARRAY));
    entry::BindVertexArray(object);
    entry::DeleteVertexArrays(1, &object);
    CHECK(entry::IsEnabled(GL_VERTEX_ARRAY)); // The default object is bound again.
    entry::BindVertexArray(object);
    CHECK(error() == GL_INVALID_OPERATION);
}

TEST_CASE_METHOD(DrawFixture, "array commands report their errors") {
    const NumberedVertices arrays(10);
    const GLubyte indices[3] = {};
    entry::VertexPointer(1, GL_FLOAT, 0, indices);
    CHECK(error() == GL_INVALID_VALUE);
    entry::VertexPointer(2, GL_UNSIGNED_BYTE, 0, indices);
    CHECK(error() == GL_INVALID_ENUM);
    entry::VertexPointer(2, GL_FLOAT, -4, indices);
    CHECK(error() == GL_INVALID_VALUE);
    entry::EnableClientState(GL_TEXTURE_2D);
    CHECK(error() == GL_INVALID_ENUM);
    entry::ClientActiveTexture(GL_TEXTURE0 + TextureUnits);
    CHECK(error() == GL_INVALID_ENUM);
    entry::DrawArrays(GL_POLYGON + 1, 0, 3);
    CHECK(error() == GL_INVALID_ENUM);
    entry::DrawArrays(GL_TRIANGLES, 0, -1);
    CHECK(error() == GL_INVALID_VALUE);
    entry::DrawArrays(GL_TRIANGLES, -1, 3);
    CHECK(error() == GL_INVALID_VALUE);
    entry::DrawElements(GL_TRIANGLES, 3, GL_FLOAT, indices);
    CHECK(error() == GL_INVALID_ENUM);
    entry::DrawRangeElements(GL_TRIANGLES, 2, 1, 3, GL_UNSIGNED_BYTE, indices);
    CHECK(error() == GL_INVALID_VALUE);
    entry::LockArraysEXT(0, 0);
    CHECK(error() == GL_INVALID_VALUE);
    entry::UnlockArraysEXT();
    CHECK(error() == GL_INVALID_OPERATION);
    CHECK(draws().empty());
}

TEST_CASE_METHOD(DrawFixture, "one negative count refuses all draws of glMultiDrawArrays") {
    const GLfloat positions[] = {0, 0, 1, 0, 2, 0};
    entry::VertexPointer(2, GL_FLOAT, 0, positions);
    entry::Enable(GL_VERTEX_ARRAY); // EXT_vertex_array
    CHECK(entry::IsEnabled(GL_VERTEX_ARRAY) == GL_TRUE);
    const GLint first[] = {0, 0};
    GLsizei count[] = {3, -1};
    entry::MultiDrawArrays(GL_TRIANGLES, first, count, 2);
    CHECK(error() == GL_INVALID_VALUE);
    CHECK(draws().empty());
    count[1] = 3;
    entry::MultiDrawArrays(GL_TRIANGLES, first, count, 2);
    CHECK(error() == GL_NO_ERROR);
    CHECK(draws().size() == 2);
    entry::Disable(GL_VERTEX_ARRAY);
    CHECK(entry::IsEnabled(GL_VERTEX_ARRAY) == GL_FALSE);
}
