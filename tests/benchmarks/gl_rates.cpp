// Fill and vertex rates of an OpenGL implementation, through an off-screen context.
//
//     gl_rates LIBOSMESA [SECONDS [wall|processor [CASE]]]
//
// LIBOSMESA is a library with OSMesa's calls and OpenGL: ffgpu's, or Mesa's. The program is the
// same for both, so that the rates can be compared. One line a case: name, unit, million a second
// of the wall's clock, or of the processor's time over all threads.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string_view>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>
#include <dlfcn.h>

namespace {

constexpr int Width = 640, Height = 480;

void* library;

template <class Function>
Function* symbol(const char* name) {
    void* address = dlsym(library, name);
    if (!address) {
        std::fprintf(stderr, "gl_rates: the library has no %s\n", name);
        std::exit(2);
    }
    return reinterpret_cast<Function*>(address);
}

// The calls used, by the names of OpenGL.
#define GL_CALL(name) decltype(::name)* name##_;
#define GL_CALLS                                                                                   \
    GL_CALL(glActiveTexture)                                                                       \
    GL_CALL(glMultiTexCoord2f)                                                                     \
    GL_CALL(glBegin)                                                                               \
    GL_CALL(glBindTexture)                                                                         \
    GL_CALL(glBlendFunc)                                                                           \
    GL_CALL(glCallList)                                                                            \
    GL_CALL(glClear)                                                                               \
    GL_CALL(glColor3f)                                                                             \
    GL_CALL(glColor4f)                                                                             \
    GL_CALL(glColorPointer)                                                                        \
    GL_CALL(glDepthFunc)                                                                           \
    GL_CALL(glDisable)                                                                             \
    GL_CALL(glDrawElements)                                                                        \
    GL_CALL(glEnable)                                                                              \
    GL_CALL(glEnableClientState)                                                                   \
    GL_CALL(glEnd)                                                                                 \
    GL_CALL(glEndList)                                                                             \
    GL_CALL(glFinish)                                                                              \
    GL_CALL(glFogf)                                                                                \
    GL_CALL(glFogi)                                                                                \
    GL_CALL(glFrustum)                                                                             \
    GL_CALL(glGenTextures)                                                                         \
    GL_CALL(glLightfv)                                                                             \
    GL_CALL(glLoadIdentity)                                                                        \
    GL_CALL(glMaterialf)                                                                           \
    GL_CALL(glMaterialfv)                                                                          \
    GL_CALL(glMatrixMode)                                                                          \
    GL_CALL(glNewList)                                                                             \
    GL_CALL(glNormalPointer)                                                                       \
    GL_CALL(glOrtho)                                                                               \
    GL_CALL(glPopAttrib)                                                                           \
    GL_CALL(glPushAttrib)                                                                          \
    GL_CALL(glTexCoord2f)                                                                          \
    GL_CALL(glTexImage2D)                                                                          \
    GL_CALL(glTexParameteri)                                                                       \
    GL_CALL(glTranslatef)                                                                          \
    GL_CALL(glVertex2f)                                                                            \
    GL_CALL(glVertex3f)                                                                            \
    GL_CALL(glVertexPointer)                                                                       \
    GL_CALL(glViewport)
GL_CALLS
#undef GL_CALL

void load_calls() {
#define GL_CALL(name) name##_ = symbol<decltype(::name)>(#name);
    GL_CALLS
#undef GL_CALL
}

GLuint make_texture(GLenum min_filter, GLenum mag_filter) {
    GLuint name = 0;
    glGenTextures_(1, &name);
    glBindTexture_(GL_TEXTURE_2D, name);
    for (int level = 0, size = 256; size > 0; ++level, size /= 2) {
        std::vector<std::uint32_t> texels(static_cast<std::size_t>(size) *
                                          static_cast<std::size_t>(size));
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = static_cast<std::uint32_t>(i) * 2654435761u | 0xff000000u;
        glTexImage2D_(
            GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    }
    glTexParameteri_(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min_filter));
    glTexParameteri_(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag_filter));
    return name;
}

void pixel_projection() {
    glMatrixMode_(GL_PROJECTION);
    glLoadIdentity_();
    glOrtho_(0, Width, 0, Height, -1, 1);
    glMatrixMode_(GL_MODELVIEW);
    glLoadIdentity_();
}

// Two triangles over the whole picture, textured about one to one.
void full_quad(float depth) {
    constexpr float S = Width / 256.0f, T = Height / 256.0f;
    const float corners[4][4] = {
        {0, 0, 0, 0}, {Width, 0, S, 0}, {Width, Height, S, T}, {0, Height, 0, T}};
    glBegin_(GL_QUADS);
    for (const auto& corner : corners) {
        glMultiTexCoord2f_(GL_TEXTURE0, corner[2] + 0.13f, corner[3] + 0.17f);
        glMultiTexCoord2f_(GL_TEXTURE1, corner[2] * 0.5f, corner[3] * 0.5f);
        glVertex3f_(corner[0], corner[1], depth);
    }
    glEnd_();
}

constexpr long QuadPixels = long{Width} * Height;

void floor_quad() {
    glMatrixMode_(GL_PROJECTION);
    glLoadIdentity_();
    glFrustum_(-0.66, 0.66, -0.5, 0.5, 0.5, 100);
    glMatrixMode_(GL_MODELVIEW);
    glLoadIdentity_();
    glBegin_(GL_QUADS);
    const float x = 60, y = -0.49f;
    glTexCoord2f_(-30, 0);
    glVertex3f_(-x, y, -0.501f);
    glTexCoord2f_(30, 0);
    glVertex3f_(x, y, -0.501f);
    glTexCoord2f_(30, 30);
    glVertex3f_(x, y, -60);
    glTexCoord2f_(-30, 30);
    glVertex3f_(-x, y, -60);
    glEnd_();
}

constexpr int SmallTriangles = 2000;

void small_triangles() {
    glBegin_(GL_TRIANGLES);
    for (int i = 0; i < SmallTriangles; ++i) {
        const float x = static_cast<float>(i % 200) * 3.1f, y = static_cast<float>(i / 200) * 4.7f;
        glColor3f_(0.3f, 0.5f, static_cast<float>(i % 7) / 7);
        glVertex2f_(x, y);
        glVertex2f_(x + 3, y + 0.5f);
        glVertex2f_(x + 0.5f, y + 3.5f);
    }
    glEnd_();
}

struct Sphere {
    std::vector<float> positions; // and normals: it is the unit sphere
    std::vector<std::uint16_t> indices;

    Sphere() {
        constexpr int N = 48, M = 96;
        for (int i = 0; i <= N; ++i) {
            for (int j = 0; j <= M; ++j) {
                const float a = 3.14159265f * static_cast<float>(i) / N,
                            b = 6.2831853f * static_cast<float>(j) / M;
                for (const float p :
                     {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)})
                    positions.push_back(p);
            }
        }
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j < M; ++j) {
                const int k = i * (M + 1) + j;
                for (const int v : {k, k + M + 1, k + 1, k + 1, k + M + 1, k + M + 2})
                    indices.push_back(static_cast<std::uint16_t>(v));
            }
        }
    }
    long vertices() const { return static_cast<long>(positions.size() / 3); }

    void draw() const {
        glVertexPointer_(3, GL_FLOAT, 0, positions.data());
        glNormalPointer_(GL_FLOAT, 0, positions.data());
        glDrawElements_(
            GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
    }
};

void sphere_state() {
    glMatrixMode_(GL_PROJECTION);
    glLoadIdentity_();
    glFrustum_(-0.66, 0.66, -0.5, 0.5, 1, 10);
    glMatrixMode_(GL_MODELVIEW);
    glLoadIdentity_();
    glTranslatef_(0, 0, -4);
    glEnable_(GL_LIGHTING);
    glEnable_(GL_LIGHT0);
    glEnable_(GL_DEPTH_TEST);
    glEnable_(GL_CULL_FACE);
    const GLfloat white[] = {1, 1, 1, 1};
    glMaterialfv_(GL_FRONT, GL_SPECULAR, white);
    glMaterialf_(GL_FRONT, GL_SHININESS, 30);
    glEnableClientState_(GL_VERTEX_ARRAY);
    glEnableClientState_(GL_NORMAL_ARRAY);
}

struct Case {
    const char* name;
    const char* unit;
    long items; // a call of draw()
    std::function<void()> state, draw;
};

// Seconds that went by, of this program's processors or of everybody's clock. A shared machine
// gives a program less of a processor's time, but what it computes in that time stays.
double seconds_on(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double million_per_second(const Case& test, double seconds, clockid_t clock) {
    glPushAttrib_(GL_ALL_ATTRIB_BITS);
    pixel_projection();
    glClear_(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    test.state();
    test.draw();
    glFinish_();
    double best = 0;
    const double end = seconds_on(CLOCK_MONOTONIC) + seconds;
    while (seconds_on(CLOCK_MONOTONIC) < end) { // The best of short runs: the machine is shared.
        const double begin = seconds_on(clock);
        constexpr int Repeat = 8;
        for (int i = 0; i < Repeat; ++i)
            test.draw();
        glFinish_();
        const double took = seconds_on(clock) - begin;
        best = std::fmax(best, static_cast<double>(test.items) * Repeat / took * 1e-6);
    }
    glPopAttrib_();
    return best;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: gl_rates LIBOSMESA [SECONDS [wall|processor [CASE]]]\n");
        return 2;
    }
    const double seconds = argc > 2 ? std::atof(argv[2]) : 0.3;
    const bool of_processor = argc > 3 && std::string_view(argv[3]) == "processor";
    const clockid_t clock = of_processor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
    library = dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL);
    if (!library) {
        std::fprintf(stderr, "gl_rates: %s\n", dlerror());
        return 2;
    }
    load_calls();
    constexpr GLenum OsMesaRgba = 0x1908;
    std::vector<std::uint8_t> pixels(std::size_t{Width} * Height * 4);
    void* context = symbol<void*(GLenum, GLint, GLint, GLint, void*)>("OSMesaCreateContextExt")(
        OsMesaRgba, 24, 8, 0, nullptr);
    if (!context || !symbol<GLboolean(void*, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent")(
                        context, pixels.data(), GL_UNSIGNED_BYTE, Width, Height)) {
        std::fprintf(stderr, "gl_rates: no off-screen context\n");
        return 2;
    }

    const GLuint nearest = make_texture(GL_NEAREST, GL_NEAREST);
    const GLuint bilinear = make_texture(GL_LINEAR, GL_LINEAR);
    const GLuint trilinear = make_texture(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    const Sphere sphere;
    glNewList_(1, GL_COMPILE);
    glEnableClientState_(GL_VERTEX_ARRAY);
    glEnableClientState_(GL_NORMAL_ARRAY);
    sphere.draw();
    glEndList_();

    const auto none = [] {};
    const auto textured = [](GLuint name) {
        return [name] {
            glEnable_(GL_TEXTURE_2D);
            glBindTexture_(GL_TEXTURE_2D, name);
        };
    };
    const auto two_textures = [&] {
        textured(bilinear)();
        glActiveTexture_(GL_TEXTURE1);
        textured(bilinear)();
        glActiveTexture_(GL_TEXTURE0);
    };
    const auto quad = [] { full_quad(0); };
    const std::array<Case, 11> cases{{
        {"flat fill", "pixels", QuadPixels, none, quad},
        {"depth-tested fill",
         "pixels",
         QuadPixels,
         [] {
             glEnable_(GL_DEPTH_TEST);
             glDepthFunc_(GL_LEQUAL);
         },
         quad},
        {"blended fill",
         "pixels",
         QuadPixels,
         [] {
             glEnable_(GL_BLEND);
             glBlendFunc_(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
             glColor4f_(0.5f, 0.7f, 0.2f, 0.4f);
         },
         quad},
        {"nearest", "pixels", QuadPixels, textured(nearest), quad},
        {"bilinear", "pixels", QuadPixels, textured(bilinear), quad},
        {"trilinear floor", "pixels", QuadPixels / 2, textured(trilinear), floor_quad},
        {"two bilinear textures", "pixels", QuadPixels, two_textures, quad},
        {"two textures, depth, fog, blend",
         "pixels",
         QuadPixels,
         [&] {
             two_textures();
             glEnable_(GL_DEPTH_TEST);
             glDepthFunc_(GL_LEQUAL);
             glEnable_(GL_FOG);
             glFogi_(GL_FOG_MODE, GL_LINEAR);
             glFogf_(GL_FOG_END, 2);
             glEnable_(GL_BLEND);
             glBlendFunc_(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
             glColor4f_(1, 1, 1, 0.5f);
         },
         quad},
        {"small triangles, immediate mode", "vertices", 3L * SmallTriangles, none, small_triangles},
        {"lit sphere, vertex array",
         "vertices",
         sphere.vertices(),
         sphere_state,
         [&] { sphere.draw(); }},
        {"lit sphere, display list",
         "vertices",
         sphere.vertices(),
         sphere_state,
         [] { glCallList_(1); }},
    }};
    for (const Case& test : cases) {
        if (argc > 4 && std::string_view(test.name).find(argv[4]) == std::string_view::npos)
            continue;
        std::printf(
            "%s\t%s\t%.3f\n", test.name, test.unit, million_per_second(test, seconds, clock));
        std::fflush(stdout);
    }
    return 0;
}
