#include "tests/gpu/mixture.h"

#include <array>
#include <bit>
#include <map>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

constexpr DeviceAddress ResolvedAt = 0x700000;
constexpr DeviceAddress CounterAt = 0x7f0000;

// A scene whose targets have four samples a pixel.
class SampledScene : public Scene {
public:
    SampledScene(int width, int height, FunctionalGpu::Config config = {})
        : Scene(width, height, config) {
        registers.targets.color[0].samples = registers.targets.depth.samples = MaxSamples;
        registers.multisample.enable = true;
    }

    std::vector<std::uint32_t> samples(const Surface& surface, unsigned i) {
        std::vector<std::uint32_t> words(std::size_t{surface.width} * surface.height);
        gpu.read_memory(surface.plane(i).address, std::as_writable_bytes(std::span(words)));
        return words;
    }
    std::vector<std::uint32_t> color_samples(unsigned i) {
        return samples(registers.targets.color[0], i);
    }

    std::vector<std::uint32_t> resolved() {
        const Surface& source = registers.targets.color[0];
        Surface picture = source;
        picture.address = ResolvedAt;
        picture.samples = 1;
        command(CopyRectangleCommand{.source = source,
                                     .destination = picture,
                                     .width = source.width,
                                     .height = source.height});
        return samples(picture, 0);
    }

    std::uint64_t hash_all() {
        std::uint64_t all = hash(resolved());
        for (unsigned i = 0; i < MaxSamples; ++i)
            for (const Surface& surface : {registers.targets.color[0], registers.targets.depth})
                all = all * 31 + hash(samples(surface, i));
        return all;
    }

    // Samples that pass in what `draw` draws.
    template <class Draw>
    std::uint64_t counted(Draw&& draw) {
        CommandStream stream;
        stream.add(Opcode::ResetSampleCounter);
        gpu.submit(stream);
        registers.fragment.count_samples = true;
        draw();
        registers.fragment.count_samples = false;
        stream.clear();
        stream.add(Opcode::StoreSampleCounter, {CounterAt});
        gpu.submit(stream);
        std::uint64_t count = 0;
        gpu.read_memory(CounterAt, std::as_writable_bytes(std::span(&count, 1)));
        return count;
    }
};

Vertex at(float x, float y, float z = 0) {
    return {x, y, z, 1, 1, 1, 1, 1, 0, 0};
}

// The window's part left of x (in clip coordinates), white.
void draw_left_of(Scene& scene, float x, float z = 0) {
    scene.draw(PrimitiveType::Quads, {at(-1, -1, z), at(x, -1, z), at(x, 1, z), at(-1, 1, z)});
}

template <class AnyScene>
void draw_sampled_mixture(AnyScene& scene) {
    draw_mixture(scene, [&scene](int draw) {
        scene.registers.multisample.alpha_to_coverage = draw % 7 == 0;
        scene.registers.multisample.sample_mask = draw % 11 == 0 ? 0x6 : 0xf;
        scene.registers.primitive.line_width = 2.5f;
        return draw % 3 == 1 ? PrimitiveType::LineStrip : PrimitiveType::Triangles;
    });
}

// Adds the samples of the quads up.
class SampleCounter : public WorkSink {
public:
    void bin(std::shared_ptr<const WorkBin> bin) override {
        for (const WorkTile& tile : bin->tiles)
            for (const WorkBatch& batch : tile.batches)
                for (const WorkQuad& quad : batch.quads) {
                    covered += static_cast<unsigned>(std::popcount(quad.samples_covered));
                    written += static_cast<unsigned>(std::popcount(quad.samples_written));
                    for (unsigned lane = 0; lane < 4; ++lane) {
                        const bool covers = (quad.samples_covered >> 4 * lane & 0xf) != 0;
                        const bool writes = (quad.samples_written >> 4 * lane & 0xf) != 0;
                        REQUIRE(covers == ((quad.covered >> lane & 1) != 0));
                        REQUIRE(writes == ((quad.after_depth >> lane & 1) != 0));
                    }
                    REQUIRE((quad.samples_written & ~quad.samples_covered) == 0);
                }
    }
    void end_frame(std::uint32_t) override {}

    std::uint64_t covered = 0, written = 0;
};

} // namespace

TEST_CASE(
    "an edge between two samples writes the samples on its side, and resolves to their share") {
    // Samples stand at 2, 6, 10 and 14 sixteenths of a pixel in x.
    const std::array<unsigned, 5> covered{0x0, 0x4, 0x5, 0xd, 0xf};
    for (unsigned n = 0; n < covered.size(); ++n) {
        SampledScene scene(16, 16);
        scene.clear(0xff000000);
        draw_left_of(scene, (8 + static_cast<float>(n) * 0.25f) / 8 - 1);
        for (unsigned i = 0; i < MaxSamples; ++i) {
            INFO("edge " << n << ", sample " << i);
            const auto samples = scene.color_samples(i);
            CHECK(samples[16 * 5 + 7] == 0xffffffff);
            CHECK(samples[16 * 5 + 8] == ((covered[n] >> i & 1) != 0 ? 0xffffffff : 0xff000000));
            CHECK(samples[16 * 5 + 9] == 0xff000000);
        }
        const std::uint32_t gray = (255 * n + 2) / 4;
        CHECK(scene.resolved()[16 * 5 + 8] == (0xff000000 | gray * 0x010101));
    }
}

TEST_CASE("with multisampling off every sample is the picture of a single-sampled target") {
    Scene single(100, 75);
    single.registers.primitive.point_smooth = single.registers.primitive.line_smooth = true;
    SampledScene sampled(100, 75);
    sampled.registers.primitive = single.registers.primitive;
    sampled.registers.multisample.enable = false;
    draw_sampled_mixture(single);
    draw_sampled_mixture(sampled);
    const auto picture = single.picture();
    const auto depths = single.depth_buffer();
    for (unsigned i = 0; i < MaxSamples; ++i) {
        CHECK((sampled.color_samples(i) == picture));
        CHECK((sampled.samples(sampled.registers.targets.depth, i) == depths));
    }
    CHECK((sampled.resolved() == picture));
}

TEST_CASE("multisampled pictures do not depend on tile size and threads") {
    std::vector<std::uint64_t> hashes;
    for (const unsigned tile_size : {16u, 24u, 64u, 128u})
        for (const unsigned threads : {1u, 3u}) {
            SampledScene scene(200, 150, {.threads = threads, .tile_size = tile_size});
            draw_sampled_mixture(scene);
            hashes.push_back(scene.hash_all());
        }
    for (const std::uint64_t each : hashes)
        CHECK(each == hashes[0]);
}

TEST_CASE("samples are the same whether depth is tested early or late") {
    SampledScene early(64, 64), late(64, 64);
    for (SampledScene* scene : {&early, &late}) {
        scene->registers.depth = {.test_enable = true, .write_enable = true};
        scene->clear(0);
        if (scene == &late) { // An alpha test that lets all pass.
            scene->registers.fragment.alpha_test = true;
            scene->registers.fragment.alpha_compare = Compare::Always;
        }
        std::mt19937 random(9);
        const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
        std::vector<Vertex> vertices;
        for (int i = 0; i < 300; ++i)
            vertices.push_back(
                {unit(), unit(), unit(), 1, 0.5f * unit() + 0.5f, unit(), 1, 1, 0, 0});
        scene->draw(PrimitiveType::Triangles, vertices);
    }
    CHECK(early.hash_all() == late.hash_all());
    CHECK(counters(early.gpu)["fragments_killed_early_depth"] > 0);
    CHECK(counters(late.gpu)["fragments_killed_early_depth"] == 0);
}

TEST_CASE("two planes that cross do so sample by sample") {
    SampledScene scene(16, 16);
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0xff000000);
    draw_left_of(scene, 1);
    // In front of the first left of the middle of pixel 8, in red.
    const float middle = 8.5f / 8 - 1;
    std::vector<Vertex> slope{at(-1, -1, -1 - middle),
                              at(1, -1, 1 - middle),
                              at(1, 1, 1 - middle),
                              at(-1, 1, -1 - middle)};
    for (Vertex& vertex : slope)
        vertex.g = vertex.b = 0, vertex.z *= 0.5f;
    scene.draw(PrimitiveType::Quads, slope);
    for (unsigned i = 0; i < MaxSamples; ++i) {
        const auto samples = scene.color_samples(i);
        const bool left = i == 0 || i == 2;
        CHECK(samples[16 * 3 + 7] == 0xff0000ff);
        CHECK(samples[16 * 3 + 8] == (left ? 0xff0000ff : 0xffffffff));
        CHECK(samples[16 * 3 + 9] == 0xffffffff);
    }
}

TEST_CASE("an occlusion query counts samples") {
    SampledScene scene(16, 16);
    scene.clear(0);
    CHECK(scene.counted([&] { draw_left_of(scene, 1); }) == 16 * 16 * 4);
    CHECK(scene.counted([&] { draw_left_of(scene, 8.5f / 8 - 1); }) == 16 * (8 * 4 + 2));
    scene.registers.multisample.sample_mask = 0x7;
    CHECK(scene.counted([&] { draw_left_of(scene, 1); }) == 16 * 16 * 3);
}

TEST_CASE("the work stream's samples add up to the counters") {
    SampledScene scene(150, 100), plain(150, 100);
    SampleCounter counter;
    scene.gpu.set_work_sink(&counter);
    draw_sampled_mixture(scene);
    draw_sampled_mixture(plain);
    CHECK(scene.hash_all() == plain.hash_all());
    scene.gpu.finish();
    auto counts = counters(scene.gpu);
    CHECK(counter.covered == counts["samples_covered"]);
    CHECK(counter.written == counts["samples_written"]);
    CHECK(counter.written > 10000);
    CHECK(counts["fragments_killed_coverage"] > 0);
    CHECK(counts["fragments_covered"] ==
          counts["fragments_killed_early_depth"] + counts["fragments_killed_coverage"] +
              counts["fragments_killed_alpha"] + counts["fragments_killed_stencil"] +
              counts["fragments_killed_depth"] + counts["fragments_written"]);
}

TEST_CASE("an image's pixel covers the samples in its rectangle") {
    SampledScene scene(16, 16);
    scene.clear(0xff000000);
    const std::vector<std::uint32_t> pixels{0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff};
    scene.gpu.write_memory(TextureAt, bytes_of(pixels));
    DrawImageCommand image{.format = Format::Rgba8,
                           .address = TextureAt,
                           .stride = 8,
                           .width = 2,
                           .height = 2,
                           .x = 4.5f,
                           .y = 6};
    SECTION("half a pixel to the right of the grid") {
        scene.command(image);
        for (unsigned i = 0; i < MaxSamples; ++i) {
            const auto samples = scene.color_samples(i);
            const bool left = i == 0 || i == 2;
            INFO("sample " << i);
            CHECK(samples[16 * 6 + 4] == (left ? 0xff000000 : pixels[0]));
            CHECK(samples[16 * 6 + 5] == (left ? pixels[0] : pixels[1]));
            CHECK(samples[16 * 6 + 6] == (left ? pixels[1] : 0xff000000));
            CHECK(samples[16 * 7 + 5] == (left ? pixels[2] : pixels[3]));
            CHECK(samples[16 * 5 + 5] == 0xff000000);
        }
    }
    SECTION("all four pixels of the image in one of the window") {
        image.x = 4;
        image.zoom_x = image.zoom_y = 0.5f;
        scene.command(image);
        // Sample 0 lies below to the left, 1 below to the right, 2 above to the left.
        for (unsigned i = 0; i < MaxSamples; ++i)
            CHECK(scene.color_samples(i)[16 * 6 + 4] == pixels[i]);
        CHECK(counters(scene.gpu)["fragments_written"] == 4);
        CHECK(counters(scene.gpu)["samples_written"] == 4);
    }
    SECTION("stencil values") {
        const std::vector<std::uint8_t> values{1, 2, 3, 4};
        scene.gpu.write_memory(TextureAt, bytes_of(values));
        image.format = Format::Stencil8;
        image.stride = 2;
        image.x = 4;
        image.zoom_x = image.zoom_y = 0.5f;
        scene.command(image);
        for (unsigned i = 0; i < MaxSamples; ++i)
            CHECK((scene.samples(scene.registers.targets.depth, i)[16 * 6 + 4] & 255) == i + 1);
    }
}

TEST_CASE("targets that differ in their samples are refused") {
    SampledScene scene(16, 16);
    scene.registers.targets.depth.samples = 1;
    CHECK_THROWS_AS(scene.clear(0), InputError);
    scene.registers.targets.depth.format = Format::None;
    CHECK_NOTHROW(scene.clear(0));
}
