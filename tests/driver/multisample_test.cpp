// Multisampled windows and renderbuffers: what is drawn to, what is read, what the commands say.
// (Their pixels are looked at in multisample_on_gpu_test.cpp.)

#include "driver/lower/fragment.h"
#include "driver/objects/framebuffer_object.h"
#include "tests/driver/state_fixture.h"

#include <algorithm>
#include <cstring>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

struct MultisampleFixture : StateFixture {
    MultisampleFixture()
        : StateFixture({.samples = 4}) {}

    Drawable& window() { return gl.drawable(); }

    // The copies that the device was told to make since the last call.
    std::vector<CopyRectangleCommand> copies() {
        std::vector<CopyRectangleCommand> all;
        for (const auto& command : device.commands)
            if (command.opcode == Opcode::CopyRectangle)
                all.push_back(command.as<CopyRectangleCommand>());
        device.forget();
        return all;
    }

    static std::uint32_t read_color() {
        std::uint32_t pixel = 0;
        ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
        return pixel;
    }
    static void draw() { Recti(-1, -1, 1, 1); }

    // Of a framebuffer object that becomes current; samples 0 is a plain one.
    static GLuint attach_renderbuffer(GLenum point, GLenum internal, GLsizei samples) {
        GLuint name = 0;
        GenRenderbuffers(1, &name);
        BindRenderbuffer(GL_RENDERBUFFER, name);
        RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal, 16, 16);
        FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
        return name;
    }
    static GLuint bind_framebuffer(GLenum internal, GLsizei samples) {
        GLuint name = 0;
        GenFramebuffers(1, &name);
        BindFramebuffer(GL_FRAMEBUFFER, name);
        attach_renderbuffer(GL_COLOR_ATTACHMENT0, internal, samples);
        return name;
    }
    static GLenum status() { return CheckFramebufferStatus(GL_FRAMEBUFFER); }
    static GLint stored_samples(GLsizei asked) {
        GLint samples = -1;
        RenderbufferStorageMultisample(GL_RENDERBUFFER, asked, GL_RGBA8, 4, 4);
        GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
        return samples;
    }
};

} // namespace

TEST_CASE_METHOD(MultisampleFixture, "a multisampled window is drawn to in four planes") {
    const Targets targets = drawn().targets;
    CHECK(targets.color[0] == window().back());
    CHECK(targets.color[0].samples == 4);
    CHECK(targets.depth.samples == 4);
    CHECK(window().front().address - window().back().address != 0);
    CHECK(window().readable_back().samples == 1);
    CHECK(window().readable_depth().address == window().depth().address);
    CHECK(window().readable_depth().samples == 1);
    CHECK(get_int(GL_SAMPLE_BUFFERS) == 1);
    CHECK(get_int(GL_SAMPLES) == 4);
}

TEST_CASE("a single-sampled window is read where it was drawn to") {
    StateFixture f;
    CHECK(f.drawn().targets.color[0].samples == 1);
    CHECK(f.gl.drawable().readable_back() == f.gl.drawable().back());
    CHECK(f.gl.drawable().readable_front() == f.gl.drawable().front());
    CHECK(f.gl.drawable().readable_depth() == f.gl.drawable().depth());
    CHECK(get_int(GL_SAMPLE_BUFFERS) == 0);
    CHECK(get_int(GL_SAMPLES) == 0);
    CHECK(get_int(GL_MAX_SAMPLES) == 4);
}

TEST_CASE_METHOD(MultisampleFixture, "pixels are resolved when something was drawn since") {
    read_color();
    auto made = copies();
    REQUIRE(made.size() == 1);
    CHECK(made[0].source == window().back());
    CHECK(made[0].destination.samples == 1);
    CHECK(made[0].width == 64);
    CHECK(made[0].height == 48);
    read_color();
    CHECK(copies().empty());
    draw();
    read_color();
    CHECK(copies().size() == 1);
    Clear(GL_COLOR_BUFFER_BIT);
    read_color();
    CHECK(copies().size() == 1);
    ReadBuffer(GL_FRONT);
    read_color();
    made = copies();
    REQUIRE(made.size() == 1);
    CHECK(made[0].source == window().front());
}

TEST_CASE_METHOD(MultisampleFixture, "a swap takes the resolved picture along") {
    draw();
    read_color();
    copies();
    window().swap(SwapMode::Exchange);
    window().readable_front();
    CHECK(copies().empty());
    window().readable_back();
    CHECK(copies().size() == 1);
}

TEST_CASE_METHOD(MultisampleFixture, "what is read is the resolved surface's memory") {
    const Surface resolved = window().readable_back();
    const std::uint32_t color = 0x44332211;
    std::memcpy(device.memory.data() + resolved.address, &color, 4);
    CHECK(read_color() == color);
    const std::uint32_t depth = 0xffffff'5a; // of sample 0
    std::memcpy(device.memory.data() + window().depth().address, &depth, 4);
    GLubyte stencil = 0;
    GLuint read_depth = 0;
    ReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &read_depth);
    CHECK(stencil == 0x5a);
    CHECK(read_depth == 0xffffffff);
}

TEST_CASE_METHOD(MultisampleFixture, "a window that is resized keeps all samples") {
    copies();
    window().resize(100, 20);
    for (const CopyRectangleCommand& copy : copies()) {
        CHECK(copy.source.samples == 4);
        CHECK(copy.destination.samples == 4);
        CHECK(copy.width == 64);
        CHECK(copy.height == 20);
    }
    CHECK(window().back().width == 100);
    CHECK(window().readable_back().width == 100);
    CHECK(copies().size() == 1);
}

TEST_CASE_METHOD(MultisampleFixture, "a resolved picture does not outlive its buffers") {
    const DeviceAddress before = window().back().address;
    window().readable_back();
    window().resize(65, 48);
    window().resize(64, 48);
    REQUIRE(window().back().address == before); // The memory is used again.
    copies();
    window().readable_back();
    CHECK(copies().size() == 1);
}

TEST_CASE("only multisampled drawables take memory for samples") {
    RecordingDevice device;
    MemoryAllocator memory(0, device.memory_size());
    const Drawable single(device, memory, {}, 16, 16);
    const std::uint64_t of_single = memory.bytes_in_use();
    CHECK(of_single == 3 * 16 * 16 * 4);
    const Drawable multisampled(device, memory, {.samples = 4}, 16, 16);
    CHECK(memory.bytes_in_use() - of_single == 4 * of_single + 16 * 16 * 4);
}

TEST_CASE("GL_SAMPLE_COVERAGE lets as many samples through as its value says") {
    MultisampleState gl;
    CHECK(lower_multisample(gl) == Multisample{.enable = true});
    gl.coverage_value = 0.5f;
    CHECK(lower_multisample(gl).sample_mask == 0xf); // It is not enabled.
    gl.sample_coverage = true;
    for (const auto& [value, mask] : {std::pair{0.0f, 0},
                                      {0.12f, 0},
                                      {0.125f, 1},
                                      {0.25f, 1},
                                      {0.5f, 3},
                                      {0.75f, 7},
                                      {0.87f, 7},
                                      {0.875f, 15},
                                      {1.0f, 15}}) {
        gl.coverage_value = value;
        gl.coverage_invert = false;
        CHECK(lower_multisample(gl).sample_mask == mask);
        gl.coverage_invert = true;
        CHECK(lower_multisample(gl).sample_mask == (~mask & 0xf));
    }
    gl.enable = false;
    gl.alpha_to_coverage = gl.alpha_to_one = true;
    CHECK(lower_multisample(gl) == Multisample{});
}

TEST_CASE_METHOD(MultisampleFixture, "multisample state reaches the register, and comes back") {
    CHECK(drawn().multisample == Multisample{.enable = true});
    PushAttrib(GL_MULTISAMPLE_BIT);
    Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    CHECK(drawn().multisample.alpha_to_coverage);
    Enable(GL_SAMPLE_ALPHA_TO_ONE);
    CHECK(drawn().multisample.alpha_to_one);
    Enable(GL_SAMPLE_COVERAGE);
    SampleCoverage(0.25f, GL_TRUE);
    CHECK(drawn().multisample.sample_mask == 0xe);
    Disable(GL_MULTISAMPLE);
    CHECK(drawn().multisample == Multisample{});
    PopAttrib();
    CHECK(drawn().multisample == Multisample{.enable = true});
}

TEST_CASE_METHOD(MultisampleFixture, "renderbuffers have none or four samples") {
    GLuint name = 0;
    GenRenderbuffers(1, &name);
    BindRenderbuffer(GL_RENDERBUFFER, name);
    CHECK(stored_samples(0) == 0);
    for (const GLsizei asked : {1, 2, 3, 4})
        CHECK(stored_samples(asked) == 4);
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(stored_samples(5) == 4); // as before
    CHECK(GetError() == GL_INVALID_VALUE);
    RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4);
    GLint samples = -1;
    GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
    CHECK(samples == 0);
}

TEST_CASE_METHOD(MultisampleFixture, "images of a framebuffer object have equally many samples") {
    bind_framebuffer(GL_RGBA8, 4);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    CHECK(drawn().targets.color[0].samples == 4);
    CHECK(get_int(GL_SAMPLE_BUFFERS) == 1);
    CHECK(get_int(GL_SAMPLES) == 4);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 2);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    CHECK(drawn().targets.depth.samples == 4);
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 0);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    CHECK(get_int(GL_SAMPLE_BUFFERS) == 0);
    attach_renderbuffer(GL_COLOR_ATTACHMENT1, GL_RGBA8, 4);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
}

TEST_CASE_METHOD(MultisampleFixture, "planes of a renderbuffer lie one behind the other") {
    bind_framebuffer(GL_RGB5, 4);
    const Surface surface = drawn().targets.color[0];
    CHECK(surface.format == Format::Rgb565);
    CHECK(surface.plane(3).address - surface.address == 3 * 16 * 16 * 2);
    CHECK(surface.bytes() == 4 * 16 * 16 * 2);
}

TEST_CASE_METHOD(MultisampleFixture,
                 "pixels of multisampled framebuffer objects are not read one by one") {
    bind_framebuffer(GL_RGBA8, 4);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 4);
    GLubyte pixel[4] = {};
    check_refused(GL_INVALID_OPERATION,
                  [&] { ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel); });
    check_refused(GL_INVALID_OPERATION,
                  [&] { ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, pixel); });
    check_refused(GL_INVALID_OPERATION, [] { CopyPixels(0, 0, 1, 1, GL_COLOR); });
    check_refused(GL_INVALID_OPERATION,
                  [] { CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0); });
    BindFramebuffer(GL_READ_FRAMEBUFFER, 0); // Only the framebuffer that is read counts.
    ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(MultisampleFixture, "blits between numbers of samples copy without scaling") {
    const GLuint single = bind_framebuffer(GL_RGBA8, 0);
    BindFramebuffer(GL_READ_FRAMEBUFFER, 0); // the window
    copies();
    BlitFramebuffer(4, 4, 12, 12, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    auto made = copies();
    REQUIRE(made.size() == 1);
    CHECK(made[0].source == window().back());
    CHECK(made[0].destination.samples == 1);
    CHECK(made[0].source_x == 4);
    CHECK(made[0].width == 8);
    BlitFramebuffer(0, 0, 8, 8, 8, 0, 0, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST); // mirrored
    CHECK(GetError() == GL_NO_ERROR);
    const auto blit = [](GLint width, GLint height) {
        BlitFramebuffer(0, 0, 8, 8, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    };
    for (const auto& [width, height] : {std::pair{8, 9}, {7, 8}, {16, 16}, {0, 8}})
        check_refused(GL_INVALID_OPERATION, [&, w = width, h = height] { blit(w, h); });
    // The other way round.
    BindFramebuffer(GL_READ_FRAMEBUFFER, single);
    BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    check_refused(GL_INVALID_OPERATION, [&] { blit(16, 16); });
    copies();
    blit(8, 8);
    made = copies();
    REQUIRE(made.size() == 1);
    CHECK(made[0].source.samples == 1);
    CHECK(made[0].destination == window().back());
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(MultisampleFixture, "a blit that resolves does not convert") {
    const auto blit = [](GLbitfield mask) {
        BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, mask, GL_NEAREST);
    };
    bind_framebuffer(GL_RGB5, 0);
    BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    check_refused(GL_INVALID_OPERATION, [&] { blit(GL_COLOR_BUFFER_BIT); });
    bind_framebuffer(GL_RGB8, 0); // Whether there is alpha does not matter.
    BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    blit(GL_COLOR_BUFFER_BIT);
    CHECK(GetError() == GL_NO_ERROR);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16, 0);
    check_refused(GL_INVALID_OPERATION, [&] { blit(GL_DEPTH_BUFFER_BIT); });
}

TEST_CASE_METHOD(MultisampleFixture, "depth and stencil are blitted sample by sample") {
    bind_framebuffer(GL_RGBA8, 4);
    attach_renderbuffer(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, 4);
    REQUIRE(status() == GL_FRAMEBUFFER_COMPLETE);
    const Surface from = window().depth(), to = drawn().targets.depth;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t value = 0x01010101 * (i + 1);
        std::memcpy(device.memory.data() + from.plane(i).address, &value, 4);
    }
    BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    BlitFramebuffer(
        0, 0, 8, 8, 0, 0, 8, 8, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    CHECK(GetError() == GL_NO_ERROR);
    for (std::uint32_t i = 0; i < 4; ++i) {
        std::uint32_t value = 0;
        std::memcpy(&value, device.memory.data() + to.plane(i).address, 4);
        CHECK(value == 0x01010101 * (i + 1));
    }
}

TEST_CASE_METHOD(MultisampleFixture, "the accumulation buffer returns to all samples") {
    ClearAccum(1, 0.5f, 0, 1);
    Clear(GL_ACCUM_BUFFER_BIT);
    Accum(GL_RETURN, 1);
    for (unsigned i = 0; i < 4; ++i) {
        std::uint32_t pixel = 0;
        std::memcpy(&pixel, device.memory.data() + window().back().plane(i).address, 4);
        CHECK(pixel == 0xff0080ff);
    }
    copies();
    read_color();
    CHECK(copies().size() == 1); // What was resolved before is out of date.
}
