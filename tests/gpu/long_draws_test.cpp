// Draws that are longer than a bin, or than a chunk of geometry, which threads share.

#include "tests/gpu/scene.h"

#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

struct Drawn {
    std::vector<std::uint32_t> picture, depths;
    std::vector<std::uint64_t> counts;

    bool operator==(const Drawn&) const = default;
};

// Small and large triangles that are blended one over the other: their order shows. Each long draw
// is followed by a short one, and some by a clear of a part.
Drawn draw_long(const FunctionalGpu::Config& config) {
    Scene scene(200, 150, config);
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
    const auto vertices = [&](int count, float size) {
        std::vector<Vertex> made;
        float x = 0, y = 0;
        for (int i = 0; i < count; ++i) {
            if (i % 12 == 0) x = unit(), y = unit();
            const float w = 1.5f + 0.5f * unit();
            made.push_back({(x + size * unit()) * w,
                            (y + size * unit()) * w,
                            unit() * w,
                            w,
                            unit(),
                            unit(),
                            unit(),
                            0.5f + 0.5f * unit(),
                            unit(),
                            unit()});
        }
        return made;
    };
    std::vector<std::uint32_t> texels;
    for (std::uint32_t i = 0; i < 64 * 64; ++i)
        texels.push_back(static_cast<std::uint32_t>(random()) | 0xff000000);
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.registers.blend.enable = true;
    scene.registers.blend.rgb_source = BlendFactor::SourceAlpha;
    scene.registers.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
    scene.clear(0xff402000);
    int draw = 0;
    for (const PrimitiveType type : {PrimitiveType::Triangles,
                                     PrimitiveType::TriangleStrip,
                                     PrimitiveType::TriangleFan,
                                     PrimitiveType::Quads,
                                     PrimitiveType::QuadStrip,
                                     PrimitiveType::Triangles}) {
        if (draw == 2) scene.texture(64, texels);
        scene.registers.primitive.flat_shading = draw == 3;
        scene.draw(type, vertices(2500 + 1500 * draw, draw % 2 ? 0.4f : 0.05f));
        scene.draw(PrimitiveType::Triangles, vertices(12, 0.5f));
        if (draw++ % 2 == 0) continue;
        scene.registers.scissor = {20, 30, 40, 50};
        scene.clear(0xff103050);
        scene.registers.scissor = {0, 0, 200, 150};
    }
    Drawn drawn{scene.picture(), scene.depth_buffer(), {}};
    for (const StatisticsGroup* group : scene.gpu.statistics())
        for (const Counter& counter : group->counters())
            drawn.counts.push_back(counter.value());
    return drawn;
}

// A line whose pattern begins where the draw before ended, if it is to.
void draw_line(Scene& scene, float from, float to, bool goes_on) {
    scene.registers.primitive.line_stipple = true;
    scene.registers.primitive.line_stipple_pattern = 0x00ff;
    const std::vector<Vertex> ends{{from, 0, 0, 1, 1, 1, 1, 1, 0, 0},
                                   {to, 0, 0, 1, 1, 1, 1, 1, 0, 0}};
    scene.into->write_memory(TextureAt, bytes_of(ends));
    scene.command(DrawCommand{.primitive = PrimitiveType::LineStrip,
                              .continue_line_stipple = goes_on,
                              .count = 2,
                              .vertex_count = 2,
                              .vertex_address = TextureAt});
}

} // namespace

TEST_CASE("long draws have one picture and one count, whoever shares them and however bins end") {
    const Drawn alone = draw_long({.threads = 1});
    CHECK(alone == draw_long({.threads = 1, .bin_bytes = 1 << 14}));
    for (const unsigned threads : {2u, 3u, 5u})
        for (const std::size_t bin_bytes : {std::size_t{1} << 14, std::size_t{1} << 19}) {
            INFO(threads << " threads, bins of " << bin_bytes << " bytes");
            const Drawn shared = draw_long({.threads = threads, .bin_bytes = bin_bytes});
            CHECK((shared.picture == alone.picture));
            CHECK((shared.depths == alone.depths));
            CHECK(shared.counts == alone.counts);
        }
    CHECK(alone == draw_long({.threads = 3, .tile_size = 16, .stages = &ReferenceStages}));
}

TEST_CASE("samples are counted to the end of a draw that takes several bins") {
    constexpr int Columns = 50, Rows = 40; // Each pixel of the target lies in one of the quads.
    for (const unsigned threads : {1u, 2u}) {
        Scene scene(2 * Columns, 2 * Rows, {.threads = threads, .bin_bytes = 1 << 14});
        scene.clear(0);
        scene.registers.fragment.count_samples = true;
        std::vector<Vertex> vertices;
        for (int row = 0; row < Rows; ++row)
            for (int column = 0; column < Columns; ++column)
                for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                    vertices.push_back({2.0f * static_cast<float>(column + x) / Columns - 1,
                                        2.0f * static_cast<float>(row + y) / Rows - 1,
                                        0,
                                        1,
                                        1,
                                        1,
                                        1,
                                        1,
                                        0,
                                        0});
        scene.draw(PrimitiveType::Quads, vertices);
        CommandStream stream;
        stream.add(Opcode::StoreSampleCounter, {TextureAt});
        scene.gpu.submit(stream);
        std::vector<std::uint64_t> count(1);
        scene.gpu.read_memory(TextureAt, std::as_writable_bytes(std::span(count)));
        CHECK(count[0] == 4u * Columns * Rows);
    }
}

TEST_CASE("the line stipple goes on over a long draw without a viewport, whoever shares it") {
    const auto pictured = [](unsigned threads) {
        Scene scene(64, 8, {.threads = threads});
        draw_line(scene, -1, -0.9f, false);
        scene.registers.viewport.width = 0;
        scene.draw(PrimitiveType::Triangles, std::vector<Vertex>(3000));
        scene.registers.viewport.width = 64;
        draw_line(scene, -0.9f, 1, true);
        return scene.picture();
    };
    CHECK((pictured(3) == pictured(1)));
}

TEST_CASE("a GPU that was reset begins a line's pattern anew") {
    Scene used(64, 8), fresh(64, 8);
    draw_line(used, -1, -0.9f, false);
    used.gpu.reset();
    Scene sender(64, 8);
    sender.into = &used.gpu;
    draw_line(sender, -1, 1, true);
    draw_line(fresh, -1, 1, true);
    CHECK((used.picture() == fresh.picture()));
}

// Undefined in OpenGL.
TEST_CASE("a long draw whose vertices or indices lie in its target is the same for all threads") {
    constexpr std::uint32_t Size = 512, Count = 20000;
    for (const bool indexed : {false, true}) {
        const auto pictured = [&](unsigned threads) {
            Scene scene(Size, Size, {.threads = threads});
            const DeviceAddress at = indexed ? VerticesAt : ColorAt;
            std::vector<Vertex> vertices(Count);
            for (std::uint32_t i = 0; i < Count; ++i) {
                const float x = static_cast<float>(i * 37 % 251) / 125 - 1;
                const float y = static_cast<float>(i * 91 % 241) / 120 - 1;
                vertices[i] = {x, y, 0, 1, x, y, 0.5f, 1, 0, 0};
            }
            std::vector<std::uint32_t> indices(Count);
            for (std::uint32_t i = 0; i < Count; ++i)
                indices[i] = i;
            scene.gpu.write_memory(at, bytes_of(vertices));
            if (indexed) scene.gpu.write_memory(ColorAt, bytes_of(indices));
            scene.command(DrawCommand{.primitive = PrimitiveType::TriangleStrip,
                                      .index_type = indexed ? IndexType::U32 : IndexType::None,
                                      .count = Count,
                                      .vertex_count = Count,
                                      .vertex_address = at,
                                      .index_address = ColorAt});
            return scene.picture();
        };
        CHECK((pictured(3) == pictured(1)));
    }
}
