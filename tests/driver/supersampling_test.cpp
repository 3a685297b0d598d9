// Supersampled windows against as many pictures, each drawn by a program that moves its scene by a
// part of a pixel, and averaged here.

#include "driver/context/offscreen.h"
#include "driver/device_context/supersampling.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <random>
#include <set>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr GLsizei Size = 32;

// Where sample i of a pixel lies, in 32nds: Hammersley's points as the literature lists them, by
// writing the number's bits down from the other end.
std::vector<std::pair<int, int>> samples(unsigned count) {
    switch (count) {
    case 1:
        return {{16, 16}};
    case 2:
        return {{8, 8}, {24, 24}};
    case 4:
        return {{4, 4}, {12, 20}, {20, 12}, {28, 28}};
    case 8:
        return {{2, 2}, {6, 18}, {10, 10}, {14, 26}, {18, 6}, {22, 22}, {26, 14}, {30, 30}};
    default:
        return {{1, 1},
                {3, 17},
                {5, 9},
                {7, 25},
                {9, 5},
                {11, 21},
                {13, 13},
                {15, 29},
                {17, 3},
                {19, 19},
                {21, 11},
                {23, 27},
                {25, 7},
                {27, 23},
                {29, 15},
                {31, 31}};
    }
}

class Window {
public:
    explicit Window(unsigned supersampling)
        : device_({.memory_bytes = 32u << 20})
        , gl_(device_,
              {.width = Size,
               .height = Size,
               .format = {.supersampling = static_cast<std::uint8_t>(supersampling)}}) {
        gl_.make_current();
        Bytes texels(4 * 16 * 16);
        std::mt19937 random(4);
        for (std::uint8_t& byte : texels)
            byte = static_cast<std::uint8_t>(random() >> 8);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        ClearColor(0.25f, 0.5f, 0.125f, 1);
    }
    ~Window() { CHECK(GetError() == GL_NO_ERROR); }

    // Triangles that cut through each other, textured, blended; a line, a point. Vertices lie on
    // quarters of pixels, so that moving them by 32nds is exact.
    static void draw(std::pair<int, int> sample) {
        MatrixMode(GL_PROJECTION);
        LoadIdentity();
        Translatef(static_cast<GLfloat>(16 - sample.first) / (16 * Size),
                   static_cast<GLfloat>(16 - sample.second) / (16 * Size),
                   0);
        Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        Enable(GL_DEPTH_TEST);
        Enable(GL_TEXTURE_2D);
        Color3f(1, 1, 1);
        triangle({-0.75f, -0.875f, -0.5f}, {0.875f, -0.25f, 0.5f}, {-0.125f, 0.75f, 0});
        Disable(GL_TEXTURE_2D);
        Color3f(1, 0.25f, 0);
        triangle({-0.875f, 0.625f, 0.5f}, {0.75f, 0.75f, -0.5f}, {0, -0.9375f, 0});
        Disable(GL_DEPTH_TEST);
        Enable(GL_BLEND);
        BlendFunc(GL_ONE, GL_ONE);
        Color3f(0.25f, 0.25f, 0.5f);
        LineWidth(3);
        Begin(GL_LINES);
        Vertex2f(-0.9375f, 0.8125f);
        Vertex2f(0.9375f, 0.125f);
        End();
        PointSize(5);
        Begin(GL_POINTS);
        Vertex2f(0.5f, -0.6875f);
        End();
        Disable(GL_BLEND);
    }

    static Bytes colors(GLenum buffer = GL_BACK) {
        Bytes pixels(4 * Size * Size);
        ReadBuffer(buffer);
        ReadPixels(0, 0, Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    static std::vector<GLfloat> depths() {
        std::vector<GLfloat> pixels(Size * Size);
        ReadPixels(0, 0, Size, Size, GL_DEPTH_COMPONENT, GL_FLOAT, pixels.data());
        return pixels;
    }

    std::uint64_t counted(std::string_view name) {
        device_.finish();
        for (const StatisticsGroup* const group : device_.statistics())
            for (const Counter& counter : group->counters())
                if (counter.name() == name) return counter.value();
        FAIL("no counter of the name " << name);
        return 0;
    }
    void swap(SwapMode mode) { gl_.drawable().swap(mode); }

private:
    struct Corner {
        GLfloat x, y, z;
    };
    static void triangle(const Corner& a, const Corner& b, const Corner& c) {
        Begin(GL_TRIANGLES);
        for (const Corner& corner : {a, b, c}) {
            TexCoord2f(corner.x, corner.y);
            Vertex3f(corner.x, corner.y, corner.z);
        }
        End();
    }

    FunctionalGpu device_;
    OffscreenContext gl_;
};

struct Expected {
    Bytes mean, first;
    std::vector<GLfloat> first_depths;
    std::uint64_t fragments = 0; // of all pictures
};

// Pictures of a plain window, averaged to nearest.
Expected drawn_one_by_one(unsigned count) {
    Expected expected;
    std::vector<unsigned> sums(4 * Size * Size, count / 2);
    Window window(1);
    for (const auto& sample : samples(count)) {
        Window::draw(sample);
        const Bytes picture = Window::colors();
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += picture[i];
        if (!expected.first.empty()) continue;
        expected.first = picture;
        expected.first_depths = Window::depths();
    }
    for (const unsigned sum : sums)
        expected.mean.push_back(static_cast<std::uint8_t>(sum / count));
    expected.fragments = window.counted("fragments_covered");
    return expected;
}

constexpr std::pair<int, int> Centre{16, 16};

} // namespace

TEST_CASE("A supersampled window is the mean of as many pictures, each of another sample") {
    for (const unsigned count : {2u, 4u, 8u, 16u}) {
        INFO(count);
        const Expected expected = drawn_one_by_one(count);
        Window window(count);
        Window::draw(Centre);
        CHECK((Window::colors() == expected.mean));
        CHECK((expected.mean != expected.first));
        CHECK((Window::depths() == expected.first_depths));
        CHECK(window.counted("fragments_covered") == expected.fragments);
    }
}

TEST_CASE("Samples are spread evenly over rows, columns and squares of a pixel") {
    for (const unsigned count : {2u, 4u, 8u, 16u}) {
        std::set<int> rows, columns;
        std::set<std::pair<int, int>> quarters;
        for (unsigned i = 0; i < count; ++i) {
            const auto [x, y] = sample_position(i, count);
            CHECK(std::pair(int(x * 32), int(y * 32)) == samples(count)[i]);
            columns.insert(int(x * static_cast<float>(count)));
            rows.insert(int(y * static_cast<float>(count)));
            quarters.insert({int(x * 4), int(y * 4)});
        }
        CHECK(rows.size() == count);
        CHECK(columns.size() == count);
        if (count == 16) CHECK(quarters.size() == 16);
    }
}

TEST_CASE("All pictures follow swaps, images, accumulation and blits; programs see one") {
    constexpr unsigned Count = 4;
    const Bytes mean = drawn_one_by_one(Count).mean;
    Window window(Count);
    GLint value = -1;
    GetIntegerv(GL_SAMPLE_BUFFERS, &value);
    CHECK(value == 0);

    Window::draw(Centre);
    window.swap(SwapMode::Copy);
    CHECK((Window::colors(GL_FRONT) == mean));
    CHECK((Window::colors(GL_BACK) == mean));
    Clear(GL_COLOR_BUFFER_BIT);
    window.swap(SwapMode::Exchange);
    CHECK((Window::colors(GL_BACK) == mean));
    CHECK((Window::colors(GL_FRONT) != mean));

    // An image is drawn to each picture.
    MatrixMode(GL_PROJECTION);
    LoadIdentity();
    RasterPos2i(-1, -1);
    DrawPixels(Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, mean.data());
    CHECK((Window::colors() == mean));
    Accum(GL_LOAD, 0.5f);
    Clear(GL_COLOR_BUFFER_BIT);
    Accum(GL_RETURN, 2);
    CHECK((Window::colors() == mean));
    ReadBuffer(GL_BACK);
    DrawBuffer(GL_FRONT);
    BlitFramebuffer(0, 0, Size, Size, 0, 0, Size, Size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    CHECK((Window::colors(GL_FRONT) == mean));
    // The mean is read, and written to each picture.
    CopyPixels(0, 0, Size, Size, GL_COLOR);
    CHECK((Window::colors(GL_FRONT) == mean));
}

TEST_CASE("A query counts the fragments of a window's first picture") {
    const auto counted = [](unsigned supersampling, std::pair<int, int> sample) {
        const Window window(supersampling);
        GLuint name = 0, result = 0;
        GenQueries(1, &name);
        BeginQuery(GL_SAMPLES_PASSED, name);
        Window::draw(sample);
        EndQuery(GL_SAMPLES_PASSED);
        GetQueryObjectuiv(name, GL_QUERY_RESULT, &result);
        return result;
    };
    CHECK(counted(8, Centre) == counted(1, samples(8)[0]));
    CHECK(counted(8, Centre) > 100);
}

TEST_CASE("Feedback tells a supersampled window's vertices once, where they are") {
    const auto feedback = [](unsigned supersampling) {
        const Window window(supersampling);
        std::vector<GLfloat> values(1000, -1);
        Window::draw(Centre); // The last picture's viewport is not the window's.
        FeedbackBuffer(1000, GL_3D, values.data());
        RenderMode(GL_FEEDBACK);
        Window::draw(Centre);
        RenderMode(GL_RENDER);
        return values;
    };
    CHECK((feedback(4) == feedback(1)));
}
