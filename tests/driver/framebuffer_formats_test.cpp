// Drawing to textures of every uncompressed format, on the functional GPU.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu::gl::entry;
using ffgpu::gl::OffscreenContext;

namespace {

using Color = std::array<int, 4>;

// What a target of a base format holds of a colour, and what it reads as (GL 1.5, table 6.1).
struct Target {
    GLint format;
    unsigned stored; // channels, red the lowest bit
    int step;        // between two levels of a channel with the fewest bits
};

constexpr Target TargetFormats[] = {{GL_RGBA8, 0xf, 1},
                                    {GL_RGB8, 0x7, 1},
                                    {GL_RGB5, 0x7, 8},
                                    {GL_RGBA4, 0xf, 17},
                                    {GL_RGB5_A1, 0xf, 8},
                                    {GL_LUMINANCE8, 0x1, 1},
                                    {GL_LUMINANCE8_ALPHA8, 0x9, 1},
                                    {GL_ALPHA8, 0x8, 1},
                                    {GL_INTENSITY8, 0x1, 1}};

struct FormatsFixture {
    static constexpr GLsizei Size = 5; // odd: quads hang over the edge

    FormatsFixture()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = 8, .height = 8}) {
        gl.make_current();
        PixelStorei(GL_PACK_ALIGNMENT, 1);
        GLuint framebuffer = 0;
        GenFramebuffers(1, &framebuffer);
        BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        GenTextures(1, &texture);
        BindTexture(GL_TEXTURE_2D, texture);
        Viewport(0, 0, Size, Size);
        Disable(GL_DITHER);
    }

    void use(GLint format) {
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        TexImage2D(GL_TEXTURE_2D, 0, format, Size, Size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        REQUIRE(CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    }
    static void clear(const Color& color) {
        const auto part = [&](std::size_t i) { return static_cast<float>(color[i]) / 255.0f; };
        ClearColor(part(0), part(1), part(2), part(3));
        Clear(GL_COLOR_BUFFER_BIT);
    }
    static void draw(const Color& color) {
        const auto part = [&](std::size_t i) { return static_cast<GLubyte>(color[i]); };
        Color4ub(part(0), part(1), part(2), part(3));
        Rectf(-1, -1, 1, 1);
    }
    // The pixel in the upper right corner; all pixels are the same.
    static Color read() {
        std::vector<GLubyte> pixels(std::size_t{4} * Size * Size);
        ReadPixels(0, 0, Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        CHECK(GetError() == GL_NO_ERROR);
        for (std::size_t i = 4; i < pixels.size(); ++i)
            REQUIRE(pixels[i] == pixels[i - 4]);
        return {pixels[0], pixels[1], pixels[2], pixels[3]};
    }
    static Color stored(const Target& target, const Color& color) {
        Color result{0, 0, 0, 255};
        for (std::size_t i = 0; i < 4; ++i)
            if ((target.stored >> i & 1) != 0) result[i] = color[i];
        if (target.format == GL_RGB5_A1) result[3] = color[3] < 128 ? 0 : 255;
        return result;
    }
    static void check_near(const Target& target, const Color& actual, const Color& expected) {
        INFO("format " << std::hex << target.format);
        for (std::size_t i = 0; i < 4; ++i) {
            INFO("channel " << i);
            CHECK(std::abs(actual[i] - expected[i]) <= target.step / 2);
        }
    }

    ffgpu::FunctionalGpu device;
    OffscreenContext gl;
    GLuint texture = 0;
};

} // namespace

TEST_CASE_METHOD(FormatsFixture, "clears and draws store what a format has of a colour") {
    for (const Target& target : TargetFormats) {
        use(target.format);
        clear({200, 100, 50, 150});
        check_near(target, read(), stored(target, {200, 100, 50, 150}));
        draw({30, 60, 90, 120});
        check_near(target, read(), stored(target, {30, 60, 90, 120}));
    }
}

TEST_CASE_METHOD(FormatsFixture, "the colour mask keeps what it keeps, in draws and clears") {
    for (const Target& target : TargetFormats) {
        for (unsigned mask = 0; mask < 16; ++mask) {
            const Color before{200, 100, 50, 255}, after{30, 60, 90, 0};
            Color expected = before;
            for (std::size_t i = 0; i < 4; ++i)
                if ((mask >> i & 1) != 0) expected[i] = after[i];
            const auto bit = [&](unsigned i) -> GLboolean { return (mask >> i & 1) != 0; };
            use(target.format);
            clear(before);
            ColorMask(bit(0), bit(1), bit(2), bit(3));
            draw(after);
            check_near(target, read(), stored(target, expected));
            ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            clear(before);
            ColorMask(bit(0), bit(1), bit(2), bit(3));
            clear(after);
            check_near(target, read(), stored(target, expected));
            ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        }
    }
}

TEST_CASE_METHOD(FormatsFixture, "the destination's alpha is 1 where a format has none") {
    Enable(GL_BLEND);
    BlendFunc(GL_DST_ALPHA, GL_ZERO);
    for (const Target& target : TargetFormats) {
        if (target.format == GL_RGB5_A1) continue; // one bit of alpha: see the first test
        use(target.format);
        clear({102, 102, 102, 102});
        draw({200, 200, 200, 200});
        const bool has_alpha = (target.stored & 8) != 0 || target.format == GL_INTENSITY8;
        const int blended = has_alpha ? 80 : 200;
        check_near(target, read(), stored(target, {blended, blended, blended, blended}));
    }
}

TEST_CASE_METHOD(FormatsFixture, "logic operations work on the bits that are stored") {
    Enable(GL_COLOR_LOGIC_OP);
    LogicOp(GL_XOR);
    for (const Target& target : TargetFormats) {
        use(target.format);
        clear({255, 0, 255, 0});
        draw({255, 255, 0, 255});
        check_near(target, read(), stored(target, {0, 255, 255, 255}));
    }
}

TEST_CASE_METHOD(FormatsFixture, "a texture that was drawn to is sampled as its format says") {
    use(GL_LUMINANCE8);
    clear({120, 10, 20, 30});
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    Viewport(0, 0, 8, 8);
    Enable(GL_TEXTURE_2D);
    TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    draw({0, 0, 0, 77});
    CHECK(read() == Color{120, 120, 120, 77}); // GL_REPLACE of luminance keeps the alpha.
}

TEST_CASE_METHOD(FormatsFixture, "luminance is copied to a texture as red alone") {
    GLuint copy = 0;
    GenTextures(1, &copy);
    for (const GLint source : {GL_LUMINANCE8, GL_INTENSITY8}) {
        BindTexture(GL_TEXTURE_2D, texture);
        use(source);
        clear({120, 10, 20, 30});
        BindTexture(GL_TEXTURE_2D, copy);
        const auto copied = [](GLenum internal) {
            CopyTexImage2D(GL_TEXTURE_2D, 0, internal, 0, 0, Size, Size, 0);
            std::vector<GLubyte> texels(std::size_t{4} * Size * Size);
            GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
            return Color{texels[0], texels[1], texels[2], texels[3]};
        };
        CHECK(copied(GL_RGBA8) == Color{120, 0, 0, 255});
        CHECK(copied(static_cast<GLenum>(source)) == Color{120, 0, 0, 255});
        CHECK(copied(GL_LUMINANCE8) == Color{120, 0, 0, 255});
        CHECK(GetError() == GL_NO_ERROR);
    }
}

TEST_CASE_METHOD(FormatsFixture, "renderbuffers keep the format that they were given") {
    for (const Target& target : TargetFormats) {
        GLuint buffer = 0;
        GenRenderbuffers(1, &buffer);
        BindRenderbuffer(GL_RENDERBUFFER, buffer);
        RenderbufferStorage(GL_RENDERBUFFER, static_cast<GLenum>(target.format), Size, Size);
        FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
        REQUIRE(CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
        clear({200, 100, 50, 150});
        check_near(target, read(), stored(target, {200, 100, 50, 150}));
        DeleteRenderbuffers(1, &buffer);
    }
}

TEST_CASE_METHOD(FormatsFixture,
                 "an image that does not fit its texture is drawn to all the same") {
    GLuint cube = 0;
    GenTextures(1, &cube);
    BindTexture(GL_TEXTURE_CUBE_MAP, cube);
    const auto define = [](GLenum face, GLsizei size) {
        TexImage2D(face, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    };
    constexpr GLenum First = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    for (GLenum face = First; face < First + 6; ++face)
        define(face, face == First + 3 ? 2 * Size : Size); // One face is too large.
    FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, First, cube, 0);
    REQUIRE(CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    clear({200, 100, 50, 150});
    CHECK(read() == Color{200, 100, 50, 150});

    // Once all faces fit, the image moves to the others, with what it holds.
    const auto texel = [] {
        std::vector<GLubyte> texels(std::size_t{4} * Size * Size);
        GetTexImage(First, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        return Color{texels[0], texels[1], texels[2], texels[3]};
    };
    CHECK(texel() == Color{200, 100, 50, 150});
    define(First + 3, Size);
    CHECK(read() == Color{200, 100, 50, 150});
    clear({1, 2, 3, 4});
    CHECK(texel() == Color{1, 2, 3, 4});
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(FormatsFixture, "depth with stencil has no mip maps made of it") {
    TexImage2D(GL_TEXTURE_2D,
               0,
               GL_DEPTH24_STENCIL8,
               4,
               4,
               0,
               GL_DEPTH_STENCIL,
               GL_UNSIGNED_INT_24_8,
               nullptr);
    GenerateMipmap(GL_TEXTURE_2D);
    CHECK(GetError() == GL_INVALID_OPERATION);
}
