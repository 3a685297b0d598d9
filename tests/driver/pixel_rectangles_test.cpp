// glDrawPixels, glBitmap, glCopyPixels, glReadPixels: what reaches the device, and what comes back.

#include "tests/driver/state_fixture.h"

#include <algorithm>
#include <cstring>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;

struct PixelFixture : StateFixture {
    PixelFixture() {
        PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        PixelStorei(GL_PACK_ALIGNMENT, 1);
        WindowPos2i(10, 5);
    }

    DrawImageCommand last_image() const {
        REQUIRE_FALSE(device.commands.empty());
        return device.commands.back().as<DrawImageCommand>();
    }
    Bytes memory(DeviceAddress at, std::size_t bytes) const {
        Bytes result(bytes);
        std::memcpy(result.data(), device.memory.data() + at, bytes);
        return result;
    }
    void set_pixel(const Surface& surface, unsigned x, unsigned y, std::uint32_t word) {
        std::memcpy(device.memory.data() + surface.address + y * surface.stride + 4 * x, &word, 4);
    }
};

} // namespace

TEST_CASE_METHOD(PixelFixture, "pixels are staged as r g b a and drawn at the raster position") {
    PixelZoom(2, -1);
    const Bytes pixels{1, 2, 3, 4, 5, 6};
    DrawPixels(1, 2, GL_BGR, GL_UNSIGNED_BYTE, pixels.data());
    const DrawImageCommand image = last_image();
    CHECK(image.format == Format::Rgba8);
    CHECK(image.width == 1);
    CHECK(image.height == 2);
    CHECK(image.x == 10);
    CHECK(image.y == 5);
    CHECK(image.zoom_x == 2);
    CHECK(image.zoom_y == -1);
    CHECK(memory(image.address, 8) == Bytes{3, 2, 1, 255, 6, 5, 4, 255});
}

TEST_CASE_METHOD(PixelFixture, "pixel transfer acts on the way") {
    PixelTransferf(GL_RED_SCALE, 0.5f);
    PixelTransferf(GL_BLUE_BIAS, 1);
    const Bytes pixel{200, 100, 0, 50};
    DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    CHECK(memory(last_image().address, 4) == Bytes{100, 100, 255, 50});
}

TEST_CASE_METHOD(PixelFixture, "colour indices go through the maps") {
    const GLfloat reds[2] = {0, 1};
    PixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, reds);
    const std::uint8_t bits = 0b01000000;
    DrawPixels(2, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
    CHECK(memory(last_image().address, 8) == Bytes{0, 0, 0, 0, 255, 0, 0, 0});
}

TEST_CASE_METHOD(PixelFixture, "depth and stencil are drawn in formats of their own") {
    const float depth = 0.5f;
    DrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    CHECK(last_image().format == Format::Depth24Stencil8);
    CHECK(memory(last_image().address, 4) == Bytes{0, 0, 0, 0x80}); // 0.5 (2^24 - 1), rounded.
    const std::uint8_t stencil = 77;
    PixelTransferi(GL_INDEX_OFFSET, 3);
    DrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    CHECK(last_image().format == Format::Stencil8);
    CHECK(memory(last_image().address, 1) == Bytes{80});
    device.forget();
    const std::uint32_t both = 0x800000'2a;
    DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &both);
    CHECK(std::count_if(device.commands.begin(), device.commands.end(), [](const auto& command) {
              return command.opcode == Opcode::DrawImage;
          }) == 2);
}

TEST_CASE_METHOD(PixelFixture, "depth and stencil together are written past all tests") {
    Enable(GL_ALPHA_TEST);
    AlphaFunc(GL_NEVER, 0);
    Enable(GL_STENCIL_TEST);
    const std::uint32_t both = 0x800000'2a;
    DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &both);
    CHECK(last_image().format == Format::Depth24Stencil8);
    const Registers& registers = device.registers;
    CHECK(registers.depth.test_enable);
    CHECK(registers.depth.compare == Compare::Always);
    CHECK(registers.depth.write_enable);
    CHECK(registers.blend.write_mask == 0);
    CHECK_FALSE(registers.stencil.enable);
    drawn();
    CHECK_FALSE(registers.depth.test_enable);
    CHECK(registers.blend.write_mask == 0xf);
    CHECK(registers.stencil.enable);
}

TEST_CASE_METHOD(PixelFixture, "a bitmap is drawn with its origin and moves the raster position") {
    const Bytes bits{0b10100000, 0b01000000};
    Bitmap(3, 2, 1.5f, 0.25f, 8, -2, bits.data());
    const DrawImageCommand image = last_image();
    CHECK(image.format == Format::Bitmap);
    CHECK(image.x == 8);
    CHECK(image.y == 4);
    CHECK(memory(image.address, 2) == Bytes{0b101, 0b010});
    CHECK(get_floats(GL_CURRENT_RASTER_POSITION, 2) == std::vector<GLfloat>{18, 3});
    device.forget();
    Bitmap(0, 0, 0, 0, 1, 0, nullptr);
    CHECK(device.commands.empty());
    CHECK(get_floats(GL_CURRENT_RASTER_POSITION, 1) == std::vector<GLfloat>{19});
}

TEST_CASE_METHOD(PixelFixture, "pixels are read as they are, and those outside are left alone") {
    const Surface& back = gl.drawable().back();
    set_pixel(back, 0, 0, 0x04030201);
    set_pixel(back, 1, 0, 0x08070605);
    Bytes pixels(3 * 4, 99);
    ReadPixels(-1, 0, 3, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CHECK(pixels == Bytes{99, 99, 99, 99, 1, 2, 3, 4, 5, 6, 7, 8});
    std::uint16_t packed = 0;
    set_pixel(back, 63, 47, 0xff0000ff);
    ReadPixels(63, 47, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, &packed);
    CHECK(packed == 31 << 11);
}

TEST_CASE_METHOD(PixelFixture, "inverted rows are read from the top, those outside left alone") {
    PixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);
    const Surface& back = gl.drawable().back();
    set_pixel(back, 5, 0, 0x04030201);
    set_pixel(back, 5, 1, 0x08070605);
    Bytes pixels(12, 99);
    ReadPixels(5, -1, 1, 3, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CHECK(pixels == Bytes{5, 6, 7, 8, 1, 2, 3, 4, 99, 99, 99, 99});
}

TEST_CASE_METHOD(PixelFixture, "depth and stencil are copied as colours") {
    set_pixel(gl.drawable().depth(), 3, 4, 0xabcdef12);
    CopyPixels(3, 4, 1, 1, GL_DEPTH_STENCIL_TO_RGBA_NV);
    CHECK(last_image().format == Format::Rgba8);
    CHECK(memory(last_image().address, 4) == Bytes{0xab, 0xcd, 0xef, 0x12});
    CopyPixels(3, 4, 1, 1, GL_DEPTH_STENCIL_TO_BGRA_NV);
    CHECK(memory(last_image().address, 4) == Bytes{0xef, 0xcd, 0xab, 0x12});
    PixelTransferi(GL_INDEX_OFFSET, 1); // They are depth and stencil on their way, not colours.
    PixelTransferf(GL_RED_SCALE, 0);
    CopyPixels(3, 4, 1, 1, GL_DEPTH_STENCIL_TO_RGBA_NV);
    CHECK(memory(last_image().address, 4) == Bytes{0xab, 0xcd, 0xef, 0x13});
}

TEST_CASE_METHOD(PixelFixture, "depth and stencil are read from their halves") {
    set_pixel(gl.drawable().depth(), 2, 3, 0xffffff'2a);
    float depth = 0;
    ReadPixels(2, 3, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    CHECK(depth == 1);
    std::uint8_t stencil = 0;
    ReadPixels(2, 3, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    CHECK(stencil == 42);
    std::uint32_t both = 0;
    ReadPixels(2, 3, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &both);
    CHECK(both == 0xffffff2a);
}

TEST_CASE_METHOD(PixelFixture, "a copy reads what lies inside and draws it where it belongs") {
    set_pixel(gl.drawable().back(), 0, 0, 0x04030201);
    PixelZoom(2, 2);
    CopyPixels(-3, 0, 4, 1, GL_COLOR);
    const DrawImageCommand image = last_image();
    CHECK(image.width == 1);
    CHECK(image.x == 10 + 2 * 3);
    CHECK(memory(image.address, 4) == Bytes{1, 2, 3, 4});
}

TEST_CASE_METHOD(PixelFixture,
                 "buffer objects serve as source and destination, within their size") {
    GLuint buffer = 0;
    GenBuffers(1, &buffer);
    BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    const Bytes pixels{0, 0, 0, 0, 9, 8, 7, 6};
    BufferData(GL_PIXEL_UNPACK_BUFFER, 8, pixels.data(), GL_STATIC_DRAW);
    const auto* const offset = reinterpret_cast<const void*>(std::uintptr_t{4});
    DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, offset);
    CHECK(memory(last_image().address, 4) == Bytes{9, 8, 7, 6});
    device.forget();
    DrawPixels(2, 1, GL_RGBA, GL_UNSIGNED_BYTE, offset);
    CHECK(GetError() == GL_INVALID_OPERATION);
    CHECK(device.commands.empty());
    BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    set_pixel(gl.drawable().back(), 0, 0, 0x04030201);
    ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    Bytes read(4);
    GetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, 4, read.data());
    CHECK(read == Bytes{1, 2, 3, 4});
}

TEST_CASE_METHOD(PixelFixture, "wrong arguments of pixel commands are the specified errors") {
    const auto draw = [](GLsizei width, GLenum format, GLenum type) {
        DrawPixels(width, 1, format, type, nullptr);
        return GetError();
    };
    CHECK(draw(-1, GL_RGBA, GL_UNSIGNED_BYTE) == GL_INVALID_VALUE);
    CHECK(draw(1, GL_TEXTURE, GL_UNSIGNED_BYTE) == GL_INVALID_ENUM);
    CHECK(draw(1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5) == GL_INVALID_OPERATION);
    CHECK(draw(1, GL_TEXTURE, GL_UNSIGNED_SHORT_5_6_5) == GL_INVALID_OPERATION);
    CHECK(draw(1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT) == GL_INVALID_ENUM);
    CopyPixels(0, 0, 1, 1, GL_RGBA);
    CHECK(GetError() == GL_INVALID_ENUM);
    ReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, nullptr);
    CHECK(GetError() == GL_INVALID_OPERATION);
    PixelStorei(GL_UNPACK_ALIGNMENT, 3);
    CHECK(GetError() == GL_INVALID_VALUE);
    PixelStorei(GL_PACK_SKIP_ROWS, -1);
    CHECK(GetError() == GL_INVALID_VALUE);
    const GLfloat entries[3] = {};
    PixelMapfv(GL_PIXEL_MAP_I_TO_I, 3, entries); // No power of two.
    CHECK(GetError() == GL_INVALID_VALUE);
    PixelMapfv(GL_PIXEL_MAP_R_TO_R, 3, entries);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(PixelFixture, "images larger than any memory are refused, not wrapped around") {
    const Bytes pixels(16);
    const GLsizei huge = 2147483647;
    DrawPixels(huge, huge, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CHECK(GetError() == GL_OUT_OF_MEMORY);
    Bitmap(huge, huge, 0, 0, 0, 0, pixels.data());
    CHECK(GetError() == GL_OUT_OF_MEMORY);
    CHECK(device.commands.empty());
}

TEST_CASE("without depth and stencil buffers their pixels are an error") {
    StateFixture fixture({.depth_bits = 0, .stencil_bits = 0});
    const float depth = 0;
    DrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    CHECK(GetError() == GL_INVALID_OPERATION);
    ReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, nullptr);
    CHECK(GetError() == GL_INVALID_OPERATION);
}
