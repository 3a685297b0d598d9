// MissCurves: the hits, misses and write-backs of LRU caches of one line size, of any number of
// sets and ways, from one pass over the look-ups (M. D. Hill, A. J. Smith, Evaluating Associativity
// in CPU Caches, IEEE Trans. Computers 38 (12), 1989). A line that was its set's last used is that
// of every smaller set, too: most look-ups touch few of the stacks. Lines that are only read (as
// texels are), or were so far, are in stacks that do no more (read_stacks.h).
//
// Misses are told by kind as miss_classifier.h has them, and by where the line was used last: the
// compulsory ones and the six of Reuse add up to all.

#pragma once

#include "model/work/line_numbers.h"
#include "model/work/line_stack.h"
#include "model/work/lookups.h"
#include "model/work/position_counts.h"
#include "model/work/read_stacks.h"
#include "model/work/set_reads.h"
#include "model/work/set_stacks.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ffgpu::work {

struct CacheCounts {
    std::uint64_t accesses = 0, misses = 0;
    std::uint64_t compulsory = 0, capacity = 0, conflict = 0;
    std::uint64_t hits_beyond_lru = 0; // where a fully associative cache of the size misses
    std::array<std::uint64_t, ReuseScopes + 1> by_reuse{}; // misses but the compulsory ones
    std::uint64_t write_backs = 0; // lines, by replacement, flushes and partial overwriting

    bool operator==(const CacheCounts&) const = default;
};

struct CurvesShape {
    std::uint32_t line_bytes = 64; // at least the look-ups' own, which `lookup_bytes` are
    std::uint32_t lookup_bytes = 64;
    std::uint32_t most_sets = 4096; // a power of two
    std::uint32_t most_ways = 32;   // of more sets than one
    bool merges = true;             // look-ups of one quad that fall on one line are one
    bool only_reads = false;        // no line is ever written
};

// What was counted, ready to be asked of any cache.
class CurveSums {
public:
    // `ways` up to most_ways; of one set any number.
    CacheCounts counts(std::uint32_t sets, std::uint32_t ways) const;

private:
    friend class MissCurves;
    // Of each position the counts from there on.
    using Sums = std::vector<std::uint64_t>;
    struct Stacks {
        std::array<Sums, ReuseScopes + 1> positions;
        Sums in_both; // empty of one set
        WriteBacks write_backs;
    };

    std::uint32_t most_ways_ = 0;
    std::uint64_t accesses_ = 0, compulsory_ = 0;
    std::vector<Stacks> stacks_; // of 1, 2, 4 ... sets
};

class MissCurves {
public:
    // Does jobs in their order, perhaps beside: those of the stacks of several sets, while lines
    // are only read, which nothing else waits for.
    using Beside = std::function<void(std::size_t weight, std::function<void()> job)>;

    explicit MissCurves(const CurvesShape& shape, Beside beside = at_once);
    MissCurves(const MissCurves&) = delete; // Jobs refer to it.
    MissCurves& operator=(const MissCurves&) = delete;

    void lookups(const LookupPlace& place, std::span<const LineLookup> lines);
    // The look-ups told last, which only read, once more by each of the `quads` up to `place`, all
    // of one tile: each of them finds the lines where the one before does.
    void
    lookups_again(const LookupPlace& place, std::span<const LineLookup> lines, std::uint32_t quads);
    void flush();
    void overwritten(std::span<const OverwrittenLine> lines);
    void end_frame();

    // Hands over what waits to be done beside. More look-ups may follow.
    void hand_over_reads();
    // When all jobs that were handed over are done.
    CurveSums sums();

    // Different lines that each frame looked up.
    const std::vector<std::uint64_t>& frame_lines() const { return frame_lines_; }
    const CurvesShape& shape() const { return shape_; }

private:
    static constexpr std::uint64_t Never = ReadStacks::Never;
    static constexpr std::uint32_t Nothing = ~std::uint32_t{0};

    // Look-ups that found their line near the top, by reuse, position among all lines, level and
    // position: nearly all of them, and one count says what two of PositionCounts do.
    class NearCounts {
    public:
        static constexpr std::uint32_t Depths = RecentLines::Most;

        explicit NearCounts(std::size_t levels)
            : levels_(levels)
            , depths_((ReuseScopes + 1) * Depths, 0)
            , counts_((ReuseScopes + 1) * Depths * levels * Depths, 0) {}

        void add(std::size_t reuse, std::uint32_t depth, Sharers positions, std::uint64_t times) {
            const std::size_t at = reuse * Depths + depth;
            depths_[at] += times;
            std::uint64_t* level = counts_.data() + at * levels_ * Depths;
            for (; positions != 0; positions >>= 4, level += Depths)
                level[positions % Depths] += times;
        }
        std::uint64_t of_reuse(std::size_t reuse) const;
        // Adds them to those of all depths.
        void add_to(ReuseHistograms& positions) const;
        void add_to(PositionCounts& levels) const;

    private:
        std::size_t levels_;
        std::vector<std::uint64_t> depths_, counts_;
    };
    struct LineUse {
        std::uint32_t id = 0;
        std::uint64_t line = 0;
        bool write = false;
        Reuse reuse = Reuse::EarlierFrame;
        bool known = false; // used before, and not thrown out since
    };

    std::uint64_t own_line(std::uint64_t line) const;
    void merge(std::span<const LineLookup> lines);
    void look_up(const LookupPlace& place, const LineLookup& lookup);
    void read(const LookupPlace& place, std::uint64_t line, std::uint32_t quads);
    void read_older(const LookupPlace& place, std::uint64_t line, std::uint32_t quads);
    void count_in_sets(std::span<const SetRead> reads);
    void end_reads();
    void count_frame_line(const LookupPlace& place, std::uint64_t last);
    std::uint64_t& last_use(std::uint32_t id);
    void use_again(const LineUse& use);
    void write_again(const LineUse& use);

    static void at_once(std::size_t, std::function<void()> job) { job(); }

    const CurvesShape shape_;
    const unsigned shift_;
    const Beside beside_;
    std::optional<ReadStacks> reads_; // as long as nothing was written
    std::vector<SetRead> set_reads_;  // that are not handed over yet
    // Of the jobs beside:
    SetReads read_sets_;
    PositionCounts read_positions_;
    // After that:
    LineNumbers numbers_;
    std::vector<std::uint64_t> last_use_; // by line: the number of its place
    LineStack all_;
    std::vector<SetStacks> stacks_;  // of 2, 4 ... sets
    std::uint32_t newest_ = Nothing; // the line looked up last

    ReuseHistograms positions_; // among all lines
    PositionCounts set_positions_;
    NearCounts near_; // beside these
    std::array<std::uint64_t, ReuseScopes + 1> reuses_{};
    std::uint64_t compulsory_ = 0;
    std::uint64_t lines_now_ = 0; // of this frame
    std::vector<std::uint64_t> frame_lines_;
    std::vector<LineLookup> merged_; // of one place
};

} // namespace ffgpu::work
