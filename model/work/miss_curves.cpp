#include "model/work/miss_curves.h"

#include "model/base/check.h"
#include "model/work/texel_line.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace ffgpu::work {
namespace {

constexpr std::size_t MostReads = 4096; // told of sets at a time

void count(std::vector<std::uint64_t>& histogram, std::uint32_t at, std::uint64_t times = 1) {
    if (at >= histogram.size()) histogram.resize(std::size_t{at} * 2 + 64, 0);
    histogram[at] += times;
}

// Of each entry the sum from there on.
void sum_up(std::vector<std::uint64_t>& histogram) {
    std::partial_sum(histogram.rbegin(), histogram.rend(), histogram.rbegin());
}

std::uint64_t value(const std::vector<std::uint64_t>& sums, std::uint64_t at) {
    return at < sums.size() ? sums[at] : 0;
}

} // namespace

MissCurves::MissCurves(const CurvesShape& shape, Beside beside)
    : shape_(shape)
    , shift_(static_cast<unsigned>(std::countr_zero(shape.line_bytes / shape.lookup_bytes)))
    , beside_(std::move(beside))
    , read_sets_(shape.most_sets, shape.most_ways)
    , read_positions_(read_sets_.levels(), shape.most_ways)
    , set_positions_(read_sets_.levels(), shape.most_ways)
    , near_(read_sets_.levels()) {
    check(shape.line_bytes >= shape.lookup_bytes, "look-ups of lines, or of parts of them");
    reads_.emplace(read_sets_.levels());
}

// The bits above a line's number that tell of its expansion stay.
std::uint64_t MissCurves::own_line(std::uint64_t line) const {
    constexpr std::uint64_t Low = (std::uint64_t{1} << ExpansionAt) - 1;
    return (line & ~Low) | (line & Low) >> shift_;
}

// Into merged_: what a machine with lines of this size looks up.
void MissCurves::merge(std::span<const LineLookup> lines) {
    merged_.clear();
    for (const LineLookup& lookup : lines) {
        const std::uint64_t line = own_line(lookup.line);
        auto from = merged_.begin();
        if (!shape_.merges && !merged_.empty()) from = merged_.end() - 1;
        const auto found = std::find_if(
            from, merged_.end(), [&](const LineLookup& other) { return other.line == line; });
        if (found == merged_.end())
            merged_.push_back({line, lookup.write});
        else
            found->write |= lookup.write;
    }
}

void MissCurves::lookups(const LookupPlace& place, std::span<const LineLookup> lines) {
    if (shift_ > 0) {
        merge(lines);
        lines = merged_;
    }
    for (const LineLookup& lookup : lines)
        look_up(place, lookup);
}

void MissCurves::lookups_again(const LookupPlace& place,
                               std::span<const LineLookup> lines,
                               std::uint32_t quads) {
    check(reads_.has_value(), "look-ups that only read");
    if (shift_ > 0) {
        merge(lines);
        lines = merged_;
    }
    for (const LineLookup& lookup : lines)
        read(place, lookup.line, quads);
}

// --- As long as lines are only read --------------------------------------------------------------

void MissCurves::read(const LookupPlace& place, std::uint64_t line, std::uint32_t quads) {
    const ReadStacks::Near near = reads_->look_up_near(line, place.number);
    if (!near) return read_older(place, line, quads);
    const Reuse reuse = place.since(near.last);
    lines_now_ += reuse == Reuse::EarlierFrame;
    near_.add(static_cast<std::size_t>(reuse), near.depth, near.positions, quads);
}

void MissCurves::read_older(const LookupPlace& place, std::uint64_t line, std::uint32_t quads) {
    if (set_reads_.size() >= MostReads) hand_over_reads();
    SetRead& read = set_reads_.emplace_back();
    const ReadStacks::Found found = reads_->look_up_older(line, place.number, read);
    count_frame_line(place, found.last);
    if (!found.known) {
        ++compulsory_;
        return;
    }
    read.reuse = place.since(found.last);
    read.quads = quads;
    const auto reuse = static_cast<std::size_t>(read.reuse);
    reuses_[reuse] += quads;
    count(positions_[reuse], found.depth, quads);
}

void MissCurves::hand_over_reads() {
    if (set_reads_.empty()) return;
    std::vector<SetRead> reads = std::exchange(set_reads_, {});
    set_reads_.reserve(MostReads);
    const std::size_t weight = reads.size();
    beside_(weight, [this, reads = std::move(reads)] { count_in_sets(reads); });
}

// Beside the others.
void MissCurves::count_in_sets(std::span<const SetRead> reads) {
    constexpr std::size_t Ahead = 4;
    for (std::size_t i = 0; i < reads.size(); ++i) {
        if (i + Ahead < reads.size()) read_sets_.prefetch(reads[i + Ahead]);
        const SetRead& read = reads[i];
        read_positions_.add(read_sets_.use(read), read.reuse, read.depth, read.quads);
    }
}

std::uint64_t MissCurves::NearCounts::of_reuse(std::size_t reuse) const {
    const auto first = depths_.begin() + static_cast<std::ptrdiff_t>(reuse * Depths);
    return std::accumulate(first, first + Depths, std::uint64_t{0});
}

void MissCurves::NearCounts::add_to(ReuseHistograms& positions) const {
    for (std::size_t at = 0; at < depths_.size(); ++at)
        if (depths_[at] > 0)
            count(positions[at / Depths], static_cast<std::uint32_t>(at % Depths), depths_[at]);
}

void MissCurves::NearCounts::add_to(PositionCounts& levels) const {
    std::size_t at = 0;
    for (std::size_t reuse = 0; reuse <= ReuseScopes; ++reuse)
        for (std::uint32_t depth = 0; depth < Depths; ++depth)
            for (std::size_t level = 0; level < levels_; ++level)
                for (std::uint32_t position = 0; position < Depths; ++position, ++at)
                    if (counts_[at] > 0)
                        levels.add(level, static_cast<Reuse>(reuse), position, depth, counts_[at]);
}

void MissCurves::count_frame_line(const LookupPlace& place, std::uint64_t last) {
    if (last == Never || last < place.began[static_cast<std::size_t>(Reuse::Frame)]) ++lines_now_;
}

// What was read goes to the stacks that know of dirty lines and of holes.
void MissCurves::end_reads() {
    if (!reads_) return;
    for (std::uint32_t sets = 2; sets <= shape_.most_sets; sets *= 2)
        stacks_.emplace_back(sets, shape_.most_ways);
    for (const std::uint64_t line : reads_->oldest_first(set_reads_)) {
        newest_ = numbers_[line];
        all_.use(newest_, false);
        for (SetStacks& stacks : stacks_)
            if (stacks.use({newest_, line, false}, true) == 0) break;
    }
    reads_->for_each_line(
        [this](std::uint64_t line, std::uint64_t last) { last_use(numbers_[line]) = last; });
    reads_.reset();
    hand_over_reads();
}

// --- With lines that are written or thrown out ---------------------------------------------------

std::uint64_t& MissCurves::last_use(std::uint32_t id) {
    if (id >= last_use_.size()) last_use_.resize(std::size_t{id} * 2 + 64, Never);
    return last_use_[id];
}

void MissCurves::look_up(const LookupPlace& place, const LineLookup& lookup) {
    if (reads_ && !lookup.write) return read(place, lookup.line, 1);
    check(!shape_.only_reads, "look-ups that only read");
    end_reads();
    LineUse use{.id = numbers_[lookup.line], .line = lookup.line, .write = lookup.write};
    std::uint64_t& last = last_use(use.id);
    count_frame_line(place, last);
    use.known = all_.has(use.id);
    if (use.known) {
        use.reuse = place.since(last);
        ++reuses_[static_cast<std::size_t>(use.reuse)];
    } else {
        ++compulsory_;
    }
    last = place.number;
    if (use.id != newest_)
        use_again(use);
    else if (use.write && !all_.is_dirty_everywhere(use.id))
        write_again(use);
    newest_ = use.id;
}

// From the fewest sets on, until it is its set's last used one: from there on nothing moves.
void MissCurves::use_again(const LineUse& use) {
    const bool changes = use.write && !(use.known && all_.is_dirty_everywhere(use.id));
    const std::uint32_t depth = all_.use(use.id, use.write);
    const auto reuse = static_cast<std::size_t>(use.reuse);
    if (use.known) count(positions_[reuse], depth);
    for (std::size_t i = 0; i < stacks_.size(); ++i) {
        const std::uint32_t position = stacks_[i].use({use.id, use.line, use.write}, use.known);
        if (!use.known) continue;
        if (position == 0 && !changes) return;
        if (position == 0) continue;
        set_positions_.add(i, use.reuse, position, depth, 1);
    }
}

// It is on top everywhere and becomes dirty in caches of any number of ways.
void MissCurves::write_again(const LineUse& use) {
    all_.use(use.id, true);
    for (SetStacks& stacks : stacks_)
        stacks.use({use.id, use.line, true}, true);
}

void MissCurves::flush() {
    if (reads_) return reads_->flush(set_reads_);
    all_.flush();
    for (SetStacks& stacks : stacks_)
        stacks.flush();
    newest_ = Nothing;
}

void MissCurves::overwritten(std::span<const OverwrittenLine> lines) {
    const std::size_t parts = std::size_t{1} << shift_;
    for (std::size_t i = 0; i < lines.size();) {
        const std::uint64_t line = own_line(lines[i].line);
        std::size_t whole = 0;
        for (; i < lines.size() && own_line(lines[i].line) == line; ++i)
            whole += lines[i].whole;
        if (shape_.only_reads) {
            reads_->drop(line, set_reads_);
            continue;
        }
        if (reads_ && !reads_->has(line)) continue;
        end_reads(); // Its stacks take no holes over.
        const std::uint32_t id = numbers_[line];
        if (!all_.has(id)) continue;
        if (id == newest_) newest_ = Nothing;
        all_.drop(id, whole == parts);
        for (SetStacks& stacks : stacks_)
            stacks.drop({id, line, false}, whole == parts);
    }
}

void MissCurves::end_frame() {
    frame_lines_.push_back(lines_now_);
    lines_now_ = 0;
}

CurveSums MissCurves::sums() {
    hand_over_reads();
    CurveSums sums;
    sums.most_ways_ = shape_.most_ways;
    sums.compulsory_ = compulsory_;
    sums.accesses_ = std::accumulate(reuses_.begin(), reuses_.end(), compulsory_);
    for (std::size_t reuse = 0; reuse <= ReuseScopes; ++reuse)
        sums.accesses_ += near_.of_reuse(reuse);
    sums.stacks_.push_back({positions_, {}, all_.write_backs()});
    near_.add_to(sums.stacks_.back().positions);
    PositionCounts levels = set_positions_;
    levels += read_positions_;
    near_.add_to(levels);
    for (std::size_t i = 0; i < levels.levels(); ++i)
        sums.stacks_.push_back({levels.positions(i),
                                levels.in_both(i),
                                reads_ ? WriteBacks() : stacks_[i].write_backs()});
    for (CurveSums::Stacks& stacks : sums.stacks_) {
        for (CurveSums::Sums& positions : stacks.positions)
            sum_up(positions);
        sum_up(stacks.in_both);
    }
    return sums;
}

CacheCounts CurveSums::counts(std::uint32_t sets, std::uint32_t ways) const {
    const auto level = static_cast<std::size_t>(std::countr_zero(sets));
    check(std::has_single_bit(sets) && level < stacks_.size(), "a followed number of sets");
    check(ways > 0 && (sets == 1 || ways <= most_ways_), "a followed number of ways");
    const Stacks& stacks = stacks_[level];
    CacheCounts counts{.accesses = accesses_, .compulsory = compulsory_};
    std::uint64_t shadow_misses = 0; // of lines known before
    for (std::size_t i = 0; i < counts.by_reuse.size(); ++i) {
        counts.by_reuse[i] = value(stacks.positions[i], ways);
        counts.misses += counts.by_reuse[i];
        shadow_misses += value(stacks_[0].positions[i], std::uint64_t{sets} * ways);
    }
    counts.capacity = sets > 1 ? value(stacks.in_both, ways) : counts.misses;
    counts.conflict = counts.misses - counts.capacity;
    counts.hits_beyond_lru = shadow_misses - counts.capacity;
    counts.misses += compulsory_;
    counts.write_backs = stacks.write_backs.in(ways);
    return counts;
}

} // namespace ffgpu::work
