// EGL, with and without an X server.

#include <algorithm>
#include <array>
#include <vector>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <catch2/catch.hpp>

namespace {

EGLDisplay surfaceless() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    REQUIRE(eglInitialize(display, nullptr, nullptr));
    REQUIRE(eglBindAPI(EGL_OPENGL_API));
    return display;
}

EGLConfig choose(EGLDisplay display, EGLint depth) {
    const EGLint wish[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_DEPTH_SIZE,
                           depth,
                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    REQUIRE(eglChooseConfig(display, wish, &config, 1, &count));
    REQUIRE(count == 1);
    return config;
}

TEST_CASE("a pbuffer is drawn to without a window system") {
    const EGLDisplay display = surfaceless();
    const EGLConfig config = choose(display, 16);
    const EGLint size[] = {EGL_WIDTH, 20, EGL_HEIGHT, 10, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    REQUIRE(eglMakeCurrent(display, surface, surface, context));
    CHECK(eglGetCurrentContext() == context);
    CHECK(eglGetCurrentSurface(EGL_READ) == surface);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    std::array<GLubyte, 4> pixel{};
    glReadPixels(19, 9, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    CHECK(pixel == std::array<GLubyte, 4>{0, 255, 0, 255});
    EGLint width = 0;
    CHECK(eglQuerySurface(display, surface, EGL_WIDTH, &width));
    CHECK(width == 20);
    CHECK(eglDestroySurface(display, surface)); // Still current: it lives.
    glClear(GL_COLOR_BUFFER_BIT);
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
    CHECK(eglDestroyContext(display, context));
}

TEST_CASE("a context without a surface draws to nothing, and says so") {
    const EGLDisplay display = surfaceless();
    const EGLContext context =
        eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    REQUIRE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    CHECK(glGetString(GL_VERSION) != nullptr);
    glClear(GL_COLOR_BUFFER_BIT);
    CHECK(glGetError() == 0x0506); // GL_INVALID_FRAMEBUFFER_OPERATION
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
}

TEST_CASE("EGL's errors name what is wrong") {
    const EGLDisplay display = surfaceless();
    const EGLConfig config = choose(display, 0);
    const EGLint version_2[] = {EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE};
    CHECK(eglCreateContext(display, config, EGL_NO_CONTEXT, version_2) == EGL_NO_CONTEXT);
    CHECK(eglGetError() == EGL_BAD_MATCH);
    CHECK(eglGetError() == EGL_SUCCESS); // It is read once.
    CHECK_FALSE(eglBindAPI(EGL_OPENGL_ES_API));
    CHECK(eglGetError() == EGL_BAD_PARAMETER);
    int other = 0;
    CHECK_FALSE(eglInitialize(&other, nullptr, nullptr));
    CHECK(eglGetError() == EGL_BAD_DISPLAY);
    const EGLint negative[] = {EGL_WIDTH, -1, EGL_NONE};
    CHECK(eglCreatePbufferSurface(display, config, negative) == EGL_NO_SURFACE);
    CHECK(eglGetError() == EGL_BAD_PARAMETER);
    const EGLint unknown[] = {0x1234, 1, EGL_NONE};
    EGLint count = 0;
    CHECK_FALSE(eglChooseConfig(display, unknown, nullptr, 0, &count));
    CHECK(eglGetError() == EGL_BAD_ATTRIBUTE);
}

TEST_CASE("the smallest configuration that does comes first") {
    const EGLDisplay display = surfaceless();
    EGLint value = -1;
    CHECK(eglGetConfigAttrib(display, choose(display, 0), EGL_DEPTH_SIZE, &value));
    CHECK(value == 0);
    CHECK(eglGetConfigAttrib(display, choose(display, 1), EGL_DEPTH_SIZE, &value));
    CHECK(value == 16);
    CHECK(eglGetConfigAttrib(display, choose(display, 17), EGL_DEPTH_SIZE, &value));
    CHECK(value == 24);
}

TEST_CASE("EGL finds multisampled configurations by their samples, after the others") {
    const EGLDisplay display = surfaceless();
    const auto choose_samples = [&](EGLint samples) {
        const EGLint wish[] = {
            EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_ALPHA_SIZE, 8, EGL_SAMPLES, samples, EGL_NONE};
        std::array<EGLConfig, 64> configs{};
        EGLint count = 0;
        REQUIRE(eglChooseConfig(display, wish, configs.data(), 64, &count));
        std::vector<EGLint> found;
        for (EGLint i = 0; i < count; ++i) {
            EGLint value = -1, buffers = -1;
            const EGLConfig config = configs[static_cast<std::size_t>(i)];
            REQUIRE(eglGetConfigAttrib(display, config, EGL_SAMPLES, &value));
            REQUIRE(eglGetConfigAttrib(display, config, EGL_SAMPLE_BUFFERS, &buffers));
            CHECK(buffers == (value > 0));
            found.push_back(value);
        }
        return found;
    };
    const auto any = choose_samples(0);
    CHECK(any.front() == 0);
    CHECK(any.back() == 4);
    CHECK(std::is_sorted(any.begin(), any.end()));
    CHECK(choose_samples(2).size() == any.size() / 2);
    CHECK(choose_samples(2).front() == 4);
    CHECK(choose_samples(5).empty());
}

TEST_CASE("a multisampled pbuffer is drawn to and read") {
    const EGLDisplay display = surfaceless();
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_SAMPLES, 4, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    REQUIRE(eglChooseConfig(display, wish, &config, 1, &count));
    REQUIRE(count == 1);
    const EGLint size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    REQUIRE(eglMakeCurrent(display, surface, surface, context));
    GLint samples = -1;
    glGetIntegerv(GL_SAMPLES, &samples);
    CHECK(samples == 4);
    glClear(GL_COLOR_BUFFER_BIT);
    glRectf(-1, -1, 1, 0.125f); // half of the fifth row of pixels
    std::array<GLubyte, 4> pixel{};
    glReadPixels(3, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    CHECK(pixel[0] == 128);
    CHECK(glGetError() == GL_NO_ERROR);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglDestroySurface(display, surface);
}

TEST_CASE("a fence is passed when it is made") {
    const EGLDisplay display = surfaceless();
    const EGLContext context =
        eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    REQUIRE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    const EGLSync fence = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
    REQUIRE(fence != EGL_NO_SYNC);
    CHECK(eglClientWaitSync(display, fence, 0, EGL_FOREVER) == EGL_CONDITION_SATISFIED);
    EGLAttrib status = 0;
    CHECK(eglGetSyncAttrib(display, fence, EGL_SYNC_STATUS, &status));
    CHECK(status == EGL_SIGNALED);
    CHECK(eglDestroySync(display, fence));
    CHECK_FALSE(eglDestroySync(display, fence));
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
}

} // namespace
