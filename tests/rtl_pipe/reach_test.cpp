// The fragment pipe in RTL against the model at the ends of what its numbers hold: targets and
// images as large as they may be, anywhere in memory, and draws by every bit of their number.

#include "tests/gpu/scene.h"
#include "tools/rtl/pipe_comparison.h"

#include <algorithm>
#include <bit>
#include <random>
#include <utility>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr rtl::PipeOptions Memory{.latency = 4, .quiet_cycles = 1 << 14};

// Two rows of corners or two columns of them, at x and y in -1 .. 1; s, t and r follow x, depth
// both.
test::Vertex corner(float x, float y) {
    const float along = 0.5f + x / 2;
    return {x, y, (x + y) / 4, 1, along, 1 - along, 0.5f, along, along, along};
}

std::vector<test::Vertex> rectangle(float x0, float y0, float x1, float y1) {
    return {corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)};
}

void write_noise(test::Scene& scene, DeviceAddress at, std::uint32_t words) {
    std::mt19937 random(3);
    std::vector<std::uint32_t> noise(words);
    std::ranges::generate(noise, random);
    scene.into->write_memory(at, std::as_bytes(std::span(noise)));
}

TEST_CASE("The pipe draws on targets as wide and as high as they may be") {
    const auto [width, height] =
        GENERATE(std::pair{int{MaxSurfaceSize}, 4}, std::pair{4, int{MaxSurfaceSize}});
    PipeComparison comparison(Memory);
    test::Scene scene(width, height);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0x80402010);
    // `along` its long side, and across; colours follow that side.
    const bool is_wide = width > height;
    const auto place = [&](float along, float across) {
        test::Vertex vertex = corner(along, across);
        if (!is_wide) std::swap(vertex.x, vertex.y);
        return vertex;
    };
    // The whole, then what begins and ends far from where the target does.
    scene.draw(PrimitiveType::TriangleFan,
               {place(-1, -1), place(1, -1), place(1, 1), place(-1, 1)});
    for (const float at : {-0.7f, -0.1f, 0.3f, 0.95f}) {
        scene.draw(PrimitiveType::Triangles,
                   {place(at, -1), place(at + 0.04f, 0), place(at + 0.03f, 1)});
        INFO(comparison.summary());
        REQUIRE(comparison.equal());
    }
    CHECK(comparison.fragments().at("") > 4 * MaxSurfaceSize);
    CHECK(scene.colors() > 250);
}

struct Image {
    TextureKind kind;
    Format format;
    std::uint32_t width, height, depth;
    std::uint32_t border = 0;
};

// A step of 64 texels a pixel along the long axis: each of them has a place of its own.
TEST_CASE("The pipe finds the texels of images as large as they may be") {
    constexpr std::uint32_t Most = MaxTextureSize;
    const Image image =
        GENERATE(Image{TextureKind::OneD, Format::Rgba8, Most, 1, 1},
                 Image{TextureKind::TwoD, Format::Rgba8, Most, 4, 1},
                 Image{TextureKind::TwoD, Format::Luminance8, 4, Most, 1},
                 Image{TextureKind::Rectangle, Format::Rgb565, Most, 3, 1},
                 Image{TextureKind::Rectangle, Format::Rgb565, 3, Most, 1},
                 Image{TextureKind::ThreeD, Format::Rgba8, 4, 4, MaxTexture3dSize},
                 Image{TextureKind::TwoD, Format::Dxt5, Most, 4, 1},
                 Image{TextureKind::TwoD, Format::Dxt1Rgba, 4, Most, 1},
                 Image{TextureKind::TwoD, Format::Fxt1Rgba, Most, 4, 1},
                 Image{TextureKind::TwoD, Format::Fxt1Rgba, 8, Most, 1},
                 Image{TextureKind::OneD, Format::Rgba8, Most, 1, 1, 1},
                 Image{TextureKind::TwoD, Format::Rgba8, Most, 4, 1, 1},
                 Image{TextureKind::TwoD, Format::Luminance8, 4, Most, 1, 1},
                 Image{TextureKind::ThreeD, Format::Rgba8, 4, 4, MaxTexture3dSize, 1});
    const bool linear = GENERATE(false, true);
    PipeComparison comparison(Memory);
    test::Scene scene(64, 8);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.texture(1, {0}); // its sampler
    write_noise(scene, test::TextureAt, 0x10000);
    Registers& registers = scene.registers;
    registers.images[0].shape = {
        image.kind, image.format, image.width, image.height, image.depth, 1, image.border};
    registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear = linear;
    registers.samplers[0].wrap.fill(image.border ? Wrap::ClampToBorder : Wrap::ClampToEdge);
    // s, t and r: those of rectangles count texels.
    registers.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0)] = {3, 7};
    auto vertices = rectangle(-1, -1, 1, 1);
    if (image.border) // and beyond its edges
        for (test::Vertex& vertex : vertices)
            for (float* const along : {&vertex.a, &vertex.s, &vertex.t})
                *along = 1.2f * *along - 0.1f;
    if (image.kind == TextureKind::Rectangle)
        for (test::Vertex& vertex : vertices) {
            vertex.a *= static_cast<float>(image.width);
            vertex.s *= static_cast<float>(image.height);
        }
    scene.clear(0);
    scene.draw(PrimitiveType::TriangleFan, vertices);
    INFO(format_info(image.format).name << " " << image.width << " x " << image.height << " x "
                                        << image.depth << "\n"
                                        << comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments() == std::map<std::string, std::uint64_t>{{"", 64 * 8}});
    CHECK(scene.colors() > 40);
}

// Each level has a colour. Two draws of one: each bank of the texture unit has it.
TEST_CASE("The pipe finds as many levels as an image may have") {
    const std::uint32_t most = std::bit_width(std::uint32_t{MaxTextureSize});
    PipeComparison comparison(Memory);
    test::Scene scene(64, 8);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.texture(1, {0}); // its sampler
    Registers& registers = scene.registers;
    registers.samplers[0].mip_filter = MipFilter::Nearest;
    TextureShape& shape = registers.images[0].shape;
    shape = {TextureKind::TwoD, Format::Rgba8, MaxTextureSize, 4, 1, most, 0};
    const auto color = [](std::uint32_t level) { return 0xff00'0000 | level * 0x14'0a05; };
    for (std::uint32_t level = 0; level < most; ++level) {
        const LevelLayout layout = level_layout(shape, level);
        const std::vector<std::uint32_t> texels(layout.bytes / 4, color(level));
        scene.into->write_memory(static_cast<DeviceAddress>(test::TextureAt + layout.offset),
                                 std::as_bytes(std::span(texels)));
    }
    scene.clear(0);
    for (std::uint32_t level = 0; level < most; ++level)
        for (unsigned time = 0; time < 2; ++time) {
            auto vertices = rectangle(-1, -1, 1, 1);
            for (test::Vertex& vertex : vertices) {
                vertex.s *= static_cast<float>(64u << level) / MaxTextureSize;
                vertex.t = 0;
            }
            scene.draw(PrimitiveType::TriangleFan, vertices);
            INFO("level " << level << "\n" << comparison.summary());
            REQUIRE(comparison.equal());
            CHECK(scene.pixel(20, 3) == color(level));
        }
}

// Over q the power of two of s and t is held to a range, where the exponents would not hold those
// of single pixels: attributes as small and as large as geometry hands over, planes that cross 0 in
// the picture by steps of their last bit.
TEST_CASE("Coordinates over a q of any magnitude are the model's") {
    PipeComparison comparison(Memory);
    test::Scene scene(16, 16);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.texture(4, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    scene.registers.samplers[0].wrap.fill(Wrap::ClampToEdge);
    const unsigned unit = GENERATE(0u, 6u);
    Registers& registers = scene.registers;
    std::swap(registers.images[0], registers.images[unit]);
    std::swap(registers.samplers[0], registers.samplers[unit]);
    std::swap(registers.combiners[0], registers.combiners[unit]);
    const auto texture = static_cast<unsigned>(CombineSource::Texture0) + unit;
    for (CombineHalf* half : {&registers.combiners[unit].rgb, &registers.combiners[unit].alpha})
        half->arguments[0].source = static_cast<CombineSource>(texture);
    // s and t in blue and alpha, q in t.
    registers.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0) + unit] = {4, 6};
    scene.clear(0xffffffff);
    struct Plane {
        float step, level;
        float at(float x) const { return level + step * (x - 0.0625f); }
    };
    constexpr std::array Planes{Plane{0x1p-66f, 0},
                                Plane{0, 0x1p-59f},
                                Plane{0x1p-4f, 1},
                                Plane{0x1p51f, 0},
                                Plane{0, 0x1.ep59f}};
    for (const Plane& s : Planes)
        for (const Plane& t : Planes)
            for (const Plane& q : Planes) {
                std::vector<test::Vertex> corners;
                for (const auto& [x, y, w] : {std::array{-100.0f, -100.0f, 0.53f},
                                              std::array{300.0f, -100.0f, 0.53f},
                                              std::array{-100.0f, 300.0f, 0.54f}})
                    corners.push_back({x * w, y * w, 0, w, 0, 0, s.at(x), t.at(y), 0, q.at(x)});
                scene.draw(PrimitiveType::Triangles, corners);
                INFO(
                    fmt::format("unit {} s {:a}, t {:a}, q {:a}", unit, s.at(1), t.at(1), q.at(1)));
                INFO(comparison.summary());
                REQUIRE(comparison.equal());
            }
    CHECK(comparison.fragments().at("") == 125 * 256);
}

// Products of numbers that are not held to fog's range leave binary32's.
TEST_CASE("Fog coordinates of any magnitude are the model's") {
    PipeComparison comparison(Memory);
    test::Scene scene(8, 8);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    Registers& registers = scene.registers;
    // In t.
    registers.vertex_format.elements[static_cast<unsigned>(Attribute::FogCoordinate)] = {1, 9};
    registers.fog.source = FogCoordinateSource::Attribute;
    registers.fog.color = 0x20c0ff;
    scene.clear(0);
    for (const FogMode mode : {FogMode::Linear, FogMode::Exp, FogMode::Exp2})
        for (const float density : {0x1p-40f, 0x1p-8f, 1.0f, 0x1p40f})
            for (const float coordinate : {0x1p-59f, 0x1p-30f, 0.5f, 0x1p20f, 0x1p59f})
                for (const float sign : {1.0f, -1.0f}) {
                    registers.fog.mode = mode;
                    registers.fog.density = registers.fog.end = density;
                    auto vertices = rectangle(-1, -1, 1, 1);
                    for (test::Vertex& vertex : vertices)
                        vertex.t = sign * coordinate * (1.5f + vertex.x / 4);
                    scene.draw(PrimitiveType::TriangleFan, vertices);
                    INFO(fmt::format("mode {}, density {:a}, coordinate {:a}",
                                     static_cast<unsigned>(mode),
                                     density,
                                     sign * coordinate));
                    INFO(comparison.summary());
                    REQUIRE(comparison.equal());
                }
    CHECK(comparison.fragments().at("") == 120 * 64);
}

// Planes of slivers rise more from pixel to pixel than depth has room for, by more than their steps
// hold: what they say of a centre is held to the depths of the corners.
TEST_CASE("Depths of slivers are the model's") {
    PipeComparison comparison(Memory);
    test::Scene scene(64, 64);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.registers.depth = {.test_enable = true, .write_enable = true, .compare = Compare::Always};
    scene.clear(0);
    std::mt19937 random(17);
    const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < 1500; ++i) {
        const float x = unit(), y = unit(), along = unit(), up = unit();
        const float width = 1.0f / 2048; // of a 64th of a pixel
        const float end = i % 2 == 0 ? 0.9f : -0.9f;
        for (const auto& [u, v, z] : {std::array{0.0f, 0.0f, -end},
                                      std::array{along + width, up - width, end},
                                      std::array{along, up, -end}})
            vertices.push_back({x + u, y + v, z, 1, 1, 1, 1, 1, 0, 0});
    }
    scene.draw(PrimitiveType::Triangles, vertices);
    INFO(comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments().at("") > 150);
    // Some end at either corner's depth.
    const std::vector<std::uint32_t> depths = scene.depth_buffer();
    const auto count = [&](float z) {
        const auto depth = static_cast<std::uint32_t>((0.5 + double{z} / 2) * 0xffffff + 0.5);
        return std::ranges::count_if(depths, [&](std::uint32_t d) { return d >> 8 == depth; });
    };
    CHECK(count(-0.9f) > 20);
    CHECK(count(0.9f) > 20);
}

// Where an address loses a bit there is nothing.
TEST_CASE("Targets and images of the pipe lie anywhere in memory") {
    PipeComparison comparison(Memory);
    test::Scene scene(16, 16, {.memory_bytes = std::uint64_t{1} << 32});
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    const bool is_high = GENERATE(false, true);
    scene.texture(1, {0}); // its sampler
    Registers& registers = scene.registers;
    registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 1, 0};
    registers.images[0].address = is_high ? 0xffff'8000 : 0x5555'5540;
    registers.targets.color[0].address = is_high ? 0xaaaa'aaa8 : 0x5abc'def0;
    registers.targets.depth.address = is_high ? 0xf0f0'0000 : 0x0f0f'fff8;
    registers.depth = {.test_enable = true, .write_enable = true};
    write_noise(scene, registers.images[0].address, 16 * 16);
    scene.clear(0);
    scene.draw(PrimitiveType::TriangleFan, rectangle(-1, -1, 1, 1));
    scene.draw(PrimitiveType::TriangleFan, rectangle(-0.5f, -0.5f, 0.7f, 1));
    INFO(comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments().at("") > 256);
}

// The last rows, layers and levels of hundreds of megabytes. A texel a pixel has a colour.
TEST_CASE("Rows, layers and levels of the pipe lie as far apart as they may") {
    constexpr std::uint32_t Size = 16, MostRows = MaxSurfaceSize;
    constexpr DeviceAddress ImageAt = 0x2000'0000;
    const TextureShape shape = GENERATE(
        TextureShape{TextureKind::TwoD, Format::Rgba8, MaxTextureSize, MaxTextureSize, 1, 2, 0},
        TextureShape{TextureKind::ThreeD,
                     Format::Rgba8,
                     MaxTexture3dSize,
                     MaxTexture3dSize,
                     MaxTexture3dSize,
                     2,
                     0});
    const std::uint32_t level = GENERATE(0u, 1u);
    PipeComparison comparison(Memory);
    test::Scene scene(Size, Size, {.memory_bytes = std::uint64_t{1} << 32});
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    scene.texture(1, {0}); // its sampler
    Registers& registers = scene.registers;
    registers.images[0].shape = shape;
    registers.images[0].address = ImageAt;
    registers.samplers[0].mip_filter = MipFilter::Nearest;
    registers.samplers[0].max_lod = static_cast<std::int16_t>(256 * level);
    registers.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0)] = {3, 7};
    // Rows further from each other than 64 KB, of which the uppermost are drawn on.
    constexpr std::uint32_t Stride = 0x1'2000;
    registers.targets.color[0] = {0x8000'0000, Format::Rgba8, Size, MostRows, Stride};
    registers.targets.depth = {0xb000'0000, Format::Depth24Stencil8, Size, MostRows, Stride};
    registers.depth = {.test_enable = true, .write_enable = true, .compare = Compare::Always};
    registers.scissor.height = MostRows;
    registers.viewport.y = MostRows - Size;
    const LevelLayout layout = level_layout(shape, level);
    const auto place = [&](std::uint32_t at, std::uint32_t size) {
        return std::uint64_t{(2 * at + 1) * size / (2 * Size)};
    };
    for (std::uint32_t y = 0; y < Size; ++y)
        for (std::uint32_t x = 0; x < Size; ++x) {
            const std::uint32_t color = 0xff00'0000 | y << 12 | x << 4;
            const std::uint64_t at =
                ImageAt + layout.offset + place(y, layout.depth) * layout.layer_stride +
                place(y, layout.height) * layout.row_stride + place(x, layout.width) * 4;
            scene.into->write_memory(static_cast<DeviceAddress>(at),
                                     std::as_bytes(std::span(&color, 1)));
        }
    auto vertices = rectangle(-1, -1, 1, 1);
    for (test::Vertex& vertex : vertices) {
        vertex.a = 0.5f + vertex.x / 2;
        vertex.s = vertex.t = 0.5f + vertex.y / 2;
    }
    scene.draw(PrimitiveType::TriangleFan, vertices);
    INFO(comparison.summary());
    CHECK(comparison.equal());
    CHECK(comparison.fragments() == std::map<std::string, std::uint64_t>{{"", Size * Size}});
    std::uint32_t last = 0;
    scene.gpu.read_memory(0x8000'0000 + (MostRows - 1) * Stride + (Size - 1) * 4,
                          std::as_writable_bytes(std::span(&last, 1)));
    CHECK(last == 0xff00'f0f0);
}

// What the texture unit holds of an image stays for the draws of one number, and for no other.
TEST_CASE("Draws are told apart by every bit of their number") {
    PipeComparison comparison(Memory);
    test::Scene scene(4, 4);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    constexpr std::array Colors{0xff2040ffu, 0x80ff1030u};
    scene.texture(1, {Colors[0]});
    scene.into->write_memory(test::TextureAt + 64, std::as_bytes(std::span(&Colors[1], 1)));
    scene.clear(0);
    const auto draw = [&](std::uint32_t number, unsigned image) {
        comparison.number_draws_from(number);
        scene.registers.images[0].address = test::TextureAt + 64 * image;
        scene.draw(PrimitiveType::TriangleFan, rectangle(-1, -1, 1, 1));
        INFO("draw " << number << "\n" << comparison.summary());
        REQUIRE(comparison.equal());
        CHECK(scene.pixel(1, 2) == Colors[image]);
    };
    for (unsigned bit = 0; bit < 32; ++bit) {
        const std::uint32_t number = 0x9249'2492 ^ bit * 0x0102'0408;
        draw(number, 0);
        draw(number ^ 1u << bit, 1);
    }
}

} // namespace
} // namespace ffgpu::tools
