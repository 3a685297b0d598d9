// What the functional GPU counts while it draws.

#pragma once

#include "model/base/statistics.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// One worker's share; plain numbers, added up when a bin is done.
struct FragmentCounts {
    std::uint64_t covered = 0;
    std::uint64_t killed_early_depth = 0, killed_coverage = 0, killed_alpha = 0, killed_stencil = 0,
                  killed_depth = 0;
    std::uint64_t written = 0;
    std::uint64_t batches = 0, quads = 0;
    std::uint64_t tiles = 0;
    std::uint64_t samples_covered = 0, samples_written = 0;
    std::uint64_t counted_samples = 0; // that passed while samples were counted
    std::uint64_t hidden_blocks = 0;
    std::uint64_t kept_clears = 0;
};

struct FragmentStatistics : StatisticsGroup {
    Counter& covered = count("fragments_covered", "fragments", "made by the rasterizer");
    Counter& killed_early_depth = count(
        "fragments_killed_early_depth", "fragments", "ended at the depth test before texturing");
    Counter& killed_coverage = count("fragments_killed_coverage",
                                     "fragments",
                                     "left without a sample by alpha or the sample mask");
    Counter& killed_alpha = count("fragments_killed_alpha", "fragments", "ended at the alpha test");
    Counter& killed_stencil =
        count("fragments_killed_stencil", "fragments", "ended at the stencil test");
    Counter& killed_depth =
        count("fragments_killed_depth", "fragments", "ended at the depth test after texturing");
    Counter& written = count("fragments_written", "fragments", "passed all tests");
    Counter& samples_covered =
        count("samples_covered", "samples", "of multisampled targets, by covered fragments");
    Counter& samples_written =
        count("samples_written", "samples", "of multisampled targets, passed all tests");
    Counter& quads = count("quads", "quads", "with at least one covered fragment");

    void add(const FragmentCounts& counts) {
        covered += counts.covered;
        killed_early_depth += counts.killed_early_depth;
        killed_coverage += counts.killed_coverage;
        killed_alpha += counts.killed_alpha;
        killed_stencil += counts.killed_stencil;
        killed_depth += counts.killed_depth;
        written += counts.written;
        samples_covered += counts.samples_covered;
        samples_written += counts.samples_written;
        quads += counts.quads;
    }
};

// Depends on tile size, threads and when a bin was full: never a part of a result.
struct HostStatistics : StatisticsGroup {
    Counter& batches = count("batches", "batches", "of up to 64 quads of one tile and state");
    Counter& tiles = count("tiles_visited", "tiles", "carried out, once for each bin");
    Counter& bins = count("bins", "bins", "carried out");
    Counter& hidden_blocks = count("hidden_blocks", "blocks", "of hidden fragments, passed over");
    Counter& kept_clears =
        count("kept_clears", "pixels", "of cleared targets that held the value already");

    void add(const FragmentCounts& counts) {
        batches += counts.batches;
        tiles += counts.tiles;
        hidden_blocks += counts.hidden_blocks;
        kept_clears += counts.kept_clears;
    }
};

struct PrimitiveStatistics : StatisticsGroup {
    Counter& draws = count("draw_commands", "draws", "draws of vertices and images");
    Counter& primitives = count("primitives_set_up", "primitives", "handed to set-up");
    Counter& empty = count("primitives_empty", "primitives", "that cover no pixel centre");
    Counter& below_1 = count("primitives_below_1", "primitives", "with an area below 1 pixel");
    Counter& below_4 = count("primitives_1_to_4", "primitives", "of 1 to 4 pixels");
    Counter& below_16 = count("primitives_4_to_16", "primitives", "of 4 to 16 pixels");
    Counter& below_100 = count("primitives_16_to_100", "primitives", "of 16 to 100 pixels");
    Counter& below_1000 = count("primitives_100_to_1000", "primitives", "of 100 to 1000 pixels");
    Counter& above_1000 = count("primitives_above_1000", "primitives", "of more than 1000 pixels");

    void add_area(double pixels) {
        ++(pixels < 1      ? below_1
           : pixels < 4    ? below_4
           : pixels < 16   ? below_16
           : pixels < 100  ? below_100
           : pixels < 1000 ? below_1000
                           : above_1000);
    }
};

} // namespace ffgpu
