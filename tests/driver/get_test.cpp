// glGet's conversions, capabilities, strings.

#include "tests/driver/state_fixture.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

namespace ffgpu::gl {

using namespace entry;

TEST_CASE("No name stands twice in the table of state variables") {
    const auto all = state_variables();
    for (std::size_t i = 1; i < all.size(); ++i)
        CHECK(all[i - 1].name < all[i].name);
    for (const StateVariable& variable : all)
        CHECK(find_capability(variable.name) == nullptr);
}

TEST_CASE("A name that glGet does not know is an invalid enumerant and writes nothing") {
    StateFixture f;
    GLint value = 42;
    GetIntegerv(0xdead, &value);
    CHECK(GetError() == GL_INVALID_ENUM);
    CHECK(value == 42);
    CHECK(IsEnabled(0xdead) == GL_FALSE);
    CHECK(GetError() == GL_INVALID_ENUM);
    Enable(GL_LIGHT0 + 8);
    CHECK(GetError() == GL_INVALID_ENUM);
}

TEST_CASE("A stencil reference is told as it is compared") {
    StateFixture f;
    for (const auto& [set, told] : {std::pair{300, 255}, {-5, 0}, {7, 7}}) {
        StencilFunc(GL_ALWAYS, set, 0xff);
        GLint value = -1;
        GetIntegerv(GL_STENCIL_REF, &value);
        CHECK(value == told);
    }
}

TEST_CASE("Colours and depths become the full range of integers, other floats are rounded") {
    StateFixture f;
    ClearColor(1, 0, 0.5f, 1);
    GLint color[4];
    GetIntegerv(GL_COLOR_CLEAR_VALUE, color);
    CHECK(color[0] == std::numeric_limits<GLint>::max());
    CHECK((color[1] == 0 || color[1] == -1));
    CHECK(std::abs(color[2] - (1 << 30)) <= 1);
    Normal3f(-1, 0, 1);
    GLint normal[3];
    GetIntegerv(GL_CURRENT_NORMAL, normal);
    CHECK(normal[0] == std::numeric_limits<GLint>::min());
    CHECK(normal[2] == std::numeric_limits<GLint>::max());
    GLint range[2];
    GetIntegerv(GL_DEPTH_RANGE, range);
    CHECK(range[1] == std::numeric_limits<GLint>::max());

    PointSize(2.5f);
    CHECK(get_int(GL_POINT_SIZE) == 3);
    LineWidth(2.4f);
    CHECK(get_int(GL_LINE_WIDTH) == 2);
    CHECK(get_int(GL_STENCIL_VALUE_MASK) == -1);
    StencilMask(0x80000001u);
    CHECK(get_int(GL_STENCIL_WRITEMASK) == static_cast<GLint>(0x80000001u));
    CHECK(get_floats(GL_STENCIL_WRITEMASK, 1)[0] == 2147483648.0f);
}

TEST_CASE("Capabilities are told by glIsEnabled and by glGet alike") {
    StateFixture f;
    for (const Capability& capability : capabilities()) {
        for (GLenum i = 0; i < capability.count; ++i) {
            const GLenum name = capability.name + i;
            INFO("capability " << std::hex << name);
            const bool before = IsEnabled(name) == GL_TRUE;
            CHECK(before == (name == GL_DITHER || name == GL_MULTISAMPLE));
            before ? Disable(name) : Enable(name);
            CHECK((IsEnabled(name) == GL_TRUE) == !before);
            CHECK((get_int(name) == 1) == !before);
            CHECK(GetError() == GL_NO_ERROR);
        }
    }
}

TEST_CASE("Texture capabilities belong to the active unit") {
    StateFixture f;
    ActiveTexture(GL_TEXTURE3);
    Enable(GL_TEXTURE_2D);
    Enable(GL_TEXTURE_GEN_T);
    ActiveTexture(GL_TEXTURE0);
    CHECK(IsEnabled(GL_TEXTURE_2D) == GL_FALSE);
    CHECK(IsEnabled(GL_TEXTURE_GEN_T) == GL_FALSE);
    ActiveTexture(GL_TEXTURE3);
    CHECK(IsEnabled(GL_TEXTURE_2D) == GL_TRUE);
    CHECK(IsEnabled(GL_TEXTURE_GEN_T) == GL_TRUE);
}

TEST_CASE("The compressed formats listed are as many as their number says") {
    StateFixture f;
    GLint formats[16] = {};
    GetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, formats);
    CHECK(get_int(GL_NUM_COMPRESSED_TEXTURE_FORMATS) == 5);
    CHECK(formats[0] == GL_COMPRESSED_RGB_S3TC_DXT1_EXT);
    CHECK(formats[2] == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT);
    CHECK(formats[4] == GL_COMPRESSED_RGBA_FXT1_3DFX);
    CHECK(formats[5] == 0);
}

TEST_CASE("A drawable without back, alpha, depth and accumulation buffers says so") {
    StateFixture f({.double_buffer = false,
                    .alpha = false,
                    .depth_bits = 0,
                    .stencil_bits = 0,
                    .accumulation = false});
    CHECK(get_int(GL_DOUBLEBUFFER) == 0);
    CHECK(get_int(GL_DRAW_BUFFER) == GL_FRONT);
    CHECK(get_int(GL_READ_BUFFER) == GL_FRONT);
    for (const int name : {GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS, GL_ACCUM_GREEN_BITS})
        CHECK(get_int(static_cast<GLenum>(name)) == 0);
}

TEST_CASE("The strings name version 1.5 and each extension once") {
    StateFixture f;
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(GetString(name)));
    };
    CHECK(text(GL_VERSION).rfind("1.5 ", 0) == 0);
    CHECK(text(GL_VENDOR) == "ffgpu");
    CHECK(!text(GL_RENDERER).empty());
    const std::string extensions = text(GL_EXTENSIONS);
    CHECK(extensions.find(" GL_ARB_multitexture ") != std::string::npos);
    CHECK(extensions.find("  ") == std::string::npos);
    CHECK(GetString(GL_SHADING_LANGUAGE_VERSION) == nullptr);
    CHECK(GetError() == GL_INVALID_ENUM);
}

} // namespace ffgpu::gl
