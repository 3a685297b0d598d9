// Clears that leave alone what holds their value already: memory ends as if they wrote it all.

#include "model/gpu/bin.h"
#include "model/gpu/cleared_tiles.h"
#include "tests/gpu/depth_scene.h"

#include <array>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

std::uint64_t kept_clears(const FunctionalGpu& gpu) {
    for (const Counter& counter : gpu.host_statistics().counters())
        if (counter.name() == "kept_clears") return counter.value();
    return 0;
}

// A tile of words, written as ClearedTiles says, beside one that clears write whole.
struct TileBench {
    static constexpr int Size = 16;
    using Words = std::array<std::uint32_t, Size * Size>;

    explicit TileBench(std::uint32_t seed)
        : random(seed) {
        for (std::uint32_t& word : plain)
            word = static_cast<std::uint32_t>(random());
        words = plain;
    }

    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random()) % n; }
    Rectangle some_area() {
        const int x = static_cast<int>(below(Size)), y = static_cast<int>(below(Size));
        return {x, y, x + 1 + static_cast<int>(below(5)), y + 1 + static_cast<int>(below(5))};
    }

    template <class Write>
    static void write(Words& to, const Rectangle& area, Write&& value) {
        const Rectangle cut = intersect(area, {0, 0, Size, Size});
        for (int y = cut.y0; y < cut.y1; ++y)
            for (int x = cut.x0; x < cut.x1; ++x) {
                auto& word = to[static_cast<std::size_t>(y * Size + x)];
                word = value(word);
            }
    }

    void draw() {
        const Rectangle area = intersect(some_area(), {0, 0, Size, Size});
        tiles.draw(0, area);
        const auto value = static_cast<std::uint32_t>(random());
        const auto drawn = [value](std::uint32_t) { return value; };
        write(words, area, drawn);
        write(plain, area, drawn);
    }

    void clear() {
        constexpr std::array<std::uint32_t, 4> Masks{~0u, 0xffffff00u, 0xffu, 0x0fu};
        const bool whole = below(3) != 0;
        const Rectangle area =
            whole ? Rectangle{0, 0, Size, Size} : intersect(some_area(), {0, 0, Size, Size});
        const std::uint32_t value = below(2) * 0x01010101u, mask = Masks[below(4)];
        const auto filled = [=](std::uint32_t word) { return (word & ~mask) | (value & mask); };
        const Rectangle changed = tiles.clear(0, area, whole, value, mask);
        kept += changed != area;
        write(words, changed, filled);
        write(plain, area, filled);
    }

    std::mt19937 random;
    ClearedTiles tiles{Surface{}, Size, 1};
    Words words, plain;
    int kept = 0;
};

} // namespace

TEST_CASE("Where clears may change something is all that they change") {
    int kept = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        TileBench bench(seed);
        for (int i = 0; i < 60; ++i) {
            if (bench.below(2) == 0)
                bench.draw();
            else
                bench.clear();
            INFO("seed " << seed << ", step " << i);
            REQUIRE((bench.words == bench.plain));
        }
        kept += bench.kept;
    }
    CHECK(kept > 1000);
}

TEST_CASE("A clear to the same value writes what was drawn since") {
    constexpr int Width = 200, Height = 150;
    constexpr std::uint64_t All = 2 * Width * Height; // colour and depth
    Scene scene(Width, Height);
    scene.clear(5);
    scene.gpu.finish();
    CHECK(kept_clears(scene.gpu) == 0);

    // Two triangles over pixels 70 to 80 and 10 to 30, in one tile, that write no depth.
    const auto at = [](float x, float y) {
        return Vertex{2 * x / Width - 1, 2 * y / Height - 1, 0, 1, 1, 1, 1, 1, 0, 0};
    };
    scene.draw(PrimitiveType::Quads, {at(70, 10), at(80, 10), at(80, 30), at(70, 30)});
    scene.clear(5);
    CHECK(scene.pixel(75, 20) == 5);
    CHECK(kept_clears(scene.gpu) == All - 10 * 20);

    SECTION("to another colour all of that") {
        scene.clear(6);
        CHECK(scene.pixel(0, 0) == 6);
        CHECK(kept_clears(scene.gpu) == All - 10 * 20 + All / 2);
    }
    SECTION("of what the host wrote nothing is known") {
        scene.gpu.write_memory(ColorAt + 40, bytes_of(std::vector<std::uint32_t>{77}));
        scene.clear(5);
        CHECK(scene.pixel(10, 0) == 5);
        CHECK(kept_clears(scene.gpu) == All - 10 * 20 + All / 2);
    }
    SECTION("nor of what another device drew") {
        scene.gpu.settled_memory()[ColorAt] = std::byte{9};
        scene.clear(5);
        CHECK(scene.pixel(0, 0) == 5);
        CHECK(kept_clears(scene.gpu) == All - 10 * 20);
    }
    SECTION("nor after a reset") {
        scene.gpu.reset();
        CHECK(scene.pixel(0, 0) == 0);
    }
    SECTION("nor of what a target over the same bytes was cleared to") {
        scene.registers.targets.color[0].format = Format::Rgb565;
        scene.clear(0);
        scene.registers.targets.color[0].format = Format::Rgba8;
        scene.clear(5);
        CHECK(scene.pixel(0, 0) == 5);
    }
    SECTION("nor where targets lie one in the other") {
        scene.registers.targets.depth.address = ColorAt + 4 * Width;
        const std::uint64_t before = kept_clears(scene.gpu);
        scene.clear(5);
        scene.clear(5);
        scene.gpu.finish();
        CHECK(kept_clears(scene.gpu) == before);
    }
}

TEST_CASE("Memory is the same where clears are remembered") {
    constexpr DepthSceneKind Kinds[] = {
        {}, {.depth = Format::Depth16}, {.color = Format::Rgb565}, {.samples = MaxSamples}};
    std::uint64_t kept = 0;
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        const auto draw = [&](const FunctionalGpu::Config& config) {
            DepthScene random(seed, Kinds[seed % 4], config);
            Scene& scene = random.scene;
            std::vector<std::vector<std::byte>> held; // by the targets, frame after frame
            for (std::uint32_t frame = 0; frame < 12; ++frame) {
                scene.registers.blend.write_mask = 0xf;
                scene.registers.stencil.front.write_mask = 0xff;
                scene.clear(frame / 4);
                random.frame(5, false);
                Targets::for_each(scene.registers.targets, [&](const Surface& target) {
                    scene.gpu.read_memory(
                        target.address,
                        held.emplace_back(static_cast<std::size_t>(target.bytes())));
                });
            }
            kept += kept_clears(scene.gpu);
            return held;
        };
        INFO("seed " << seed);
        const std::uint64_t before = kept;
        const auto reference = draw({.stages = &ReferenceStages});
        CHECK(kept == before);
        CHECK((draw({}) == reference));
        CHECK((draw({.threads = 2, .tile_size = 16}) == reference));
    }
    CHECK(kept > 10000);
}

TEST_CASE("Large targets are cut into large tiles") {
    Bin bin(0, 4096);
    bin.reset(640, 480);
    CHECK(bin.tile_size() == 64);
    CHECK(bin.tile_count() == 10 * 8);
    bin.reset(1280, 720);
    CHECK(bin.tile_size() == 128);
    CHECK(bin.tile_count() == 10 * 6);
    Bin asked(32, 4096);
    asked.reset(1280, 720);
    CHECK(asked.tile_size() == 32);
}
