// HierarchicalDepth: the least and the greatest depth of each block of the depth targets, tested
// before the depth test itself (N. Greene, M. Kass, G. Miller, Hierarchical Z-Buffer Visibility,
// SIGGRAPH 1993; S. Morein, ATI Radeon HyperZ Technology, Hot3D at Graphics Hardware 2000).
//
// A line of the depth cache has a range that holds all its depths at all times, those that quads on
// their way may write included: a quad that may write widens it when it comes in. When a line
// leaves the cache its range becomes exact, if no such quad is on its way. A block is one line or
// several; what is tested is the union of their ranges, in the precision that is kept.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/config/depth.h"
#include "model/timing/pending_writes.h"
#include "model/work/block_code.h"
#include "model/work/prepared_work.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace ffgpu::timing {

class HierarchicalDepthStatistics : public StatisticsGroup {
public:
    Counter& tested = count("hierarchical_depth_quads", "quads", "tested against their blocks");
    Counter& culled = count("hierarchical_depth_culled_quads",
                            "quads",
                            "of which every fragment fails for certain: they end there");
    Counter& culled_fragments =
        count("hierarchical_depth_culled_fragments", "fragments", "of those quads");
    Counter& accepted = count("hierarchical_depth_accepted_quads",
                              "quads",
                              "of which every fragment passes for certain: depth is not read");
    Counter& saved_lines = count(
        "hierarchical_depth_saved_lines", "lines", "depth look-ups that culled quads did not make");
    Counter& saved_textures = count("hierarchical_depth_saved_texel_lines",
                                    "lines",
                                    "texel look-ups that culled quads did not make: draws that "
                                    "test late");
};

class HierarchicalDepth {
public:
    enum class Verdict : std::uint8_t { Unknown, Fails, Passes };
    struct Range {
        std::uint32_t least = 0;
        std::uint32_t greatest = ~std::uint32_t{0};
    };

    HierarchicalDepth(const HierarchicalDepthConfig& config, std::uint32_t line_bytes)
        : config_(config)
        , line_bytes_(line_bytes) {}

    // A new target, of whose depths nothing is known.
    void add(const work::PlacedLevel& place, Format format);

    // All depths of the line lie in the range now.
    void set(std::uint64_t line, Range range);
    void forget(std::uint64_t line);
    // A depth may come in.
    void widen(std::uint64_t line, std::uint32_t depth);
    // The same for all samples that a quad covers, but for those that fail for certain.
    void widen(const work::PreparedDraw& draw,
               const work::PreparedQuad& quad,
               const SampleWords& depths);
    // The line leaves the cache, with this content.
    void
    leave(std::uint64_t line, const work::BlockShape& shape, std::span<const std::byte> content);

    // What becomes of the samples that a quad of `draw` covers.
    Verdict test(const work::PreparedDraw& draw,
                 const work::PreparedQuad& quad,
                 const SampleWords& depths) const;

    // By lines: quads on their way to the late test.
    PendingWrites pending;
    HierarchicalDepthStatistics statistics;

private:
    struct Target {
        std::uint64_t first_line = 0;
        std::uint32_t greatest = 0; // of its format
        unsigned bits = 24;
        std::vector<Range> lines;
    };

    Target* find(std::uint64_t line);
    Range block(std::uint64_t line) const;

    const HierarchicalDepthConfig config_;
    std::uint32_t line_bytes_;
    std::map<std::uint64_t, Target> targets_; // by first line
};

// What a depth test against something within `range` gives.
HierarchicalDepth::Verdict
compare_range(Compare function, std::uint32_t depth, const HierarchicalDepth::Range& range);

// A quad whose fragments all fail leaves nothing behind: no stencil operation sees them.
bool failure_is_invisible(const Registers& state);

} // namespace ffgpu::timing
