#include "tests/gpu/mixture.h"

#include <cstdio>
#include <cstdlib>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

void draw_mixture(Scene& scene) {
    ffgpu::test::draw_mixture(scene, [](int) { return PrimitiveType::Triangles; });
}

void save(const char* name, const std::vector<std::uint32_t>& picture, int width, int height) {
    const char* const folder = std::getenv("FFGPU_TEST_PICTURES");
    if (!folder) return;
    std::FILE* const file = std::fopen((std::string(folder) + '/' + name).c_str(), "wb");
    if (!file) return;
    std::fprintf(file, "P6 %d %d 255\n", width, height);
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const int at = y * width + x;
            const std::uint32_t pixel = picture[static_cast<std::size_t>(at)];
            for (int shift = 0; shift < 24; shift += 8)
                std::fputc(static_cast<int>(pixel >> shift & 0xff), file);
        }
    std::fclose(file);
}

} // namespace

TEST_CASE("a triangle drawn by raw commands appears where its vertices say") {
    Scene scene(64, 64);
    scene.clear(0xff000000);
    scene.draw(PrimitiveType::Triangles,
               {{-1, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                {1, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                {-1, 1, 0, 1, 1, 0, 0, 1, 0, 0}});
    CHECK(scene.pixel(0, 0) == 0xff0000ff);
    CHECK(scene.pixel(62, 0) == 0xff0000ff);
    CHECK(scene.pixel(0, 62) == 0xff0000ff);
    CHECK(scene.pixel(63, 63) == 0xff000000);
    CHECK(scene.pixel(40, 40) == 0xff000000);
}

TEST_CASE("a GPU that was reset draws and counts as one that was made") {
    const auto state_of = [](Scene& scene) {
        std::vector<std::byte> memory(scene.gpu.memory_size());
        scene.gpu.read_memory(0, memory);
        return std::pair(std::move(memory), counters(scene.gpu));
    };
    Scene fresh(200, 150), used(200, 150);
    const auto power_on = state_of(fresh);
    draw_mixture(fresh);
    used.registers.fog.mode = FogMode::Linear;
    draw_mixture(used);
    used.gpu.reset();
    CHECK(used.gpu.registers() == Registers{});
    CHECK(state_of(used) == power_on);

    // What a scene sends depends on what it sent: its commands, by another of the same.
    Scene sender(200, 150);
    sender.into = &used.gpu;
    draw_mixture(sender);
    CHECK(state_of(used) == state_of(fresh));
}

TEST_CASE("a picture does not depend on tile size and threads") {
    std::vector<std::uint64_t> hashes;
    for (const unsigned tile_size : {16u, 24u, 64u, 128u})
        for (const unsigned threads : {1u, 2u, 3u}) {
            Scene scene(200, 150, {.threads = threads, .tile_size = tile_size});
            draw_mixture(scene);
            const std::vector<std::uint32_t> picture = scene.picture();
            save("mixture.ppm", picture, 200, 150);
            hashes.push_back(hash(picture) ^ hash(scene.depth_buffer()));
        }
    for (const std::uint64_t each : hashes)
        CHECK(each == hashes[0]);
}

TEST_CASE("a screen-aligned quad copies texels exactly") {
    constexpr int Size = 64;
    std::vector<std::uint32_t> texels;
    std::mt19937 random(3);
    for (int i = 0; i < Size * Size; ++i)
        texels.push_back(static_cast<std::uint32_t>(random()) | 0xff000000);
    for (const bool linear : {false, true}) {
        Scene scene(Size, Size);
        scene.clear(0);
        scene.texture(Size, texels);
        scene.registers.samplers[0].magnify_linear = linear;
        scene.registers.samplers[0].minify_linear = linear;
        scene.draw(PrimitiveType::Quads,
                   {{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                    {1, -1, 0, 1, 1, 1, 1, 1, 1, 0},
                    {1, 1, 0, 1, 1, 1, 1, 1, 1, 1},
                    {-1, 1, 0, 1, 1, 1, 1, 1, 0, 1}});
        CHECK(scene.picture() == texels);
    }
}
