// What of the application's arrays goes to the device.

#include "tests/driver/draw_fixture.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;

TEST_CASE_METHOD(DrawFixture, "a vertex takes the words of its arrays' components, no more") {
    const std::vector<float> positions(6), colors(12), coordinates(6), normals(9);
    entry::EnableClientState(GL_VERTEX_ARRAY);
    entry::VertexPointer(2, GL_FLOAT, 0, positions.data());
    const auto stride = [&] {
        entry::DrawArrays(GL_TRIANGLES, 0, 3);
        CHECK(draws().size() == 1);
        return int{device.registers.vertex_format.stride};
    };
    CHECK(stride() == 2);
    entry::EnableClientState(GL_COLOR_ARRAY);
    entry::ColorPointer(4, GL_FLOAT, 0, colors.data());
    CHECK(stride() == 2 + 4);
    entry::EnableClientState(GL_TEXTURE_COORD_ARRAY);
    entry::TexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
    CHECK(stride() == 2 + 4 + 2);
    entry::EnableClientState(GL_NORMAL_ARRAY);
    entry::NormalPointer(GL_FLOAT, 0, normals.data());
    CHECK(stride() == 2 + 4 + 2 + 3);
}
