// Multisampled configurations, visuals and windows of GLX (GLX_ARB_multisample).

#include "tests/window_system/glx_fixture.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace ffgpu::tests {
namespace {

int value_of(Display* display, GLXFBConfig config, int attribute) {
    int value = -1;
    CHECK(glXGetFBConfigAttrib(display, config, attribute, &value) == 0);
    return value;
}

int value_of(Display* display, XVisualInfo* visual, int attribute) {
    int value = -1;
    CHECK(glXGetConfig(display, visual, attribute, &value) == 0);
    return value;
}

std::vector<GLXFBConfig> choose_all(Display* display, std::vector<int> wish) {
    wish.push_back(0);
    int count = 0;
    GLXFBConfig* const found = glXChooseFBConfig(display, 0, wish.data(), &count);
    std::vector<GLXFBConfig> list(found, found + count);
    if (found) XFree(found);
    return list;
}

GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}

// Half of the window is red, with an edge that leaves pixels partly covered.
void draw_edge() {
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 0, 0);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(-1, 0.8f);
    glEnd();
}

// How many pixels of the window are neither black nor red.
int partly_covered(const TestWindow& window, int size) {
    int count = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            count += window.pixel(x, y) != 0 && window.pixel(x, y) != 0xff0000;
    return count;
}

TEST_CASE("multisampled configurations are found by their samples, and come after the others") {
    Display* const display = XServer::display();
    if (!display) return;
    for (const int wished : {1, 2, 4}) {
        const auto found = choose_all(display, {GLX_SAMPLE_BUFFERS, 1, GLX_SAMPLES, wished});
        REQUIRE_FALSE(found.empty());
        for (const GLXFBConfig config : found) {
            CHECK(value_of(display, config, GLX_SAMPLE_BUFFERS) == 1);
            CHECK(value_of(display, config, GLX_SAMPLES) == 4);
        }
    }
    CHECK(choose_all(display, {GLX_SAMPLES, 5}).empty());
    CHECK(choose_all(display, {GLX_SAMPLE_BUFFERS, 2}).empty());

    // Samples come before depth and after the buffers (GLX 1.4, table 3.4).
    const auto deep =
        choose_all(display, {GLX_DOUBLEBUFFER, True, GLX_DEPTH_SIZE, 1, GLX_ALPHA_SIZE, 1});
    std::vector<int> samples, depths;
    for (const GLXFBConfig config : deep) {
        samples.push_back(value_of(display, config, GLX_SAMPLES));
        depths.push_back(value_of(display, config, GLX_DEPTH_SIZE));
    }
    CHECK(samples.front() == 0);
    CHECK(samples.back() == 4);
    CHECK(std::is_sorted(samples.begin(), samples.end()));
    CHECK_FALSE(std::is_sorted(depths.rbegin(), depths.rend()));
    CHECK(std::string_view(glXQueryExtensionsString(display, 0)).find("GLX_ARB_multisample") !=
          std::string_view::npos);
}

TEST_CASE("a visual stands for the configuration that it was handed out for last") {
    Display* const display = XServer::display();
    if (!display) return;
    for (const GLXFBConfig config : choose_all(display, {})) {
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, config);
        REQUIRE(visual);
        for (const int attribute : {GLX_SAMPLES, GLX_SAMPLE_BUFFERS, GLX_DOUBLEBUFFER})
            CHECK(value_of(display, visual, attribute) == value_of(display, config, attribute));
        XFree(visual);
    }
}

TEST_CASE("a context of a visual that was asked for samples draws with them") {
    Display* const display = XServer::display();
    if (!display) return;
    for (const int wished : {4, 0, 2}) { // in turn, perhaps of the same visual
        int wish[] = {
            GLX_RGBA, GLX_DOUBLEBUFFER, GLX_SAMPLE_BUFFERS, wished > 0, GLX_SAMPLES, wished, 0};
        XVisualInfo* const visual = glXChooseVisual(display, 0, wish);
        REQUIRE(visual);
        CHECK(value_of(display, visual, GLX_SAMPLES) == (wished > 0 ? 4 : 0));
        const GLXContext context = glXCreateContext(display, visual, nullptr, True);
        const TestWindow window(display, *visual, 16, 16);
        REQUIRE(glXMakeCurrent(display, window.id(), context));
        CHECK(get(GL_SAMPLES) == (wished > 0 ? 4 : 0));
        draw_edge();
        glXSwapBuffers(display, window.id());
        CHECK((partly_covered(window, 16) > 0) == (wished > 0));
        glXMakeCurrent(display, 0, nullptr);
        glXDestroyContext(display, context);
        XFree(visual);
    }
}

TEST_CASE("a multisampled window shows resolved pictures, grown or drawn to in front") {
    Display* const display = XServer::display();
    if (!display) return;
    const GLXFBConfig config =
        choose_all(display, {GLX_DOUBLEBUFFER, True, GLX_SAMPLES, 4, GLX_DEPTH_SIZE, 24}).at(0);
    const TestWindow window(display, config, 16, 16);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    CHECK(get(GL_SAMPLE_BUFFERS) == 1);
    draw_edge();
    glXSwapBuffers(display, window.id());
    const int smooth = partly_covered(window, 16);
    CHECK(smooth > 8);
    XResizeWindow(display, window.id(), 40, 40);
    XSync(display, False);
    glViewport(0, 0, 40, 40);
    draw_edge();
    glXSwapBuffers(display, window.id());
    CHECK(partly_covered(window, 40) > smooth);
    glDrawBuffer(GL_FRONT);
    glClear(GL_COLOR_BUFFER_BIT);
    glFlush();
    CHECK(partly_covered(window, 40) == 0);
    draw_edge();
    glFlush();
    CHECK(partly_covered(window, 40) > smooth);
    CHECK(glGetError() == GL_NO_ERROR);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
}

} // namespace
} // namespace ffgpu::tests
