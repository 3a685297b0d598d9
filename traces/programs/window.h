// A GLX window for the small programs whose traces are kept beside them, and the few helpers that
// they share. Plain OpenGL 1.5; every picture depends on the frame number alone.

#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glu.h>
#include <GL/glx.h>
#include <X11/Xlib.h>

namespace demo {

constexpr float Pi = 3.14159265f;

struct Image {
    int size;
    std::vector<std::uint8_t> rgb; // size x size texels
};

// An image from a function of (x, y) that returns grey levels r, g, b in [0, 1].
struct Rgb {
    float r, g, b;
};
inline Image paint(int size, const std::function<Rgb(int, int)>& color) {
    Image image{size, {}};
    const auto to_byte = [](float value) {
        return static_cast<std::uint8_t>(std::fmin(std::fmax(value, 0.0f), 1.0f) * 255.0f + 0.5f);
    };
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const Rgb c = color(x, y);
            for (const float channel : {c.r, c.g, c.b})
                image.rgb.push_back(to_byte(channel));
        }
    }
    return image;
}

// A hash of lattice points in [0, 1): the noise that all textures here are made of.
inline float hash(int x, int y) {
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u;
    h = (h ^ (h >> 13)) * 1274126177u;
    return static_cast<float>((h ^ (h >> 16)) & 0xffff) / 65536.0f;
}

// A mip-mapped texture object that repeats; the current binding is the new object.
inline GLuint make_texture(const Image& image, bool mip_map = true) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    if (mip_map) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        gluBuild2DMipmaps(GL_TEXTURE_2D,
                          GL_RGB,
                          image.size,
                          image.size,
                          GL_RGB,
                          GL_UNSIGNED_BYTE,
                          image.rgb.data());
    } else {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexImage2D(GL_TEXTURE_2D,
                     0,
                     GL_RGB,
                     image.size,
                     image.size,
                     0,
                     GL_RGB,
                     GL_UNSIGNED_BYTE,
                     image.rgb.data());
    }
    return name;
}

// Opens a width x height window, calls setup() once and draw(n) for n = 0 .. frames - 1.
inline int run(const char* title,
               int width,
               int height,
               int frames,
               const std::function<void()>& setup,
               const std::function<void(int)>& draw) {
    Display* display = XOpenDisplay(nullptr);
    if (!display) {
        std::fprintf(stderr, "%s: no X display\n", title);
        return 1;
    }
    int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, GLX_STENCIL_SIZE, 8, None};
    XVisualInfo* visual = glXChooseVisual(display, DefaultScreen(display), attributes);
    if (!visual) {
        std::fprintf(stderr, "%s: no double-buffered RGB visual with depth\n", title);
        return 1;
    }
    const Window root = RootWindow(display, visual->screen);
    XSetWindowAttributes window_attributes{};
    window_attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
    const Window window = XCreateWindow(display,
                                        root,
                                        0,
                                        0,
                                        static_cast<unsigned>(width),
                                        static_cast<unsigned>(height),
                                        0,
                                        visual->depth,
                                        InputOutput,
                                        visual->visual,
                                        CWColormap | CWBorderPixel,
                                        &window_attributes);
    XStoreName(display, window, title);
    XMapWindow(display, window);
    const GLXContext context = glXCreateContext(display, visual, nullptr, True);
    glXMakeCurrent(display, window, context);
    glViewport(0, 0, width, height);
    setup();
    for (int frame = 0; frame < frames; ++frame) {
        draw(frame);
        glXSwapBuffers(display, window);
    }
    glXMakeCurrent(display, None, nullptr);
    glXDestroyContext(display, context);
    XCloseDisplay(display);
    return 0;
}

} // namespace demo
