// Whole commands: nothing of the host is left in them, and every fragment has a name of its own.

#include "model/base/input_error.h"
#include "model/packets/fragment_key.h"
#include "model/packets/stage_probe.h"
#include "model/work/work_check.h"
#include "tests/work/recorded_work.h"

#include <bit>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr std::size_t SmallBin = 4096; // some ten records

TEST_CASE("Commands are the same however the host drew them") {
    const auto samples = GENERATE(std::uint8_t{1}, std::uint8_t{MaxSamples});
    const CommandList plain = recorded({}, samples);
    const std::string file = file_of(plain);
    REQUIRE(plain.commands.size() == 43); // a clear, 40 draws, an image, a copy
    for (const FunctionalGpu::Config& host : {FunctionalGpu::Config{.tile_size = 16},
                                              {.threads = 3, .tile_size = 128},
                                              {.bin_bytes = SmallBin},
                                              {.threads = 2, .tile_size = 32, .bin_bytes = 1}}) {
        INFO(host.threads << " threads, tiles of " << host.tile_size << ", bins of "
                          << host.bin_bytes);
        const CommandList other = recorded(host, samples);
        CHECK(other.log == plain.log);
        CHECK(file_of(other) == file);
    }
}

TEST_CASE("An upload stands between the draws that it came between") {
    const CommandList list = recorded({});
    // The clear; a draw's vertices before each draw, and once the texture; the image and a copy.
    std::string expected = "c";
    for (int draw = 0; draw < 40; ++draw)
        expected += draw == 10 ? "wwc" : "wc";
    CHECK(list.log == expected + "wcc" + "e");
}

TEST_CASE("Quads stand in the canonical order") {
    const CommandList list = recorded({.tile_size = 16}, MaxSamples);
    std::size_t quads = 0, pieces = 0;
    for (const auto& command : list.commands) {
        for (std::size_t i = 1; i < command->quads.size(); ++i)
            REQUIRE(comes_before(command->quads[i - 1], command->quads[i]));
        for (const WorkQuad& quad : command->quads)
            pieces += quad.piece > 0;
        quads += command->quads.size();
    }
    CHECK(quads > 10000);
    CHECK(pieces > 1000); // There were clipped primitives, quads, outlines.
}

TEST_CASE("Each quad belongs to a piece that geometry told of, and lies in its box") {
    const CommandList list = recorded({.tile_size = 16, .bin_bytes = std::size_t{2} << 10});
    std::size_t told = 0, drawn = 0, outside = 0;
    for (const auto& command : list.commands) {
        const GeometryWork& geometry = command->draw.geometry;
        if (command->draw.kind != WorkKind::Draw) continue;
        CHECK(command->draw.register_words >= command->draw.register_writes);
        std::size_t pieces = 0;
        for (const PrimitiveWork& primitive : geometry.primitives)
            pieces += primitive.pieces;
        CHECK(pieces == geometry.pieces.size());
        CHECK_NOTHROW(check_pieces(*command));
        told += pieces;
        drawn += command->quads.size();
        WholeCommand other = *command;
        if (other.quads.empty()) continue;
        other.quads.back().piece += 1000;
        CHECK_THROWS_AS(check_pieces(other), InputError);
        other = *command;
        other.quads.back().x = other.quads.back().y = 4000;
        outside += 1;
        CHECK_THROWS_AS(check_pieces(other), InputError);
    }
    CHECK(told > 500);
    CHECK(drawn > 10000);
    CHECK(outside > 20);
}

TEST_CASE("A piece that covers no pixel is handed on, unless its box has few pixels") {
    constexpr float Size = 64;
    const auto corner = [](float x, float y) {
        return test::Vertex{2 * x / Size - 1, 2 * y / Size - 1, 0, 1, 1, 1, 1, 1, 0, 0};
    };
    CommandList list;
    CommandAssembler assembler(list);
    test::Scene scene(64, 64);
    scene.gpu.set_work_sink(&assembler);
    scene.draw(PrimitiveType::Triangles,
               {// The centre of one pixel in its box, beyond the long edge.
                corner(10.6f, 10.6f),
                corner(11.7f, 10.6f),
                corner(10.6f, 11.7f),
                // A needle of four rows, left of their centres; of the block as well.
                corner(8.3f, 7.6f),
                corner(8.54f, 7.6f),
                corner(8.3f, 12.4f),
                // One pixel.
                corner(20.4f, 20.4f),
                corner(21.4f, 20.4f),
                corner(20.4f, 21.4f)});
    end_frame(scene);
    scene.gpu.set_work_sink(nullptr);
    REQUIRE(list.commands.size() == 1);
    CHECK(list.commands[0]->quads.size() == 1);
    const std::vector<PieceBox>& pieces = list.commands[0]->draw.geometry.pieces;
    REQUIRE(pieces.size() == 3);
    CHECK_FALSE(pieces[0].handed_on);
    CHECK(pieces[1].handed_on);
    CHECK(pieces[1].touched_blocks == 0);
    CHECK(pieces[2].handed_on);
    CHECK(pieces[2].touched_blocks == 1);
}

// The names of all fragments, or samples; fails where one is there already.
std::set<FragmentKey> names_of(const CommandList& list, bool samples) {
    std::set<FragmentKey> names;
    for (const auto& command : list.commands)
        for (const WorkQuad& quad : command->quads)
            for (unsigned lane = 0; lane < 4; ++lane)
                for (unsigned sample = 0; sample < (samples ? MaxSamples : 1); ++sample) {
                    const bool is_there =
                        samples ? (quad.samples_covered >> (4 * lane + sample) & 1) != 0
                                : (quad.covered >> lane & 1) != 0;
                    if (!is_there) continue;
                    REQUIRE(names
                                .insert({command->draw.number,
                                         quad.primitive,
                                         fragment_sequence(quad, lane, sample)})
                                .second);
                }
    return names;
}

// The names that a stage probe gives; fails where one is there already.
struct NamesOfProbe : StageProbe {
    bool samples = false;
    std::set<FragmentKey> names;

    void coverage(const probed::Batch& batch, const probed::Coverage&) override {
        const FragmentBatch& fragments = *batch.fragments;
        for (unsigned lane = 0; lane < fragments.lanes(); ++lane)
            for (unsigned sample = 0; sample < (samples ? MaxSamples : 1); ++sample)
                if ((samples ? fragments.samples[sample] : fragments.live).test(lane))
                    REQUIRE(names.insert(probed::key_of(batch, lane, sample)).second);
    }
};

TEST_CASE("A stage probe names fragments as the work stream does") {
    const bool samples = GENERATE(false, true);
    for (const FunctionalGpu::Config& host :
         {FunctionalGpu::Config{}, {.tile_size = 16, .bin_bytes = SmallBin}}) {
        test::Scene scene(150, 100, host);
        set_samples(scene, samples ? MaxSamples : 1);
        CommandList list;
        CommandAssembler assembler(list);
        NamesOfProbe probe;
        probe.samples = samples;
        scene.gpu.set_work_sink(&assembler);
        scene.gpu.set_stage_probe(&probe);
        draw_varied(scene);
        CHECK(probe.names == names_of(list, samples));
        CHECK(probe.names.size() > 40000);
        // Where samples are covered, several of an image's pixels touch one quad.
        bool pieces_of_image = false;
        for (const auto& command : list.commands)
            for (const WorkQuad& quad : command->quads)
                pieces_of_image |= command->draw.kind == WorkKind::Image && quad.piece > 0;
        CHECK(pieces_of_image == samples);
    }
}

std::uint64_t counted(test::Scene& scene, const char* name) {
    for (const StatisticsGroup* const group : scene.gpu.statistics())
        for (const Counter& counter : group->counters())
            if (counter.name() == name) return counter.value();
    return 0;
}

TEST_CASE("A key names one fragment, and a sample's key one sample") {
    for (const std::uint8_t samples : {std::uint8_t{1}, std::uint8_t{MaxSamples}}) {
        test::Scene scene(150, 100);
        set_samples(scene, samples);
        CommandList list;
        CommandAssembler assembler(list);
        scene.gpu.set_work_sink(&assembler);
        draw_varied(scene);
        const auto fragments = names_of(list, false);
        CHECK(fragments.size() == counted(scene, "fragments_covered"));
        CHECK(fragments.size() > 40000);
        if (samples == 1) continue;
        CHECK(names_of(list, true).size() == counted(scene, "samples_covered"));
    }
}

TEST_CASE("A sequence holds piece, row, column, lane and sample apart") {
    const WorkQuad quad{.primitive = 9,
                        .piece = 5,
                        .x = 6,
                        .y = 4,
                        .covered = 15,
                        .after_early_depth = 15,
                        .after_coverage = 15,
                        .after_alpha = 15,
                        .after_stencil = 15,
                        .after_depth = 15};
    CHECK(fragment_sequence(quad, 2, 3) == (5ull << 32 | 2ull << 17 | 3ull << 4 | 2ull << 2 | 3));
}

} // namespace
} // namespace ffgpu::work
