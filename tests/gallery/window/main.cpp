// gallery_window NAME [--break] [-o FILE.ppm]: a program of the gallery in a window of any X
// server, on whatever libGL the loader finds; it draws one frame and ends.

#include "tests/gallery/programs/programs.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <GL/glx.h>

namespace ffgpu::gallery {
namespace {

constexpr int BadInput = 2;

// A window of the scene's size with a context that is current. The process's end closes it.
Display* open_window(const Scene& scene, Window& window) {
    Display* const display = XOpenDisplay(nullptr);
    if (!display) return nullptr;
    int wish[] = {GLX_RGBA,
                  GLX_DOUBLEBUFFER,
                  GLX_RED_SIZE,
                  8,
                  GLX_DEPTH_SIZE,
                  24,
                  GLX_ALPHA_SIZE,
                  8,
                  GLX_ACCUM_RED_SIZE,
                  16,
                  0};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), wish);
    if (!visual) return nullptr;
    const Window root = RootWindow(display, visual->screen);
    XSetWindowAttributes attributes{};
    attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
    window = XCreateWindow(display,
                           root,
                           0,
                           0,
                           static_cast<unsigned>(scene.width),
                           static_cast<unsigned>(scene.height),
                           0,
                           visual->depth,
                           InputOutput,
                           visual->visual,
                           CWColormap | CWBorderPixel,
                           &attributes);
    XMapWindow(display, window);
    glXMakeCurrent(display, window, glXCreateContext(display, visual, nullptr, True));
    return display;
}

bool save(const Scene& scene, const std::string& path) {
    const auto row = 3 * static_cast<std::size_t>(scene.width);
    std::vector<char> pixels(row * static_cast<std::size_t>(scene.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, scene.width, scene.height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << scene.width << ' ' << scene.height << "\n255\n";
    for (std::size_t y = static_cast<std::size_t>(scene.height); y-- > 0;)
        file.write(pixels.data() + y * row, static_cast<std::streamsize>(row));
    return file.good();
}

int run(const std::vector<std::string>& arguments) {
    Scene scene;
    std::string path, name;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "--break")
            scene.broken = true;
        else if (arguments[i] == "-o" && i + 1 < arguments.size())
            path = arguments[++i];
        else
            name = arguments[i];
    }
    const Program* const program = find_program(name);
    if (!program) {
        std::fprintf(stderr, "gallery_window: no program '%s'\n", name.c_str());
        return BadInput;
    }
    Window window = 0;
    Display* const display = open_window(scene, window);
    if (!display) {
        std::fprintf(stderr, "gallery_window: no X server with OpenGL\n");
        return BadInput;
    }
    program->draw(scene);
    const bool saved = path.empty() || save(scene, path);
    glXSwapBuffers(display, window);
    glFinish();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) std::fprintf(stderr, "GL error %x\n", error);
    return error == GL_NO_ERROR && saved ? 0 : 1;
}

} // namespace
} // namespace ffgpu::gallery

int main(int count, char** values) {
    return ffgpu::gallery::run(std::vector<std::string>(values + 1, values + count));
}
