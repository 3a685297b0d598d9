#include "tools/cache/cache_study.h"

#include "model/base/input_error.h"
#include "model/work/first_level.h"
#include "model/work/job_pool.h"
#include "model/work/lookup_walk.h"
#include "model/work/texel_scan.h"
#include "tools/cache/lookup_chunks.h"
#include "tools/cache/miss_map.h"
#include "tools/cache/not_followed.h"
#include "tools/cache/scan_fan_out.h"
#include "tools/record/work_fan_out.h"
#include "tools/work/work_player.h"

#include <algorithm>
#include <deque>
#include <thread>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using work::LookupClient;

// What is done in which order: the work (WorkPlayOptions::pool), the look-ups in all lines, and in
// the sets.
enum Stage : unsigned { WorkStage, LookupStage, SetStage };

// The curves of one client and line size.
class ClientCurves final : public ChunkReader {
public:
    ClientCurves(LookupClient client, const work::CurvesShape& shape, work::JobPool& pool)
        : client_(client)
        , curves_(shape,
                  [this](std::size_t weight, std::function<void()> job) {
                      in_sets_.push(weight, std::move(job));
                  })
        , in_sets_(pool, SetStage, MostReads)
        , chunks_(pool, LookupStage, MostWeight) {}

    void lookups(LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t reads) override {
        if (client != client_) return;
        reads_ += reads;
        curves_.lookups(place, lines);
    }
    void lookups_again(const work::LookupPlace& place,
                       std::span<const work::LineLookup> lines,
                       std::uint32_t quads,
                       std::uint32_t reads) override {
        if (client_ != LookupClient::Texel) return;
        reads_ += reads;
        curves_.lookups_again(place, lines, quads);
    }
    void flush(LookupClient client) override {
        if (client == client_) curves_.flush();
    }
    void overwritten(LookupClient client, std::span<const work::OverwrittenLine> lines) override {
        if (client == client_) curves_.overwritten(lines);
    }
    void end_frame(std::uint32_t) override { curves_.end_frame(); }

    void push(const std::shared_ptr<const LookupChunk>& chunk) {
        chunks_.push(chunk->weight(), [this, chunk] { chunk->play(*this, places_); });
    }
    // Returns when all is counted.
    void drain() {
        chunks_.drain();
        curves_.hand_over_reads();
        in_sets_.drain();
    }

    LookupClient client() const { return client_; }
    CurveResult result(const CacheVariant& variant, bool second_level) {
        return {.client = client_,
                .variant = variant,
                .second_level = second_level,
                .line_bytes = curves_.shape().line_bytes,
                .reads = reads_,
                .sums = curves_.sums(),
                .frame_lines = curves_.frame_lines()};
    }

private:
    static constexpr std::size_t MostWeight = std::size_t{1} << 17;
    static constexpr std::size_t MostReads = std::size_t{1} << 15;

    LookupClient client_;
    work::MissCurves curves_;
    std::uint64_t reads_ = 0;
    LookupPlaces places_;
    work::JobPool::Order in_sets_, chunks_; // The last: their jobs use the others.
};

// Only the look-ups of clients that somebody follows.
class ClientFilter final : public work::LookupSink {
public:
    ClientFilter(std::vector<LookupClient> clients, work::LookupSink& out)
        : clients_(std::move(clients))
        , out_(out) {}

    void lookups(LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t reads) override {
        if (follows(client)) out_.lookups(client, place, lines, reads);
    }
    void flush(LookupClient client) override {
        if (follows(client)) out_.flush(client);
    }
    void overwritten(LookupClient client, std::span<const work::OverwrittenLine> lines) override {
        if (follows(client)) out_.overwritten(client, lines);
    }
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    bool follows(LookupClient client) const {
        return std::find(clients_.begin(), clients_.end(), client) != clients_.end();
    }

    std::vector<LookupClient> clients_;
    work::LookupSink& out_;
};

bool follows(const CacheStudyOptions& options, LookupClient client) {
    return std::find(options.clients.begin(), options.clients.end(), client) !=
           options.clients.end();
}

work::WorkConfig work_config(const CacheStudyOptions& options, const CacheVariant& variant) {
    work::WorkConfig config = options.configuration.timing.work();
    const std::uint32_t finest =
        *std::min_element(options.line_bytes.begin(), options.line_bytes.end());
    for (work::CacheShape* const shape : {static_cast<work::CacheShape*>(&config.texel_cache),
                                          &config.depth_cache,
                                          &config.color_cache}) {
        shape->line_bytes = finest;
        if (!options.layouts.empty()) shape->layout = variant.layout;
    }
    if (options.first_level) config.texel_cache.line_bytes = options.first_level->line_bytes;
    config.raster.traversal = variant.order.traversal;
    config.raster.tile_width = variant.order.tile_width;
    config.merges_texel_reads = variant.merges;
    config.target_lines =
        follows(options, LookupClient::Depth) || follows(options, LookupClient::Color);
    return config;
}

// The work need not be brought into a whole machine's order then.
bool reads_texels_alone(const CacheStudyOptions& options) {
    return options.clients == std::vector{LookupClient::Texel} && !options.miss_map &&
           work::TexelScan::reads(options.configuration.timing.work());
}

work::VertexFetchShape vertex_shape(const CacheStudyOptions& options) {
    const timing::VertexConfig& vertex = options.configuration.timing.vertex;
    return {.line_bytes = *std::min_element(options.line_bytes.begin(), options.line_bytes.end()),
            .reuse_entries = vertex.reuse_entries,
            .reuse_lru = vertex.reuse_policy == timing::ReusePolicy::Lru};
}

// One machine: its order and places, its look-ups, and their curves.
class Variant {
public:
    Variant(const CacheStudyOptions& options, const CacheVariant& variant, work::JobPool& pool)
        : options_(options)
        , variant_(variant)
        , config_(work_config(options, variant))
        , chunker_([this](std::shared_ptr<const LookupChunk> chunk) { hand_over(chunk); })
        , filter_(options.clients, chunker_) {
        if (reads_texels_alone(options)) {
            scan_.emplace(config_, first_sink(chunker_));
        } else {
            walk_.emplace(config_, vertex_shape(options), first_sink(filter_));
            order_.emplace(config_, *walk_);
        }
        for (const LookupClient client : options.clients)
            for (const std::uint32_t line_bytes : options.line_bytes)
                add(client, line_bytes, pool);
    }

    // One of them is there, as reads_texels_alone() says.
    work::TexelScan& scan() { return *scan_; }
    work::CommandSink& sink() { return *order_; }
    const work::WorkConfig& config() const { return config_; }
    void finish() {
        chunker_.finish();
        for (ClientCurves& curves : followers_)
            curves.drain();
    }

    void tell(CacheStudyResult& result) {
        for (ClientCurves& curves : followers_)
            result.curves.push_back(curves.result(variant_, behind_first(curves.client())));
    }

private:
    bool behind_first(LookupClient client) const {
        return client == LookupClient::Texel && options_.first_level;
    }
    work::LookupSink& first_sink(work::LookupSink& behind) {
        if (!options_.first_level) return behind;
        const CacheGeometry& shape = *options_.first_level;
        return first_level_.emplace(shape.sets, shape.ways, shape.line_bytes, behind);
    }
    void add(LookupClient client, std::uint32_t line_bytes, work::JobPool& pool) {
        const bool texel = client == LookupClient::Texel;
        const bool reads_only = texel || client == LookupClient::Vertex;
        const bool quads = variant_.granularity == work::Granularity::Quad && variant_.merges;
        const std::uint32_t own =
            texel ? config_.texel_cache.line_bytes : config_.depth_cache.line_bytes;
        followers_.emplace_back(client,
                                work::CurvesShape{.line_bytes = line_bytes,
                                                  .lookup_bytes = own,
                                                  .most_sets = options_.most_sets,
                                                  .most_ways = options_.most_ways,
                                                  .merges = !texel || quads,
                                                  .only_reads = reads_only},
                                pool);
    }
    void hand_over(const std::shared_ptr<const LookupChunk>& chunk) {
        for (ClientCurves& curves : followers_)
            curves.push(chunk);
    }

    const CacheStudyOptions& options_;
    const CacheVariant variant_;
    const work::WorkConfig config_;
    std::deque<ClientCurves> followers_;
    LookupChunker chunker_;
    ClientFilter filter_;
    std::optional<work::FirstLevel> first_level_;
    std::optional<work::TexelScan> scan_;
    std::optional<work::LookupWalk> walk_;
    std::optional<work::MachineOrder> order_;
};

void check_options(const CacheStudyOptions& options) {
    if (!options.first_level) return;
    for (const std::uint32_t line_bytes : options.line_bytes)
        if (line_bytes < options.first_level->line_bytes)
            throw InputError(fmt::format("--line {}: expected at least the first level's {} bytes",
                                         line_bytes,
                                         options.first_level->line_bytes));
}

std::vector<CacheVariant> variants_of(const CacheStudyOptions& options) {
    const timing::TimingConfig& timing = options.configuration.timing;
    const work::RasterOrder& raster = timing.raster;
    std::vector<work::Layout> layouts = options.layouts;
    if (layouts.empty()) layouts.push_back(timing.texel_cache.layout);
    std::vector<RasterChoice> orders = options.orders;
    if (orders.empty()) orders.push_back({raster.traversal, raster.tile_width});
    std::vector<CacheVariant> variants;
    for (const work::Layout layout : layouts)
        for (const RasterChoice& order : orders)
            variants.push_back({layout, order, raster.granularity, options.merges});
    return variants;
}

// Besides the one that draws; one that has no job is of no use.
unsigned threads_for(std::size_t curves) {
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    return static_cast<unsigned>(std::min<std::size_t>(processors - 1, 1 + 2 * curves));
}

// Whether look-ups behind the last frame may be among those counted.
bool play_and_count(const CacheStudyOptions& options,
                    WorkPlayOptions play,
                    CacheStudyResult& result) {
    const std::vector<CacheVariant> wanted = variants_of(options);
    const std::size_t curves = wanted.size() * options.clients.size() * options.line_bytes.size();
    work::JobPool pool(threads_for(curves));
    play.pool = &pool;
    std::deque<Variant> variants;
    CommandFanOut readers;
    ScanFanOut scans;
    const bool texels_alone = reads_texels_alone(options);
    for (const CacheVariant& variant : wanted) {
        Variant& added = variants.emplace_back(options, variant, pool);
        texels_alone ? scans.add(added.scan()) : readers.add(added.sink());
    }
    std::optional<MissMap> map;
    if (options.miss_map)
        readers.add(map.emplace(variants.front().config(), *options.miss_map).sink());
    const auto on_frame = [&](const work::FrameFigures& frame) {
        result.frames.push_back(frame.number);
        if (map) options.on_miss_map(frame.number, map->picture(frame.width, frame.height));
    };
    const auto finish = [&] {
        for (Variant& variant : variants)
            variant.finish();
        for (Variant& variant : variants)
            variant.tell(result);
    };
    bool has_more = false;
    try {
        has_more =
            texels_alone ? play_work(play, scans, on_frame) : play_work(play, readers, on_frame);
    } catch (const InputError&) {
        finish();
        throw;
    }
    finish();
    return has_more;
}

} // namespace

void study_caches(const CacheStudyOptions& options, CacheStudyResult& result) {
    check_options(options);
    for (const std::string& line :
         not_followed_by_curves(options.configuration.timing, options.clients))
        options.warn(line);
    std::size_t warned = 0; // in the first run
    WorkPlayOptions play{.input = options.input,
                         .frames = options.frames,
                         .gpu = options.configuration.gpu,
                         .machine = options.configuration.timing,
                         .warn =
                             [&](const std::string& line) {
                                 ++warned;
                                 options.warn(line);
                             },
                         .colors = !options.configuration.timing.needs_values().empty()};
    const auto count = [&] {
        try {
            return play_and_count(options, play, result);
        } catch (const MissedColors& missed) {
            result = {};
            play.at_least = missed.next;
        }
        play.colors = true;
        play.warn = [&](const std::string& line) {
            if (warned == 0) return options.warn(line);
            --warned;
        };
        return play_and_count(options, play, result);
    };
    // Some look-ups of the frame that did not end were counted, too.
    const auto count_whole_frames = [&] {
        play.ends_behind = result.frames.back();
        play.warn = [](const std::string&) {};
        result = {};
        count();
    };
    try {
        if (!count()) return;
    } catch (const InputError&) {
        if (result.frames.empty()) throw;
        count_whole_frames();
        throw;
    }
    if (result.frames.empty()) throw InputError(options.input + ": has no whole frame");
    count_whole_frames();
}

std::vector<CacheGeometry> told_geometries(const CacheStudyOptions& options,
                                           const CurveResult& curve) {
    std::vector<CacheGeometry> all;
    for (std::uint32_t sets = 1; sets <= options.most_sets; sets *= 2)
        for (std::uint32_t ways = 1; ways <= options.most_ways; ++ways)
            all.push_back({sets, ways, curve.line_bytes});
    constexpr std::uint32_t MostLines = 1u << 20;
    for (std::uint32_t ways = 1; ways <= MostLines; ways *= 2) {
        if (ways > options.most_ways) all.push_back({1, ways, curve.line_bytes});
        const work::CacheCounts counts = curve.sums.counts(1, ways);
        if (counts.misses == counts.compulsory) break;
    }
    return all;
}

} // namespace ffgpu::tools
