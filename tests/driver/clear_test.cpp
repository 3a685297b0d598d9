// Clears, the accumulation buffer, flush and finish.

#include "tests/driver/state_fixture.h"

#include <algorithm>

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

using namespace entry;

struct ClearFixture : StateFixture {
    using StateFixture::StateFixture;

    std::byte* pixel(const Surface& surface, unsigned x, unsigned y) {
        return device.memory.data() + surface.address + y * surface.stride + 4 * x;
    }
    void fill(const Surface& surface, unsigned value) {
        for (unsigned y = 0; y < surface.height; ++y)
            std::fill_n(pixel(surface, 0, y), 4 * surface.width, static_cast<std::byte>(value));
    }
    std::vector<unsigned> read(const Surface& surface, unsigned x, unsigned y) {
        const std::byte* const at = pixel(surface, x, y);
        std::vector<unsigned> channels;
        for (unsigned i = 0; i < 4; ++i)
            channels.push_back(std::to_integer<unsigned>(at[i]));
        return channels;
    }
    const Surface& back() { return gl.drawable().back(); }
};

using Pixel = std::vector<unsigned>;

} // namespace

TEST_CASE("A clear carries the values in the targets' units") {
    ClearFixture f;
    ClearColor(1, 0, 0.5f, 0.25f);
    ClearDepth(0.5);
    ClearStencil(0x1a5);
    Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    const auto clear = f.device.commands.back().as<ClearCommand>();
    CHECK((clear.color && clear.depth && clear.stencil));
    CHECK(clear.color_value == 0x408000ffu);
    CHECK(clear.depth_value == 0x800000);
    CHECK(clear.stencil_value == 0xa5);
    CHECK(f.device.registers.scissor == ffgpu::Scissor{0, 0, 64, 48});
    CHECK(f.device.registers.targets.color[0] == f.back());
}

TEST_CASE("The depth mask keeps the depth buffer from being cleared") {
    ClearFixture f;
    DepthMask(GL_FALSE);
    Clear(GL_DEPTH_BUFFER_BIT);
    CHECK(f.device.commands.empty());
    Clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    CHECK(!f.device.commands.back().as<ClearCommand>().depth);
}

TEST_CASE("Buffers that the drawable lacks are not cleared") {
    ClearFixture f({.depth_bits = 16, .stencil_bits = 0, .accumulation = false});
    ClearDepth(0.5);
    Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    const auto clear = f.device.commands.back().as<ClearCommand>();
    CHECK(clear.depth);
    CHECK(clear.depth_value == 0x8000);
    CHECK(!clear.stencil);
    CHECK(GetError() == GL_NO_ERROR);
    Accum(GL_LOAD, 1);
    CHECK(GetError() == GL_INVALID_OPERATION);
}

TEST_CASE("In selection and feedback nothing is cleared") {
    ClearFixture f;
    GLuint buffer[16];
    SelectBuffer(16, buffer);
    RenderMode(GL_SELECT);
    f.device.forget();
    Clear(GL_COLOR_BUFFER_BIT);
    CHECK(f.device.commands.empty());
    RenderMode(GL_RENDER);
}

TEST_CASE("Frames accumulate and come back as their mean") {
    ClearFixture f;
    ClearAccum(0, 0, 0, 0);
    Clear(GL_ACCUM_BUFFER_BIT);
    for (const unsigned value : {40u, 80u, 120u, 160u}) {
        f.fill(f.back(), value);
        Accum(GL_ACCUM, 0.25f);
    }
    f.fill(f.back(), 0);
    Accum(GL_RETURN, 1);
    CHECK(f.read(f.back(), 0, 0) == Pixel{100, 100, 100, 100});
    CHECK(f.read(f.back(), 63, 47) == Pixel{100, 100, 100, 100});
}

TEST_CASE("Loading and returning keeps each colour") {
    ClearFixture f;
    for (unsigned i = 0; i < 256; ++i)
        std::fill_n(f.pixel(f.back(), i % 64, i / 64), 4, static_cast<std::byte>(i));
    Accum(GL_LOAD, 1);
    f.fill(f.back(), 7);
    Accum(GL_RETURN, 1);
    for (unsigned i = 0; i < 256; ++i)
        CHECK(f.read(f.back(), i % 64, i / 64) == Pixel{i, i, i, i});
}

TEST_CASE("Adding and multiplying saturate at one") {
    ClearFixture f;
    f.fill(f.back(), 51); // 0.2
    Accum(GL_LOAD, 1);
    Accum(GL_MULT, 2);
    Accum(GL_ADD, 0.2f);
    Accum(GL_RETURN, 1);
    CHECK(f.read(f.back(), 5, 5) == Pixel{153, 153, 153, 153});
    Accum(GL_ADD, 5);
    Accum(GL_ADD, -0.5f);
    Accum(GL_RETURN, 1);
    CHECK(f.read(f.back(), 5, 5)[0] == 128);
    Accum(GL_MULT, -1);
    Accum(GL_RETURN, 1);
    CHECK(f.read(f.back(), 5, 5)[0] == 0);
}

TEST_CASE("The accumulation buffer respects scissor and colour mask") {
    ClearFixture f;
    f.fill(f.back(), 200);
    Accum(GL_LOAD, 1);
    f.fill(f.back(), 10);
    Enable(GL_SCISSOR_TEST);
    Scissor(4, 5, 2, 1);
    ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    Accum(GL_RETURN, 1);
    CHECK(f.read(f.back(), 4, 5) == Pixel{200, 10, 200, 10});
    CHECK(f.read(f.back(), 5, 5) == Pixel{200, 10, 200, 10});
    CHECK(f.read(f.back(), 6, 5) == Pixel{10, 10, 10, 10});
    CHECK(f.read(f.back(), 4, 4) == Pixel{10, 10, 10, 10});
    ClearAccum(0.5f, 0.5f, 0.5f, 0.5f);
    Clear(GL_ACCUM_BUFFER_BIT);
    Disable(GL_SCISSOR_TEST);
    ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    Accum(GL_RETURN, 1);
    CHECK(f.read(f.back(), 4, 5)[0] == 128);
    CHECK(f.read(f.back(), 6, 5)[0] == 200);
}

TEST_CASE("The accumulation buffer reads from the read buffer and returns to the draw buffers") {
    ClearFixture f;
    f.fill(f.gl.drawable().front(), 30);
    f.fill(f.back(), 60);
    ReadBuffer(GL_FRONT);
    Accum(GL_LOAD, 1);
    f.fill(f.gl.drawable().front(), 0);
    DrawBuffer(GL_FRONT_AND_BACK);
    Accum(GL_RETURN, 2);
    CHECK(f.read(f.back(), 1, 1)[2] == 60);
    CHECK(f.read(f.gl.drawable().front(), 1, 1)[2] == 60);
}

TEST_CASE("A larger drawable keeps its picture in the lower left") {
    ClearFixture f;
    f.gl.drawable().resize(128, 96);
    const auto copy = f.device.commands.back().as<CopyRectangleCommand>();
    CHECK(copy.destination == f.gl.drawable().depth());
    CHECK(copy.width == 64);
    CHECK(copy.height == 48);
}

TEST_CASE("Drawables give their device memory back and refuse what does not fit") {
    RecordingDevice device(1u << 20);
    MemoryAllocator memory(0, device.memory_size());
    {
        Drawable drawable(device, memory, {}, 100, 100);
        const std::uint64_t used = memory.bytes_in_use();
        CHECK_THROWS_AS(drawable.resize(4000, 4000), std::bad_alloc);
        CHECK(memory.bytes_in_use() == used);
        CHECK(drawable.width() == 100);
    }
    CHECK(memory.bytes_in_use() == 0);
    CHECK_THROWS_AS(Drawable(device, memory, {}, 5000, 5000), std::bad_alloc);
    CHECK(memory.bytes_in_use() == 0);
}

TEST_CASE("glFinish waits for the device") {
    ClearFixture f;
    Finish();
    CHECK(f.device.finishes == 1);
}

} // namespace ffgpu::gl
