// Deferred work must look as if each command had finished before the next began.

#include "tests/gpu/scene.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

std::vector<Vertex> full_quad(float r, float g, float b, float z = 0) {
    return {{-1, -1, z, 1, r, g, b, 1, 0, 0},
            {1, -1, z, 1, r, g, b, 1, 1, 0},
            {1, 1, z, 1, r, g, b, 1, 1, 1},
            {-1, 1, z, 1, r, g, b, 1, 0, 1}};
}

constexpr std::uint32_t Red = 0xff0000ff, Green = 0xff00ff00, Blue = 0xffff0000;

} // namespace

TEST_CASE("clears and draws act in the order of the commands") {
    Scene scene(100, 70);
    scene.clear(Red);
    scene.draw(PrimitiveType::Quads, full_quad(0, 1, 0));
    scene.registers.scissor = {10, 20, 30, 5};
    scene.clear(Blue);
    scene.registers.scissor = {0, 0, 100, 70};
    scene.send();
    const std::vector<std::uint32_t> picture = scene.picture();
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool cleared = x >= 10 && x < 40 && y >= 20 && y < 25;
            REQUIRE(picture[static_cast<std::size_t>(y * 100 + x)] == (cleared ? Blue : Green));
        }
}

TEST_CASE("a texture written after a draw does not change that draw") {
    Scene scene(32, 32);
    scene.texture(16, std::vector<std::uint32_t>(256, Red));
    scene.draw(PrimitiveType::Quads, full_quad(1, 1, 1));
    scene.gpu.write_memory(TextureAt, bytes_of(std::vector<std::uint32_t>(256, Green)));
    CHECK(scene.pixel(5, 5) == Red);
    scene.draw(PrimitiveType::Quads, full_quad(1, 1, 1));
    CHECK(scene.pixel(5, 5) == Green);
}

TEST_CASE("a draw sees what an earlier one rendered into its texture") {
    Scene scene(32, 32);
    const Surface window = scene.registers.targets.color[0];
    scene.registers.targets.color[0].address = TextureAt;
    scene.registers.targets.depth.format = Format::None;
    scene.draw(PrimitiveType::Quads, full_quad(0, 0, 1));
    scene.registers.targets.color[0] = window;
    scene.registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 32, 32, 1, 1, 0};
    scene.registers.images[0].address = TextureAt;
    scene.registers.combiners[0].enable = true;
    scene.registers.combiners[0].rgb.arguments[0].source = CombineSource::Texture0;
    scene.draw(PrimitiveType::Quads, full_quad(1, 1, 1));
    CHECK(scene.pixel(9, 9) == Blue);
}

TEST_CASE("a copy takes what was drawn before it and not what comes after") {
    Scene scene(32, 32);
    scene.draw(PrimitiveType::Quads, full_quad(1, 0, 0));
    CopyRectangleCommand copy;
    copy.source = copy.destination = scene.registers.targets.color[0];
    copy.destination.address = TextureAt;
    copy.width = copy.height = 32;
    scene.command(copy);
    scene.draw(PrimitiveType::Quads, full_quad(0, 1, 0));
    std::vector<std::uint32_t> copied(32 * 32);
    scene.gpu.read_memory(TextureAt, std::as_writable_bytes(std::span(copied)));
    CHECK(copied[77] == Red);
    CHECK(scene.pixel(3, 3) == Green);
}

TEST_CASE("more triangles than a bin holds draw what as many small draws do") {
    std::uint64_t hashes[2];
    for (const bool split : {false, true}) {
        Scene scene(128, 128);
        scene.clear(0);
        scene.registers.blend.enable = true;
        scene.registers.blend.rgb_source = BlendFactor::SourceAlpha;
        scene.registers.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
        std::vector<Vertex> vertices;
        for (int i = 0; i < 12000; ++i) {
            const float x = static_cast<float>(i * 37 % 256) / 128 - 1;
            const float y = static_cast<float>(i * 91 % 256) / 128 - 1;
            const float shade = static_cast<float>(i % 17) / 16;
            vertices.push_back({x, y, 0, 1, shade, 0.5f, 1 - shade, 0.6f, 0, 0});
            vertices.push_back({x + 0.1f, y, 0, 1, shade, 0.5f, 1 - shade, 0.6f, 0, 0});
            vertices.push_back({x, y + 0.08f, 0, 1, 0, 0.5f, 1 - shade, 0.6f, 0, 0});
        }
        const std::size_t step = split ? 300 : vertices.size();
        for (std::size_t at = 0; at < vertices.size(); at += step)
            scene.draw(PrimitiveType::Triangles,
                       {vertices.begin() + static_cast<std::ptrdiff_t>(at),
                        vertices.begin() + static_cast<std::ptrdiff_t>(at + step)});
        hashes[split] = hash(scene.picture());
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("the sample counter counts what passes between its reset and its store") {
    Scene scene(64, 48);
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0);
    scene.draw(PrimitiveType::Quads, full_quad(1, 0, 0, -0.5f)); // Not counted.
    scene.registers.fragment.count_samples = true;
    scene.registers.scissor = {0, 0, 10, 48};
    scene.draw(PrimitiveType::Quads, full_quad(0, 1, 0, -0.6f)); // In front.
    scene.draw(PrimitiveType::Quads, full_quad(0, 1, 0, 0.5f));  // Hidden.
    CommandStream stream;
    stream.add(Opcode::StoreSampleCounter, {TextureAt});
    stream.add(Opcode::ResetSampleCounter);
    stream.add(Opcode::StoreSampleCounter, {TextureAt + 8});
    scene.gpu.submit(stream);
    std::vector<std::uint64_t> counts(2);
    scene.gpu.read_memory(TextureAt, std::as_writable_bytes(std::span(counts)));
    CHECK(counts[0] == 480);
    CHECK(counts[1] == 0);
}

TEST_CASE("an image draw makes its pixels where it says, in order with the draws") {
    Scene scene(100, 100, {.tile_size = 16});
    scene.clear(0);
    scene.draw(PrimitiveType::Quads, full_quad(1, 0, 0));
    std::vector<std::uint32_t> image;
    for (std::uint32_t i = 0; i < 40 * 30; ++i)
        image.push_back(0xff000000 | i);
    scene.gpu.write_memory(TextureAt, bytes_of(image));
    DrawImageCommand command;
    command.address = TextureAt;
    command.stride = 160;
    command.width = 40;
    command.height = 30;
    command.x = 11;
    command.y = 13;
    scene.command(command);
    const std::vector<std::uint32_t> picture = scene.picture();
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool inside = x >= 11 && x < 51 && y >= 13 && y < 43;
            const auto i = static_cast<std::uint32_t>((y - 13) * 40 + x - 11);
            REQUIRE(picture[static_cast<std::size_t>(y * 100 + x)] ==
                    (inside ? 0xff000000 | i : Red));
        }
}
