// What the user forces on a program: filters, against the same filters asked for by the program.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "driver/ffgpu_texture_filter.h"
#include "model/gpu/functional_gpu.h"

#include <random>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr GLsizei Size = 32;
constexpr GLsizei Texels = 64;

// A turned rectangle, minified on one side and magnified on the other.
class TexturedWindow {
public:
    explicit TexturedWindow(ForcedFilter forced)
        : device_({.memory_bytes = 16u << 20})
        , gl_(device_,
              {.width = Size,
               .height = Size,
               .shared = std::make_shared<SharedObjects>(
                   std::make_shared<MemoryAllocator>(0, device_.memory_size()),
                   ControlPanel{.texture_filter = forced})}) {
        gl_.make_current();
        Bytes texels(4 * Texels * Texels);
        std::mt19937 random(9);
        for (std::uint8_t& byte : texels)
            byte = static_cast<std::uint8_t>(random() >> 8);
        TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
        TexImage2D(GL_TEXTURE_2D,
                   0,
                   GL_RGBA8,
                   Texels,
                   Texels,
                   0,
                   GL_RGBA,
                   GL_UNSIGNED_BYTE,
                   texels.data());
        TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        Enable(GL_TEXTURE_2D);
    }
    ~TexturedWindow() { CHECK(GetError() == GL_NO_ERROR); }

    static Bytes picture(GLint minifying) {
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minifying);
        Clear(GL_COLOR_BUFFER_BIT);
        Begin(GL_QUADS);
        for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            TexCoord2f(static_cast<GLfloat>(s) / 4, static_cast<GLfloat>(t));
            const GLfloat w = t == 0 ? 1.0f : 12.0f;
            Vertex4f((2 * static_cast<GLfloat>(s) - 1 + 0.125f) * w, t == 0 ? -w : 0.75f * w, 0, w);
        }
        End();
        Bytes pixels(4 * Size * Size);
        ReadPixels(0, 0, Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }

private:
    FunctionalGpu device_;
    OffscreenContext gl_;
};

Bytes asked(GLint filter, GLint minifying) {
    const TexturedWindow window(ForcedFilter::AsAsked);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, filter);
    return TexturedWindow::picture(minifying);
}

} // namespace

TEST_CASE("A filter that is forced draws what the same one draws that is asked for") {
    const GLint minifying = GENERATE(GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST_MIPMAP_NEAREST);
    const Bytes standard = asked(GL_STANDARD_FILTER_FFGPU, minifying);
    const std::pair<ForcedFilter, GLint> filters[] = {
        {ForcedFilter::Bicubic, GL_BICUBIC_FILTER_FFGPU},
        {ForcedFilter::RipMap, GL_RIP_MAP_FILTER_FFGPU},
        {ForcedFilter::SummedArea, GL_SUMMED_AREA_FILTER_FFGPU},
        {ForcedFilter::Elliptic, GL_ELLIPTIC_FILTER_FFGPU},
        {ForcedFilter::Feline, GL_FELINE_FILTER_FFGPU}};
    for (const auto& [forced, filter] : filters) {
        INFO(minifying << ", " << filter);
        const Bytes expected = asked(filter, minifying);
        const TexturedWindow window(forced);
        const Bytes picture = TexturedWindow::picture(minifying);
        CHECK((picture == expected));
        CHECK((picture != standard));
        GLint value = 0; // Programs do not see it.
        GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, &value);
        CHECK(value == GL_STANDARD_FILTER_FFGPU);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, GL_RIP_MAP_FILTER_FFGPU);
        CHECK((TexturedWindow::picture(minifying) == picture));
    }
}

TEST_CASE("The standard filter can be forced, and texels that are to be seen are left alone") {
    const Bytes standard = asked(GL_STANDARD_FILTER_FFGPU, GL_LINEAR);
    const Bytes table = asked(GL_SUMMED_AREA_FILTER_FFGPU, GL_NEAREST);
    const TexturedWindow window(ForcedFilter::Standard);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_FILTER_FFGPU, GL_SUMMED_AREA_FILTER_FFGPU);
    CHECK((TexturedWindow::picture(GL_LINEAR) == standard));
    CHECK((TexturedWindow::picture(GL_NEAREST) == table));
}
