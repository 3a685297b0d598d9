#include "tools/cache/cache_report.h"

#include "tools/cache/size_name.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::uint64_t KiB = 1024;

std::string_view name_of(work::LookupClient client) {
    return work::LookupClientNames[static_cast<std::size_t>(client)];
}

std::string order_name(const RasterChoice& order) {
    const std::string_view name = work::TraversalNames[static_cast<std::size_t>(order.traversal)];
    const bool tiles =
        order.traversal != work::Traversal::Scanline && order.traversal != work::Traversal::Column;
    return tiles ? fmt::format("{} {}", name, order.tile_width) : std::string(name);
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

// The columns of the table of misses: so many ways, or all.
constexpr std::array<std::uint32_t, 4> TableWays{1, 2, 4, 8};

std::string cell(const CacheStudyOptions& options,
                 const CurveResult& curve,
                 std::uint64_t lines,
                 std::uint32_t ways) {
    const std::uint64_t sets = lines / ways;
    if (sets == 0 || sets > options.most_sets || (sets > 1 && ways > options.most_ways))
        return fmt::format("{:>9}", "-");
    const work::CacheCounts counts = curve.sums.counts(static_cast<std::uint32_t>(sets), ways);
    return fmt::format("{:9.3f}", percent(counts.misses, counts.accesses));
}

// Misses by size and ways, up to where all of a size's are compulsory.
std::string miss_table(const CacheStudyOptions& options, const CurveResult& curve) {
    std::string text = fmt::format("  {:>8}", "size");
    for (const std::uint32_t ways : TableWays)
        text += fmt::format("{:>9}", fmt::format("{} way{}", ways, ways > 1 ? "s" : ""));
    text += fmt::format("{:>9}\n", "full");
    constexpr std::uint64_t Most = 4 * KiB * KiB;
    for (std::uint64_t bytes = KiB; bytes <= Most; bytes *= 2) {
        const std::uint64_t lines = bytes / curve.line_bytes;
        text += fmt::format("  {:>8}", size_name(bytes));
        for (const std::uint32_t ways : TableWays)
            text += cell(options, curve, lines, ways);
        text += cell(options, curve, lines, static_cast<std::uint32_t>(lines)) + '\n';
        const work::CacheCounts full = curve.sums.counts(1, static_cast<std::uint32_t>(lines));
        if (full.misses == full.compulsory) break;
    }
    return text;
}

std::string working_set(const CurveResult& curve) {
    const std::vector<std::uint64_t>& frames = curve.frame_lines;
    if (frames.empty()) return {};
    const std::uint64_t sum = std::accumulate(frames.begin(), frames.end(), std::uint64_t{0});
    const std::uint64_t most = *std::max_element(frames.begin(), frames.end());
    return fmt::format("  working set: {:.1f} KB a frame on average, {:.1f} KB at most\n",
                       static_cast<double>(sum * curve.line_bytes) /
                           static_cast<double>(frames.size() * KiB),
                       static_cast<double>(most * curve.line_bytes) / double{KiB});
}

std::string kinds(const CurveResult& curve, const CacheGeometry& shape) {
    const work::CacheCounts counts = curve.sums.counts(shape.sets, shape.ways);
    const auto share = [&](std::uint64_t part) { return percent(part, counts.misses); };
    std::string text = fmt::format(
        "  {} in {} sets x {} ways: {} misses: {:.1f} % compulsory, {:.1f} % capacity, {:.1f} % "
        "conflict\n  the line was last used in the same",
        size_name(shape.bytes()),
        shape.sets,
        shape.ways,
        counts.misses,
        share(counts.compulsory),
        share(counts.capacity),
        share(counts.conflict));
    for (std::size_t i = 0; i < work::ReuseScopes; ++i)
        text += fmt::format(" {} {:.1f} %,", work::ReuseNames[i], share(counts.by_reuse[i]));
    text += fmt::format(" an earlier frame {:.1f} %\n", share(counts.by_reuse.back()));
    if (counts.write_backs > 0) text += fmt::format("  {} write-backs\n", counts.write_backs);
    return text;
}

// The cache that the configuration names, if it was followed.
std::string configured_kinds(const CacheStudyOptions& options, const CurveResult& curve) {
    const timing::TimingConfig& timing = options.configuration.timing;
    CacheGeometry shape{
        timing.vertex.cache_sets, timing.vertex.cache_ways, timing.vertex.line_bytes};
    const auto take = [&](const work::CacheShape& cache) {
        shape = {cache.sets, cache.ways, cache.line_bytes};
    };
    if (curve.client == work::LookupClient::Depth) take(timing.depth_cache);
    if (curve.client == work::LookupClient::Color) take(timing.color_cache);
    if (curve.client == work::LookupClient::Texel) take(timing.texel_cache);
    if (curve.second_level)
        shape = {timing.texel_l2.sets, timing.texel_l2.ways, timing.texel_l2.line_bytes};
    if (shape.line_bytes != curve.line_bytes || shape.sets > options.most_sets ||
        (shape.sets > 1 && shape.ways > options.most_ways))
        return {};
    return kinds(curve, shape);
}

std::string variant_columns(const CurveResult& curve) {
    const CacheVariant& variant = curve.variant;
    return fmt::format("{},{},{},{},{},{},{},{}",
                       name_of(curve.client),
                       curve.second_level ? 2 : 1,
                       work::LayoutNames[static_cast<std::size_t>(variant.layout)],
                       work::TraversalNames[static_cast<std::size_t>(variant.order.traversal)],
                       variant.order.tile_width,
                       work::GranularityNames[static_cast<std::size_t>(variant.granularity)],
                       variant.merges ? 1 : 0,
                       curve.line_bytes);
}

constexpr std::string_view VariantColumns =
    "client,level,layout,traversal,tile_width,granularity,merged,line_bytes";

} // namespace

std::string variant_name(const CurveResult& curve) {
    const CacheVariant& variant = curve.variant;
    std::string text(name_of(curve.client));
    if (curve.second_level) text += " behind the first level";
    if (curve.client == work::LookupClient::Vertex) return text;
    text += fmt::format(", {}, {}",
                        work::LayoutNames[static_cast<std::size_t>(variant.layout)],
                        order_name(variant.order));
    if (variant.granularity == work::Granularity::Fragment) text += ", by fragment";
    if (!variant.merges) text += ", unmerged";
    return text;
}

std::string cache_tables(const CacheStudyOptions& options, const CacheStudyResult& result) {
    std::string text = fmt::format("{} frames\n", result.frames.size());
    for (const CurveResult& curve : result.curves) {
        const std::uint64_t accesses = curve.sums.counts(1, 1).accesses;
        text += fmt::format("\n{}, lines of {} bytes: misses in % of {} look-ups, for {} reads\n",
                            variant_name(curve),
                            curve.line_bytes,
                            accesses,
                            curve.reads);
        if (accesses == 0) continue;
        text += miss_table(options, curve) + configured_kinds(options, curve) + working_set(curve);
    }
    return text;
}

std::string curves_csv(const CacheStudyOptions& options, const CacheStudyResult& result) {
    std::string text = fmt::format("{},sets,ways,bytes,reads,accesses,misses,compulsory,capacity,"
                                   "conflict,hits_beyond_lru,write_backs",
                                   VariantColumns);
    for (const std::string_view reuse : work::ReuseNames)
        text += fmt::format(",reuse_{}", reuse);
    text += '\n';
    for (const CurveResult& curve : result.curves) {
        const std::string variant = variant_columns(curve);
        for (const CacheGeometry& shape : told_geometries(options, curve)) {
            const work::CacheCounts counts = curve.sums.counts(shape.sets, shape.ways);
            fmt::format_to(std::back_inserter(text),
                           "{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                           variant,
                           shape.sets,
                           shape.ways,
                           shape.bytes(),
                           curve.reads,
                           counts.accesses,
                           counts.misses,
                           counts.compulsory,
                           counts.capacity,
                           counts.conflict,
                           counts.hits_beyond_lru,
                           counts.write_backs,
                           fmt::join(counts.by_reuse, ","));
        }
    }
    return text;
}

std::string working_sets_csv(const CacheStudyResult& result) {
    std::string text = fmt::format("{},frame,lines,bytes\n", VariantColumns);
    for (const CurveResult& curve : result.curves)
        for (std::size_t i = 0; i < curve.frame_lines.size() && i < result.frames.size(); ++i)
            fmt::format_to(std::back_inserter(text),
                           "{},{},{},{}\n",
                           variant_columns(curve),
                           result.frames[i],
                           curve.frame_lines[i],
                           curve.frame_lines[i] * curve.line_bytes);
    return text;
}

} // namespace ffgpu::tools
