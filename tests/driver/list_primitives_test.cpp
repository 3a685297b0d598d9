// Display lists: the primitives in them (GL 1.5, 5.4).

#include "tests/driver/list_calls.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;
using Value = std::array<float, 4>;

TEST_CASE_METHOD(DrawFixture, "a compiled list draws when it is called, as often as it is") {
    entry::NewList(1, GL_COMPILE);
    triangle(10);
    entry::EndList();
    CHECK(draws().empty());
    for (int i = 0; i < 2; ++i) {
        entry::CallList(1);
        const auto all = draws();
        REQUIRE(all.size() == 1);
        CHECK(names(all[0]) == std::vector<float>{10, 11, 12});
    }
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "GL_COMPILE_AND_EXECUTE draws at once and later") {
    entry::NewList(1, GL_COMPILE_AND_EXECUTE);
    entry::Color3f(0.5f, 0, 0);
    triangle(0);
    entry::EndList();
    CHECK(draws().size() == 1);
    CHECK(current_red() == 0.5f);
    entry::Color3f(0, 0, 0);
    entry::CallList(1);
    CHECK(draws().size() == 1);
    CHECK(current_red() == 0.5f);
}

TEST_CASE_METHOD(DrawFixture, "primitives without a command between them become one draw") {
    entry::NewList(1, GL_COMPILE);
    entry::Normal3f(0, 0, 1);
    for (int i = 0; i < 10; ++i) {
        entry::Normal3f(0, static_cast<float>(i), 0);
        triangle(static_cast<float>(3 * i));
    }
    entry::EndList();
    entry::CallList(1);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(all[0].count == 30);
    CHECK(attribute(all[0], 29, Attribute::Normal) == Value{0, 9, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "a list's vertices stay in device memory") {
    entry::NewList(1, GL_COMPILE);
    triangle(0);
    entry::EndList();
    entry::CallList(1);
    const DeviceAddress first = draws()[0].vertex_address;
    const std::uint64_t used = gl.shared()->memory->bytes_in_use();
    entry::CallList(1);
    CHECK(draws()[0].vertex_address == first);
    CHECK(gl.shared()->memory->bytes_in_use() == used);
    entry::DeleteLists(1, 1);
    CHECK(gl.shared()->memory->bytes_in_use() < used);
}

TEST_CASE_METHOD(DrawFixture,
                 "vertices before a list's first colour take the one that is current") {
    entry::NewList(1, GL_COMPILE);
    entry::Begin(GL_TRIANGLES);
    entry::Vertex2f(0, 0);
    entry::Vertex2f(1, 0);
    entry::Color3f(0, 1, 0);
    entry::Vertex2f(2, 0);
    entry::End();
    entry::EndList();
    for (const float red : {0.25f, 0.75f}) {
        entry::Color4f(red, 0, 0, 0.5f);
        entry::CallList(1);
        const auto all = draws();
        REQUIRE(all.size() == 1);
        CHECK(attribute(all[0], 1, Attribute::Color)[0] == red);
        CHECK(attribute(all[0], 2, Attribute::Color) == Value{0, 1, 0, 1});
    }
}

TEST_CASE_METHOD(DrawFixture, "attributes that a list sets are current after it") {
    entry::NewList(1, GL_COMPILE);
    entry::Color3f(0.25f, 0, 0);
    triangle(0);
    entry::Color3f(0.5f, 0, 0);
    triangle(3);
    entry::EndList();
    entry::CallList(1);
    CHECK(current_red() == 0.5f);
    entry::NewList(2, GL_COMPILE);
    entry::Color3f(0.125f, 0, 0);
    entry::EndList();
    entry::CallList(2);
    CHECK(current_red() == 0.125f);
}

TEST_CASE_METHOD(DrawFixture, "a list may hold vertices whose glBegin is outside of it") {
    entry::NewList(1, GL_COMPILE);
    entry::Color3f(0, 0, 1);
    for (int i = 0; i < 3; ++i)
        entry::Vertex3f(static_cast<float>(i), 0, 0);
    entry::EndList();
    entry::Begin(GL_TRIANGLES);
    entry::CallList(1);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2});
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{0, 0, 1, 1});
}

TEST_CASE_METHOD(DrawFixture, "a list may begin a primitive that ends outside of it") {
    entry::NewList(1, GL_COMPILE);
    triangle(100);
    entry::Begin(GL_TRIANGLES);
    entry::Color3f(1, 0, 0);
    entry::Vertex2f(0, 0);
    entry::EndList();
    entry::CallList(1);
    entry::Vertex2f(1, 0);
    entry::Vertex2f(2, 0);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(names(all[1]) == std::vector<float>{0, 1, 2});
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "a list called inside a primitive of a list adds its vertices") {
    entry::NewList(1, GL_COMPILE);
    entry::Vertex2f(1, 0);
    entry::EndList();
    entry::NewList(2, GL_COMPILE);
    entry::Begin(GL_TRIANGLES);
    entry::Vertex2f(0, 0);
    entry::CallList(1);
    entry::Vertex2f(2, 0);
    entry::End();
    entry::EndList();
    entry::CallList(2);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2});
}

TEST_CASE_METHOD(DrawFixture, "a whole primitive of a list is an error inside another") {
    entry::NewList(1, GL_COMPILE);
    triangle(0);
    entry::EndList();
    entry::Begin(GL_TRIANGLES);
    entry::CallList(1);
    CHECK(draws().size() == 1); // The list's glEnd ended it.
    CHECK(error() == GL_INVALID_OPERATION);
    entry::End();
    CHECK(error() == GL_INVALID_OPERATION);
}

TEST_CASE_METHOD(DrawFixture, "state commands keep their place between a list's primitives") {
    entry::NewList(1, GL_COMPILE);
    entry::PointSize(2);
    triangle(0);
    entry::PointSize(3);
    triangle(3);
    entry::EndList();
    entry::PointSize(1);
    CHECK(get(GL_POINT_SIZE) == 1);
    entry::CallList(1);
    CHECK(get(GL_POINT_SIZE) == 3);
    CHECK(draws().size() == 2);
}
