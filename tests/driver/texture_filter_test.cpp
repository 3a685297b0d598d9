// GL_FFGPU_texture_filter through the driver: rip-maps and summed-area tables follow the texture's
// texels, whoever writes them.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "driver/ffgpu_texture_filter.h"
#include "driver/texture/filter_table.h"
#include "model/device/filter_tables.h"
#include "model/gpu/functional_gpu.h"

#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

constexpr int Size = 16;         // of the picture
constexpr int Source = 4 * Size; // of the texture: a pixel covers 4 x 4 texels

// r g b a bytes.
struct Texels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;

    Texels(int columns, int rows, unsigned seed)
        : width(columns)
        , height(rows)
        , bytes(static_cast<std::size_t>(4 * columns * rows)) {
        std::mt19937 random(seed);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random() >> 8);
    }

    int at(int x, int y, int channel) const {
        const int place = 4 * (y * width + x) + channel;
        return bytes[static_cast<std::size_t>(place)];
    }

    // Over a rectangle of texels.
    double mean(int left, int below, int columns, int rows, int channel) const {
        double sum = 0;
        for (int y = below; y < below + rows; ++y)
            for (int x = left; x < left + columns; ++x)
                sum += at(x, y, channel);
        return sum / (columns * rows);
    }
};

ColorImage image_of(const Texels& texels) {
    ColorImage image{static_cast<std::uint32_t>(texels.width),
                     static_cast<std::uint32_t>(texels.height),
                     std::vector<std::byte>(texels.bytes.size())};
    std::memcpy(image.texels.data(), texels.bytes.data(), texels.bytes.size());
    return image;
}

struct FilterFixture {
    FilterFixture()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Size, .height = Size}) {
        gl.make_current();
        TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        Enable(GL_TEXTURE_2D);
    }

    static void define(const Texels& texels, GLint format = GL_RGBA8) {
        TexImage2D(GL_TEXTURE_2D,
                   0,
                   format,
                   texels.width,
                   texels.height,
                   0,
                   GL_RGBA,
                   GL_UNSIGNED_BYTE,
                   texels.bytes.data());
    }

    // The whole texture onto the whole picture.
    static Texels drawn() {
        Begin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            TexCoord2f(static_cast<float>(x + 1) / 2, static_cast<float>(y + 1) / 2);
            Vertex2i(x, y);
        }
        End();
        Texels picture(Size, Size, 0);
        ReadPixels(0, 0, Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, picture.bytes.data());
        return picture;
    }

    // The largest distance of a pixel from the mean of the 4 x 4 texels under it.
    static double distance(const Texels& picture, const Texels& texels) {
        double most = 0;
        for (int y = 0; y < Size; ++y)
            for (int x = 0; x < Size; ++x)
                for (int channel = 0; channel < 4; ++channel)
                    most = std::max(most,
                                    std::fabs(picture.at(x, y, channel) -
                                              texels.mean(4 * x, 4 * y, 4, 4, channel)));
        return most;
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

} // namespace

TEST_CASE("Each image of a rip-map is the mean over what its texels cover") {
    const Texels texels(32, 8, 1);
    const ColorImage map = make_rip_map(image_of(texels));
    REQUIRE(map.width == 63);
    REQUIRE(map.height == 15);
    double worst = 0;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 4; ++j)
            for (int y = 0; y < 8 >> j; ++y)
                for (int x = 0; x < 32 >> i; ++x)
                    for (int channel = 0; channel < 4; ++channel) {
                        const int column = 64 - (64 >> i) + x, row = 16 - (16 >> j) + y;
                        const int place = 4 * (row * 63 + column) + channel;
                        const auto at = static_cast<std::size_t>(place);
                        const double mean = texels.mean(x << i, y << j, 1 << i, 1 << j, channel);
                        const double error = std::fabs(std::to_integer<int>(map.texels[at]) - mean);
                        worst = std::max(worst, error / (i + j + 1));
                    }
    CHECK(worst <= 0.5); // A rounding for each halving, and none for the source.
}

TEST_CASE("The words of a summed-area table are sums of texels") {
    const Texels texels(7, 5, 2);
    const ColorImage table = make_summed_area_table(image_of(texels));
    REQUIRE(table.width == 28);
    REQUIRE(table.height == 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x)
            for (int channel = 0; channel < 4; ++channel) {
                std::uint32_t word = 0;
                std::memcpy(
                    &word, table.texels.data() + 4 * (28 * y + 4 * x + channel), sizeof word);
                const double area = (x + 1) * (y + 1);
                CHECK(word == std::lround(texels.mean(0, 0, x + 1, y + 1, channel) * area));
            }
}

TEST_CASE_METHOD(FilterFixture, "The parameter of the filter is set, read and checked") {
    GLint value = 0;
    GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, &value);
    CHECK(value == GL_STANDARD_FILTER_FFGPU);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, GL_RIP_MAP_FILTER_FFGPU);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, GL_LINEAR);
    CHECK(GetError() == GL_INVALID_ENUM);
    GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, &value);
    CHECK(value == GL_RIP_MAP_FILTER_FFGPU);
    const std::string names = reinterpret_cast<const char*>(GetString(GL_EXTENSIONS));
    CHECK(names.find("GL_FFGPU_texture_filter ") != std::string::npos);
}

TEST_CASE_METHOD(FilterFixture, "Rip-map and summed-area table show the means, of new texels too") {
    Texels texels(Source, Source, 3);
    define(texels);
    CHECK(distance(drawn(), texels) > 50); // Bilinear at a quarter of the size.
    // Halved four times, then chosen exactly; the table's mean is rounded once.
    const auto [filter, tolerance] = GENERATE(std::pair{GL_RIP_MAP_FILTER_FFGPU, 2.001},
                                              std::pair{GL_SUMMED_AREA_FILTER_FFGPU, 0.501});
    INFO(filter);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, filter);
    CHECK(distance(drawn(), texels) < tolerance);

    const Texels part(Source, 4, 4);
    TexSubImage2D(GL_TEXTURE_2D, 0, 0, 8, Source, 4, GL_RGBA, GL_UNSIGNED_BYTE, part.bytes.data());
    std::copy(part.bytes.begin(), part.bytes.end(), texels.bytes.begin() + 8 * Source * 4);
    CHECK(distance(drawn(), texels) < tolerance);

    // From the picture, which the device itself copies.
    const Texels before = drawn();
    CopyTexSubImage2D(GL_TEXTURE_2D, 0, 16, 32, 0, 0, Size, Size);
    for (int y = 0; y < Size; ++y)
        std::copy_n(before.bytes.begin() + 4 * Size * y,
                    4 * Size,
                    texels.bytes.begin() + 4 * ((32 + y) * Source + 16));
    CHECK(distance(drawn(), texels) < tolerance);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(FilterFixture, "What was drawn into a texture is in its table") {
    GLuint texture = 0, framebuffer = 0;
    GenTextures(1, &texture);
    BindTexture(GL_TEXTURE_2D, texture);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    define(Texels(Source, Source, 5));
    const auto [filter, tolerance] = GENERATE(std::pair{GL_RIP_MAP_FILTER_FFGPU, 1.001},
                                              std::pair{GL_SUMMED_AREA_FILTER_FFGPU, 0.501});
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, filter);
    drawn(); // The table is there.
    GenFramebuffersEXT(1, &framebuffer);
    BindFramebufferEXT(GL_FRAMEBUFFER_EXT, framebuffer);
    FramebufferTexture2DEXT(
        GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, texture, 0);
    for (int round = 0; round < 2; ++round) {
        BindFramebufferEXT(GL_FRAMEBUFFER_EXT, framebuffer);
        ClearColor(static_cast<float>(round), 0.5f, 0.25f, 1);
        Clear(GL_COLOR_BUFFER_BIT);
        BindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0);
        const Texels picture = drawn();
        CHECK(std::abs(picture.at(3, 3, 0) - 255 * round) <= tolerance);
        CHECK(std::abs(picture.at(3, 3, 1) - 128) <= tolerance);
    }
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(FilterFixture, "A table holds what the sampler would read of the format") {
    const Texels texels(Source, Source, 6);
    define(texels, GL_LUMINANCE8);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, GL_SUMMED_AREA_FILTER_FFGPU);
    const Texels picture = drawn();
    for (int x = 0; x < Size; ++x) {
        const double mean = texels.mean(4 * x, 0, 4, 4, 0); // The red component is the luminance.
        for (int channel = 0; channel < 3; ++channel)
            CHECK(std::fabs(picture.at(x, 0, channel) - mean) < 0.501);
        CHECK(picture.at(x, 0, 3) == 255);
    }
}

TEST_CASE_METHOD(FilterFixture,
                 "Kinds of texture that the filters do not know are as OpenGL says") {
    const Texels texels(Source, 1, 7);
    Disable(GL_TEXTURE_2D);
    Enable(GL_TEXTURE_1D);
    TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    TexImage1D(
        GL_TEXTURE_1D, 0, GL_RGBA8, Source, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.bytes.data());
    const Texels before = drawn();
    for (int filter = GL_STANDARD_FILTER_FFGPU; filter <= GL_ELLIPTIC_FILTER_FFGPU; ++filter) {
        TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_FILTER_FFGPU, filter);
        CHECK(drawn().bytes == before.bytes);
    }
}
