#include "tests/gpu/scene.h"

#include <map>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// Keeps what it is told, as one list of numbers.
class Recorder : public WorkSink {
public:
    void bin(std::shared_ptr<const WorkBin> bin) override {
        for (const WorkDraw& draw : bin->draws) {
            add(static_cast<std::uint64_t>(draw.kind));
            add(draw.number);
            add(draw.early_depth);
            add(draw.geometry.vertices.size());
            ++draws;
        }
        for (const HostTransfer& transfer : bin->transfers)
            (transfer.is_write ? written : read) += transfer.bytes;
        for (const WorkTile& tile : bin->tiles) {
            add(tile.x);
            add(tile.y);
            for (const WorkBatch& batch : tile.batches) {
                REQUIRE(batch.draw < bin->draws.size());
                for (const WorkQuad& quad : batch.quads)
                    take(quad);
                for (const TexelFootprints& unit : batch.textures)
                    accesses += unit.accesses().size();
            }
        }
    }
    void end_frame(std::uint32_t frame) override { frames.push_back(frame); }

    std::vector<std::uint64_t> numbers;
    std::uint64_t draws = 0, covered = 0, passed = 0, accesses = 0, written = 0, read = 0;
    std::vector<std::uint32_t> frames;

private:
    void add(std::uint64_t number) { numbers.push_back(number); }

    void take(const WorkQuad& quad) {
        add(quad.primitive);
        add(std::uint64_t{quad.x} << 16 | quad.y);
        add(quad.covered);
        add(quad.after_depth);
        REQUIRE((quad.after_early_depth & ~quad.covered) == 0);
        REQUIRE((quad.after_coverage & ~quad.after_early_depth) == 0);
        REQUIRE((quad.after_alpha & ~quad.after_coverage) == 0);
        REQUIRE((quad.after_stencil & ~quad.after_alpha) == 0);
        REQUIRE((quad.after_depth & ~quad.after_stencil) == 0);
        covered += static_cast<unsigned>(std::popcount(quad.covered));
        passed += static_cast<unsigned>(std::popcount(quad.after_depth));
    }
};

void draw_some(Scene& scene) {
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0);
    scene.texture(16, std::vector<std::uint32_t>(256, 0xff123456));
    std::mt19937 random(5);
    const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
    for (int draw = 0; draw < 10; ++draw) {
        std::vector<Vertex> vertices;
        for (int i = 0; i < 60; ++i)
            vertices.push_back({unit(), unit(), unit(), 1, 1, 1, 1, 1, unit(), unit()});
        scene.draw(PrimitiveType::Triangles, vertices);
    }
    CommandStream stream;
    stream.add(Opcode::EndFrame);
    scene.gpu.submit(stream);
}

} // namespace

TEST_CASE("recording the work changes no pixel, and the work adds up to the counters") {
    Scene plain(150, 100), recorded(150, 100);
    Recorder recorder;
    recorded.gpu.set_work_sink(&recorder);
    draw_some(plain);
    draw_some(recorded);
    CHECK(plain.picture() == recorded.picture());
    auto counts = counters(recorded.gpu);
    CHECK(recorder.covered == counts["fragments_covered"]);
    CHECK(recorder.passed == counts["fragments_written"]);
    CHECK(recorder.covered > 10000);
    CHECK(recorder.passed < recorder.covered);
    CHECK(recorder.accesses >= recorder.passed); // Each was textured.
    CHECK(recorder.draws == 11);                 // and a clear
    CHECK(recorder.frames == std::vector<std::uint32_t>{0});
    CHECK(recorder.written == 10 * 60 * sizeof(Vertex) + 1024);
    auto plain_counts = counters(plain.gpu);
    CHECK(plain_counts == counts);
}

TEST_CASE("the work stream does not depend on the number of threads") {
    std::vector<std::uint64_t> first;
    for (const unsigned threads : {1u, 3u}) {
        Scene scene(150, 100, {.threads = threads, .tile_size = 32});
        Recorder recorder;
        scene.gpu.set_work_sink(&recorder);
        draw_some(scene);
        if (threads == 1)
            first = recorder.numbers;
        else
            CHECK(recorder.numbers == first);
    }
}
