// Texels that are written between two draws of the machine in time: what is read anew, counted from
// the coordinates.

#include "tests/timing/picture_quads.h"

#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t Lines = PictureSize * PictureSize / 16; // of blocks of 4x4 texels

// Draws a picture, writes the first `texels` of row `row` of its texture, and draws it again.
Figures draw_write_draw(const TimingConfig& config, std::uint32_t row, std::uint32_t texels) {
    GpuTiming timing(config);
    work::CommandAssembler assembler(timing);
    const auto bin = std::make_shared<const WorkBin>(picture());
    assembler.bin(bin);
    assembler.end_frame(0);
    if (texels > 0)
        timing.host_transfer({.is_write = true,
                              .at = bin->draws[0].state->images[0].address + row * PictureSize * 4,
                              .bytes = texels * 4});
    assembler.bin(bin);
    assembler.end_frame(1);
    return figures_of(timing);
}

// That holds the whole texture.
TimingConfig large_cache() {
    TimingConfig config = caches_machine(2, Distribution::Tiles, 8);
    config.texel_cache.per_pipe = false;
    config.texel_cache.ways = 2 * Lines;
    return config;
}

TEST_CASE("A part of a texture that is written between draws is all that is read anew") {
    TimingConfig config = large_cache();
    SECTION("with LRU replacement") {}
    SECTION("with optimal replacement") {
        config.texel_cache.replacement = work::Replacement::Optimal;
    }
    SECTION("in sets") {
        config.texel_cache.sets = 1024;
        config.texel_cache.ways = 8;
    }
    for (const std::uint32_t texels : {0u, 1u, 4u, 5u, 256u}) {
        const std::uint32_t rewritten = (texels + 3) / 4; // blocks
        const Figures figures = draw_write_draw(config, 17, texels);
        INFO(texels << " texels");
        CHECK(figures.at("texel_cache_misses") == Lines + rewritten);
        CHECK(figures.at("texel_cache_compulsory_misses") == Lines + rewritten);
        CHECK(figures.at("memory_texture_read_bytes") == 64 * (Lines + rewritten));
    }
}

TEST_CASE("A second level forgets what was rewritten, too") {
    TimingConfig config = large_cache();
    config.texel_l2.enable = true;
    config.texel_l2.sets = 1;
    config.texel_l2.ways = 2 * Lines;
    for (const std::uint32_t line_bytes : {64u, 256u}) {
        config.texel_l2.line_bytes = line_bytes;
        config.memory.interleave_bytes = 256;
        const Figures figures = draw_write_draw(config, 17, 20); // 5 blocks side by side
        const std::uint64_t rewritten = line_bytes == 64 ? 5 : 2;
        CHECK(figures.at("texel_cache_misses") == Lines + 5);
        CHECK(figures.at("texel_l2_misses") == Lines * 64 / line_bytes + rewritten);
    }
}

TEST_CASE("Each pipe's cache forgets what was rewritten of what it holds") {
    TimingConfig config = large_cache();
    config.texel_cache.per_pipe = true;
    const std::uint32_t row = 17, texels = 20;
    std::array<std::set<unsigned>, 2> held;
    for (const QuadLines& quad : quads_in_order())
        for (const unsigned line : quad.lines)
            held[pipe_of(quad, Distribution::Tiles, 8, 2)].insert(line);
    const Figures figures = draw_write_draw(config, row, texels);
    for (std::size_t pipe = 0; pipe < held.size(); ++pipe) {
        std::uint64_t expected = held[pipe].size();
        for (unsigned block = 0; block < texels / 4; ++block)
            expected += held[pipe].count(row / 4 * (PictureSize / 4) + block);
        CHECK(figures.at("texel_cache_" + std::to_string(pipe) + "_misses") == expected);
    }
}

TEST_CASE("A level that moves is read anew as a whole") {
    TimingConfig config = large_cache();
    config.texel_cache.rewritten = work::RewrittenLevel::NewPlace;
    CHECK(draw_write_draw(config, 17, 1).at("texel_cache_misses") == 2 * Lines);
}

TEST_CASE("Figures of rewritten texels do not depend on how the clock goes") {
    TimingConfig config = large_cache();
    config.texel_l2.enable = true;
    const auto run_at = [&](const Evaluation& evaluation) {
        GpuTiming timing(config, evaluation);
        work::CommandAssembler assembler(timing);
        const auto bin = std::make_shared<const WorkBin>(picture());
        for (std::uint32_t frame = 0; frame < 3; ++frame) {
            assembler.bin(bin);
            timing.host_transfer({.is_write = true,
                                  .at = bin->draws[0].state->images[0].address + frame * 4096,
                                  .bytes = 4096});
            assembler.bin(bin);
            if (frame != 1) assembler.end_frame(frame);
        }
        return figures_of(timing);
    };
    const Figures expected = run_at({});
    CHECK(run_at({0, Pace::EveryCycle}) == expected);
    CHECK(run_at({0, Pace::Lockstep}) == expected);
    CHECK(run_at({12345, Pace::Decoupled}) == expected);
}

} // namespace
} // namespace ffgpu::timing
