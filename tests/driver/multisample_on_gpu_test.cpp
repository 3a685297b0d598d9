// Multisampling on the functional GPU: what is drawn on an edge, and what all ways of reading and
// writing pixels make of it.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr GLsizei Size = 16;

struct MultisampleOnGpu {
    MultisampleOnGpu()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Size, .height = Size, .format = {.samples = 4}}) {
        gl.make_current();
        PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        PixelStorei(GL_PACK_ALIGNMENT, 1);
        Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    ~MultisampleOnGpu() { CHECK(GetError() == GL_NO_ERROR); }

    static Bytes read(GLenum format = GL_RED) {
        Bytes pixels(std::size_t{Size} * Size * (format == GL_RGBA ? 4 : 1));
        ReadPixels(0, 0, Size, Size, format, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    // White on one side of a diagonal that leaves pixels partly covered.
    static void draw_edge() {
        Begin(GL_TRIANGLES);
        Vertex2f(-1, -1);
        Vertex2f(1, -1);
        Vertex2f(-1, 0.8f);
        End();
    }
    static void draw_all() { Recti(-1, -1, 1, 1); }
    static long partly_covered(const Bytes& pixels) {
        return std::count_if(
            pixels.begin(), pixels.end(), [](std::uint8_t v) { return v > 0 && v < 255; });
    }
    static bool all_are(const Bytes& pixels, unsigned value) {
        return std::all_of(
            pixels.begin(), pixels.end(), [=](std::uint8_t v) { return v == value; });
    }
    static GLuint make_framebuffer(GLsizei samples) {
        GLuint framebuffer = 0, names[2] = {};
        GenFramebuffers(1, &framebuffer);
        BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        GenRenderbuffers(2, names);
        BindRenderbuffer(GL_RENDERBUFFER, names[0]);
        RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, Size, Size);
        FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
        BindRenderbuffer(GL_RENDERBUFFER, names[1]);
        RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, Size, Size);
        FramebufferRenderbuffer(
            GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, names[1]);
        REQUIRE(CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
        return framebuffer;
    }
    static void blit(GLuint from, GLuint to, GLbitfield mask, bool mirrored = false) {
        BindFramebuffer(GL_READ_FRAMEBUFFER, from);
        BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
        BlitFramebuffer(
            0, 0, Size, Size, mirrored ? Size : 0, 0, mirrored ? 0 : Size, Size, mask, GL_NEAREST);
        BindFramebuffer(GL_READ_FRAMEBUFFER, to);
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

} // namespace

TEST_CASE_METHOD(MultisampleOnGpu, "an edge has colours between those of its sides") {
    draw_edge();
    const Bytes smooth = read();
    CHECK(partly_covered(smooth) >= Size / 2);
    for (const std::uint8_t value : smooth) // as many quarters as samples are covered
        CHECK((value == 0 || value == 64 || value == 128 || value == 191 || value == 255));
    Clear(GL_COLOR_BUFFER_BIT);
    Disable(GL_MULTISAMPLE);
    draw_edge();
    CHECK(partly_covered(read()) == 0);
}

TEST_CASE_METHOD(MultisampleOnGpu, "two triangles with a common edge leave no seam") {
    Begin(GL_TRIANGLE_STRIP);
    Vertex2f(-1, -1);
    Vertex2f(1, -1);
    Vertex2f(-1, 1);
    Vertex2f(1, 1);
    End();
    CHECK(all_are(read(), 255));
}

TEST_CASE_METHOD(MultisampleOnGpu, "a mask of samples scales what is drawn") {
    Enable(GL_SAMPLE_COVERAGE);
    SampleCoverage(0.5f, GL_FALSE);
    draw_all();
    CHECK(all_are(read(), 128));
    SampleCoverage(0.5f, GL_TRUE); // the other half
    draw_all();
    CHECK(all_are(read(), 255));
    Disable(GL_SAMPLE_COVERAGE);
    Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    Color4f(0, 0, 0, 0.25f);
    draw_all();
    CHECK(all_are(read(), 191));
}

TEST_CASE_METHOD(MultisampleOnGpu, "each sample has a depth of its own") {
    Enable(GL_DEPTH_TEST);
    draw_edge(); // at depth 0.5
    Color3f(0, 0, 0);
    DepthFunc(GL_EQUAL); // Only the samples that the edge covered are drawn again.
    draw_all();
    CHECK(all_are(read(), 0));
    DepthFunc(GL_LESS);
    Color3f(1, 1, 1);
    draw_all();
    CHECK(partly_covered(read()) >= Size / 2); // Only those that it did not cover.
}

TEST_CASE_METHOD(MultisampleOnGpu, "pixels that are written reach every sample") {
    std::mt19937 random(5);
    Bytes pixels(std::size_t{Size} * Size * 4), stencils(std::size_t{Size} * Size);
    std::vector<GLfloat> depths(stencils.size());
    for (std::uint8_t& value : pixels)
        value = static_cast<std::uint8_t>(random() >> 8);
    for (std::uint8_t& value : stencils)
        value = static_cast<std::uint8_t>(random() >> 8);
    for (GLfloat& depth : depths)
        depth = static_cast<GLfloat>(random() >> 8) / 16777216.0f;
    RasterPos2i(-1, -1);
    DrawPixels(Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CHECK(read(GL_RGBA) == pixels);
    DrawPixels(Size, Size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
    CHECK(read(GL_STENCIL_INDEX) == stencils);

    // Each sample's stencil is what was written: those of another are not drawn.
    Enable(GL_STENCIL_TEST);
    StencilFunc(GL_NOTEQUAL, stencils[0], 0xff);
    Clear(GL_COLOR_BUFFER_BIT);
    draw_all();
    const Bytes drawn = read();
    for (std::size_t i = 0; i < drawn.size(); ++i)
        CHECK(drawn[i] == (stencils[i] == stencils[0] ? 0 : 255));
    Disable(GL_STENCIL_TEST);

    ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    Enable(GL_DEPTH_TEST);
    DepthFunc(GL_ALWAYS);
    DrawPixels(Size, Size, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    std::vector<GLfloat> back(depths.size());
    ReadPixels(0, 0, Size, Size, GL_DEPTH_COMPONENT, GL_FLOAT, back.data());
    for (std::size_t i = 0; i < back.size(); ++i)
        CHECK(std::abs(back[i] - depths[i]) < 1e-6f);
}

TEST_CASE_METHOD(MultisampleOnGpu, "all ways of reading see the same resolved picture") {
    draw_edge();
    const Bytes picture = read(GL_RGBA);

    CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, Size, Size, 0);
    Bytes texels(picture.size());
    GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    CHECK(texels == picture);

    Accum(GL_LOAD, 1);
    Clear(GL_COLOR_BUFFER_BIT);
    Accum(GL_RETURN, 1);
    CHECK(read(GL_RGBA) == picture);

    RasterPos2i(-1, -1);
    DrawBuffer(GL_FRONT);
    CopyPixels(0, 0, Size, Size, GL_COLOR);
    ReadBuffer(GL_FRONT);
    CHECK(read(GL_RGBA) == picture);

    const GLuint single = make_framebuffer(0);
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    ReadBuffer(GL_BACK);
    blit(0, single, GL_COLOR_BUFFER_BIT);
    CHECK(read(GL_RGBA) == picture);
}

TEST_CASE_METHOD(MultisampleOnGpu, "swaps and sizes keep the samples") {
    draw_edge();
    const Bytes picture = read(GL_RGBA);
    gl.drawable().swap(SwapMode::Copy);
    ReadBuffer(GL_FRONT);
    CHECK(read(GL_RGBA) == picture);
    gl.drawable().resize(Size + 5, Size + 9);
    CHECK(read(GL_RGBA) == picture);
    // The rest of the edge's pixels is still to be drawn.
    DrawBuffer(GL_FRONT);
    Enable(GL_BLEND);
    BlendFunc(GL_ONE_MINUS_DST_COLOR, GL_ZERO);
    draw_all(); // inverts every sample
    Bytes inverted = read();
    for (std::size_t i = 0; i < inverted.size(); ++i)
        CHECK(std::abs(255 - inverted[i] - picture[4 * i]) <= 1);
}

TEST_CASE_METHOD(MultisampleOnGpu, "blits resolve, copy and spread samples") {
    const GLuint single = make_framebuffer(0), other = make_framebuffer(0);
    const GLuint many = make_framebuffer(4), more = make_framebuffer(2);
    constexpr GLbitfield All = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    BindFramebuffer(GL_FRAMEBUFFER, many);
    Clear(All);
    draw_edge();
    blit(many, more, All);
    blit(more, single, All);
    const Bytes resolved = read(GL_RGBA);
    CHECK(partly_covered(read()) >= Size / 2);
    blit(single, more, All); // every sample is the pixel's average now
    blit(more, other, All);
    CHECK(read(GL_RGBA) == resolved);

    const auto check_mirrored = [&](const Bytes& pixels) {
        for (std::size_t y = 0; y < Size; ++y)
            for (std::size_t x = 0; x < Size; ++x)
                CHECK(pixels[4 * (y * Size + x)] == resolved[4 * (y * Size + Size - 1 - x)]);
    };
    blit(many, other, All, true);
    check_mirrored(read(GL_RGBA));
    blit(many, more, All, true);
    blit(more, other, All);
    check_mirrored(read(GL_RGBA));
    blit(single, more, All, true);
    blit(more, other, All);
    check_mirrored(read(GL_RGBA));
}
