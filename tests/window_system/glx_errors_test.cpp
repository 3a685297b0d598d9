// What GLX refuses, by the X errors that a program's handler sees; and what it must leave alone.

// glXCreateContextAttribsARB and the like are declared only then.
#define GLX_GLXEXT_PROTOTYPES

#include "tests/window_system/glx_fixture.h"

#include <initializer_list>
#include <utility>
#include <vector>

#include <GL/glxext.h>

namespace ffgpu::tests {
namespace {

int last_error = 0;

int keep_error(Display*, XErrorEvent* event) {
    last_error = event->error_code;
    return 0;
}

// The error of `call`, 0 if there is none.
template <class Call>
int error_of(Display* display, Call&& call) {
    XSync(display, False);
    last_error = 0;
    const XErrorHandler before = XSetErrorHandler(keep_error);
    call();
    XSync(display, False);
    XSetErrorHandler(before);
    return last_error;
}

int first_glx_error(Display* display) {
    int base = 0;
    REQUIRE(glXQueryExtension(display, &base, nullptr));
    return base;
}

TEST_CASE("wishes for contexts that there cannot be are the specified errors") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const int base = first_glx_error(display);
    const int bad_config = base + 9, bad_profile = base + 13;
    const auto refused = [&](std::initializer_list<int> wish) {
        std::vector<int> attributes(wish);
        attributes.push_back(0);
        return error_of(display, [&] {
            const GLXContext made =
                glXCreateContextAttribsARB(display, config, nullptr, True, attributes.data());
            CHECK((made == nullptr) == (last_error != 0));
            if (made) glXDestroyContext(display, made);
        });
    };
    const auto version = [&](int major, int minor) {
        return refused(
            {GLX_CONTEXT_MAJOR_VERSION_ARB, major, GLX_CONTEXT_MINOR_VERSION_ARB, minor});
    };
    for (int minor = 0; minor <= 5; ++minor)
        CHECK(version(1, minor) == 0);
    for (const auto& [major, minor] : {std::pair{0, 0}, {1, 6}, {1, -1}, {2, 2}, {3, 4}, {5, 0}})
        CHECK(version(major, minor) == BadMatch);
    for (const auto& [major, minor] : {std::pair{2, 1}, {3, 0}, {3, 3}, {4, 6}})
        CHECK(version(major, minor) == bad_config);

    CHECK(refused({GLX_RENDER_TYPE, GLX_RGBA_BIT}) == BadValue);
    CHECK(refused({GLX_RENDER_TYPE, GLX_COLOR_INDEX_TYPE}) == BadMatch);
    CHECK(refused({GLX_SAMPLES, 1}) == BadValue);
    const int forward = GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB;
    CHECK(refused({GLX_CONTEXT_FLAGS_ARB, 0x100}) == BadValue);
    CHECK(refused({GLX_CONTEXT_FLAGS_ARB, forward}) == BadMatch); // of 1.0
    CHECK(refused({GLX_CONTEXT_FLAGS_ARB, forward, GLX_CONTEXT_MAJOR_VERSION_ARB, 3}) ==
          bad_config);

    const int core = GLX_CONTEXT_CORE_PROFILE_BIT_ARB;
    CHECK(refused({GLX_CONTEXT_PROFILE_MASK_ARB, 0}) == bad_profile);
    CHECK(refused({GLX_CONTEXT_PROFILE_MASK_ARB, 3}) == bad_profile);
    CHECK(refused({GLX_CONTEXT_PROFILE_MASK_ARB, 4}) == bad_profile);
    CHECK(refused({GLX_CONTEXT_PROFILE_MASK_ARB, core}) == 0); // Ignored before 3.2.
}

TEST_CASE("the renderer of a screen tells what it is without a context") {
    Display* const display = XServer::display();
    if (!display) return;
    unsigned value[3] = {7, 7, 7};
    const auto query = [&](int attribute) {
        return glXQueryRendererIntegerMESA(display, 0, 0, attribute, value);
    };
    CHECK(query(GLX_RENDERER_VERSION_MESA));
    CHECK(value[0] + value[1] > 0);
    CHECK(query(GLX_RENDERER_OPENGL_COMPATIBILITY_PROFILE_VERSION_MESA));
    CHECK((value[0] == 1 && value[1] == 5));
    CHECK(query(GLX_RENDERER_VIDEO_MEMORY_MESA));
    CHECK(value[0] >= 64);
    CHECK_FALSE(query(GLX_SAMPLES));
    CHECK_FALSE(glXQueryRendererIntegerMESA(display, 0, 1, GLX_RENDERER_VERSION_MESA, value));
    CHECK_FALSE(glXQueryCurrentRendererIntegerMESA(GLX_RENDERER_VERSION_MESA, value));
    CHECK(glXQueryRendererStringMESA(display, 0, 0, GLX_RENDERER_VENDOR_ID_MESA) != nullptr);
    CHECK(glXQueryRendererStringMESA(display, 0, 0, GLX_RENDERER_VERSION_MESA) == nullptr);
}

TEST_CASE("a swap of a pixmap does nothing") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const Pixmap pixmap = XCreatePixmap(display, RootWindow(display, 0), 16, 16, 24);
    const GLXPixmap drawable = glXCreatePixmap(display, config, pixmap, nullptr);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, drawable, context));
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glXSwapBuffers(display, drawable);
    CHECK(read_pixel(3, 3) == std::array<GLubyte, 4>{0, 255, 0, 255});
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
    glXDestroyPixmap(display, drawable);
    XFreePixmap(display, pixmap);
}

TEST_CASE("a GLX window ends with its X window") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config = choose(display, true);
    const int bad_window = first_glx_error(display) + 12;
    GLXWindow drawable = 0;
    {
        const TestWindow window(display, config, 16, 16);
        drawable = glXCreateWindow(display, config, window.id(), nullptr);
        CHECK(error_of(display, [&] { glXDestroyWindow(display, drawable); }) == 0);
        drawable = glXCreateWindow(display, config, window.id(), nullptr);
    }
    CHECK(error_of(display, [&] { glXDestroyWindow(display, drawable); }) == bad_window);
    CHECK(error_of(display, [&] { glXDestroyWindow(display, drawable); }) == bad_window);
}

} // namespace
} // namespace ffgpu::tests
