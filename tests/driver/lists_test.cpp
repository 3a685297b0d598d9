// Display lists: recorded commands, names, errors (GL 1.5, 5.4).

#include "tests/driver/list_calls.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;

TEST_CASE_METHOD(DrawFixture, "arrays of recorded commands are copied") {
    GLfloat matrix[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
    GLfloat ambient[4] = {0.5f, 0.25f, 0, 1};
    entry::NewList(1, GL_COMPILE);
    entry::LoadMatrixf(matrix);
    entry::Lightfv(GL_LIGHT2, GL_AMBIENT, ambient);
    entry::EndList();
    matrix[0] = ambient[0] = 9;
    entry::CallList(1);
    GLfloat got[16] = {};
    entry::GetFloatv(GL_MODELVIEW_MATRIX, got);
    CHECK(got[0] == 2);
    entry::GetLightfv(GL_LIGHT2, GL_AMBIENT, got);
    CHECK(got[0] == 0.5f);
    CHECK(got[1] == 0.25f);
}

TEST_CASE_METHOD(DrawFixture, "an image is recorded with the pixel store of its time") {
    // A 2 x 2 image within rows of four, the first of which is skipped.
    GLubyte texels[12];
    for (GLubyte i = 0; i < 12; ++i)
        texels[i] = i;
    entry::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    entry::PixelStorei(GL_UNPACK_ROW_LENGTH, 4);
    entry::PixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
    entry::PixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    entry::NewList(1, GL_COMPILE);
    entry::TexImage2D(
        GL_TEXTURE_2D, 0, GL_LUMINANCE8, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
    entry::EndList();
    entry::PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    entry::PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    std::fill(std::begin(texels), std::end(texels), GLubyte{99});
    entry::CallList(1);
    CHECK(get(GL_UNPACK_SKIP_ROWS) == 1); // As it was.
    GLubyte got[4] = {};
    entry::PixelStorei(GL_PACK_ALIGNMENT, 1);
    entry::GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, got);
    CHECK(got[0] == 5);
    CHECK(got[1] == 6);
    CHECK(got[2] == 9);
    CHECK(got[3] == 10);
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "a pixel map is recorded from the unpack buffer of its time") {
    const GLfloat maps[4] = {9, 9, 0.25f, 0.75f};
    const GLfloat other[4] = {1, 1, 1, 1};
    GLuint buffer = 0;
    entry::GenBuffers(1, &buffer);
    entry::BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    entry::BufferData(GL_PIXEL_UNPACK_BUFFER, sizeof maps, maps, GL_STATIC_DRAW);
    entry::NewList(1, GL_COMPILE);
    entry::PixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, reinterpret_cast<const GLfloat*>(8));
    entry::EndList();
    entry::BufferData(GL_PIXEL_UNPACK_BUFFER, sizeof other, other, GL_STATIC_DRAW);
    entry::CallList(1); // The record is in no buffer, though one is bound.
    entry::BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    GLfloat got[2] = {};
    entry::GetPixelMapfv(GL_PIXEL_MAP_R_TO_R, got);
    CHECK(got[0] == 0.25f);
    CHECK(got[1] == 0.75f);
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "vertex arrays are read when a list is compiled") {
    GLfloat positions[] = {0, 0, 1, 0, 2, 0};
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::VertexPointer(2, GL_FLOAT, 0, positions);
    entry::NewList(1, GL_COMPILE);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    entry::EndList();
    CHECK(draws().empty());
    positions[0] = 50;
    entry::DisableClientState(GL_VERTEX_ARRAY);
    entry::CallList(1);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2});
}

TEST_CASE_METHOD(DrawFixture, "an array draw with indices keeps them in a list") {
    std::vector<GLfloat> positions;
    for (int i = 0; i < 20; ++i)
        positions.insert(positions.end(), {static_cast<float>(i), 0});
    const GLubyte indices[] = {5, 7, 6, 6, 7, 8, 8, 7, 5};
    const GLsizei counts[] = {6, 3};
    const void* const parts[] = {indices, indices + 6};
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::VertexPointer(2, GL_FLOAT, 0, positions.data());
    entry::NewList(1, GL_COMPILE);
    entry::MultiDrawElements(GL_TRIANGLES, counts, GL_UNSIGNED_BYTE, parts, 2);
    entry::EndList();
    positions.clear();
    for (int call = 0; call < 2; ++call) {
        entry::CallList(1);
        const auto all = draws();
        REQUIRE(all.size() == 2);
        CHECK(names(all[0]) == std::vector<float>{5, 7, 6, 6, 7, 8});
        CHECK(names(all[1]) == std::vector<float>{8, 7, 5});
        for (const DrawCommand& draw : all) {
            CHECK(draw.index_type == IndexType::U16);
            CHECK(draw.vertex_count == 4);
        }
    }
    CHECK(error() == GL_NO_ERROR);

    // Far apart: drawn without, as outside of lists.
    positions.assign(2000, 1);
    const GLushort far[] = {0, 900, 450};
    entry::VertexPointer(2, GL_FLOAT, 0, positions.data());
    entry::NewList(2, GL_COMPILE);
    entry::DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, far);
    entry::EndList();
    entry::CallList(2);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(all[0].index_type == IndexType::None);
}

TEST_CASE_METHOD(DrawFixture, "an array draw in a list leaves the current attributes alone") {
    const GLfloat positions[] = {0, 0, 1, 0, 2, 0};
    const GLfloat colors[] = {1, 0, 0, 1, 0, 0, 1, 0, 0};
    entry::VertexPointer(2, GL_FLOAT, 0, positions);
    entry::ColorPointer(3, GL_FLOAT, 0, colors);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::EnableClientState(GL_COLOR_ARRAY);
    entry::NewList(1, GL_COMPILE);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    entry::EndList();
    entry::Color3f(0.25f, 0, 0);
    entry::CallList(1);
    CHECK(draws().size() == 1);
    CHECK(current_red() == 0.25f);

    // But what the list itself set before is current.
    entry::NewList(2, GL_COMPILE);
    entry::Color3f(0.5f, 0, 0);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    entry::EndList();
    entry::CallList(2);
    CHECK(draws().size() == 1);
    CHECK(current_red() == 0.5f);
}

TEST_CASE_METHOD(DrawFixture, "names of glCallLists have any of its types and the base added") {
    for (GLuint name = 300; name < 303; ++name) {
        entry::NewList(name, GL_COMPILE);
        entry::PointSize(static_cast<GLfloat>(name - 290));
        entry::EndList();
    }
    const auto called = [&](GLenum type, const void* names) {
        entry::PointSize(1);
        entry::CallLists(1, type, names);
        return get(GL_POINT_SIZE);
    };
    entry::ListBase(300);
    const GLubyte byte = 2;
    CHECK(called(GL_UNSIGNED_BYTE, &byte) == 12);
    const GLfloat real = 1.5f;
    CHECK(called(GL_FLOAT, &real) == 11);
    const GLubyte two[] = {0, 1};
    CHECK(called(GL_2_BYTES, two) == 11);
    entry::ListBase(303);
    const GLbyte negative = -1;
    CHECK(called(GL_BYTE, &negative) == 12);
    entry::ListBase(0);
    const GLubyte three[] = {0, 1, 45};
    CHECK(called(GL_3_BYTES, three) == 11);
    entry::CallLists(1, GL_DOUBLE, &byte);
    CHECK(error() == GL_INVALID_ENUM);
}

TEST_CASE_METHOD(DrawFixture, "a list that calls itself ends at the nesting limit") {
    entry::NewList(1, GL_COMPILE);
    entry::Translatef(1, 0, 0);
    entry::CallList(1);
    entry::EndList();
    entry::CallList(1);
    GLfloat matrix[16] = {};
    entry::GetFloatv(GL_MODELVIEW_MATRIX, matrix);
    CHECK(matrix[12] == 64);
}

TEST_CASE_METHOD(DrawFixture, "a list may be replaced or deleted; calling none does nothing") {
    entry::NewList(1, GL_COMPILE);
    triangle(0);
    entry::EndList();
    entry::NewList(1, GL_COMPILE);
    entry::CallList(1); // The new one, when it is executed: it nests until the limit.
    entry::EndList();
    entry::CallList(1);
    CHECK(draws().empty());
    entry::DeleteLists(1, 1);
    CHECK_FALSE(entry::IsList(1));
    entry::CallList(1);
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "the list commands report their errors") {
    entry::NewList(0, GL_COMPILE);
    CHECK(error() == GL_INVALID_VALUE);
    entry::NewList(1, GL_RENDER);
    CHECK(error() == GL_INVALID_ENUM);
    entry::EndList();
    CHECK(error() == GL_INVALID_OPERATION);
    entry::NewList(1, GL_COMPILE);
    entry::NewList(2, GL_COMPILE);
    CHECK(error() == GL_INVALID_OPERATION);
    entry::EndList();
    CHECK(entry::GenLists(-1) == 0);
    CHECK(error() == GL_INVALID_VALUE);
    entry::DeleteLists(1, -1);
    CHECK(error() == GL_INVALID_VALUE);
    entry::CallList(0);
    CHECK(error() == GL_INVALID_VALUE);
    const GLuint first = entry::GenLists(3);
    CHECK(entry::IsList(first + 2));
}

TEST_CASE_METHOD(DrawFixture, "errors of recorded commands come when the list is executed") {
    entry::NewList(1, GL_COMPILE);
    entry::PointSize(-1);
    entry::Begin(99);
    entry::EndList();
    CHECK(error() == GL_NO_ERROR);
    entry::CallList(1);
    CHECK(error() == GL_INVALID_VALUE);
}

TEST_CASE_METHOD(DrawFixture, "an array draw of a list errs between glBegin and glEnd") {
    const GLfloat positions[] = {0, 0, 1, 0, 2, 0};
    entry::VertexPointer(2, GL_FLOAT, 0, positions);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::NewList(1, GL_COMPILE);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    entry::EndList();
    entry::DisableClientState(GL_VERTEX_ARRAY);
    entry::NewList(2, GL_COMPILE); // Draws nothing.
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    entry::EndList();
    for (const GLuint list : {1u, 2u}) {
        entry::Begin(GL_TRIANGLES);
        entry::CallList(list);
        for (int i = 0; i < 3; ++i)
            entry::Vertex3f(static_cast<float>(10 + i), 0, 0);
        entry::End();
        CHECK(error() == GL_INVALID_OPERATION);
        const auto all = draws();
        REQUIRE(all.size() == 1);
        CHECK(names(all[0]) == std::vector<float>{10, 11, 12});
    }
}

TEST_CASE_METHOD(DrawFixture, "an array draw within a list's glBegin errs when it is executed") {
    entry::NewList(1, GL_COMPILE);
    entry::Begin(GL_TRIANGLES);
    entry::Vertex3f(0, 0, 0);
    entry::DrawArrays(GL_TRIANGLES, 0, 3);
    entry::Vertex3f(1, 0, 0);
    entry::Vertex3f(2, 0, 0);
    entry::End();
    entry::EndList();
    CHECK(error() == GL_NO_ERROR);
    entry::CallList(1);
    CHECK(error() == GL_INVALID_OPERATION);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2});
}
