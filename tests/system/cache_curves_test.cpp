// The curves of whole traces, against caches simulated one by one, and against the machine in time.

#include "model/work/lookup_walk.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tests/tools/tool.h"
#include "tests/work/plain_cache.h"
#include "tools/cache/cache_study.h"
#include "tools/work/work_player.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using work::LookupClient;

constexpr FrameRange Frames{0, 3};
const std::vector<LookupClient> AllClients{
    LookupClient::Texel, LookupClient::Depth, LookupClient::Color, LookupClient::Vertex};

// One cache of one client, look-up after look-up.
class DirectSimulation final : public work::LookupSink {
public:
    DirectSimulation(LookupClient client, const CacheGeometry& shape)
        : client_(client)
        , cache(shape.sets, shape.ways) {}

    void lookups(LookupClient client,
                 const work::LookupPlace&,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t) override {
        if (client != client_) return;
        for (const work::LineLookup& lookup : lines)
            cache.access(lookup.line, lookup.write);
    }
    void flush(LookupClient client) override {
        if (client == client_) cache.flush();
    }
    void overwritten(LookupClient client, std::span<const work::OverwrittenLine> lines) override {
        for (const work::OverwrittenLine& line : lines)
            if (client == client_) cache.overwrite(line.line, line.whole);
    }
    void end_frame(std::uint32_t) override {}

private:
    LookupClient client_;

public:
    test::PlainCache cache;
};

// The machine that looks up lines of this size in images of this layout.
work::WorkConfig machine_of(const CurveResult& curve) {
    work::WorkConfig config;
    for (work::CacheShape* const shape : {static_cast<work::CacheShape*>(&config.texel_cache),
                                          &config.depth_cache,
                                          &config.color_cache}) {
        shape->line_bytes = curve.line_bytes;
        shape->layout = curve.variant.layout;
    }
    return config;
}

test::PlainCounts
simulate(const std::string& trace, const CurveResult& curve, const CacheGeometry& shape) {
    DirectSimulation simulation(curve.client, shape);
    work::LookupWalk walk(machine_of(curve), {.line_bytes = curve.line_bytes}, simulation);
    work::MachineOrder order(machine_of(curve), walk);
    play_work({.input = trace, .frames = Frames}, order, [](const work::FrameFigures&) {});
    return simulation.cache.counts;
}

void check_equal(const work::CacheCounts& curve, const test::PlainCounts& direct) {
    CHECK(curve.accesses == direct.accesses);
    CHECK(curve.misses == direct.misses);
    CHECK(curve.compulsory == direct.compulsory);
    CHECK(curve.capacity == direct.capacity);
    CHECK(curve.conflict == direct.conflict);
    CHECK(curve.hits_beyond_lru == direct.hits_beyond_lru);
    CHECK(curve.write_backs == direct.write_backs);
}

TEST_CASE("50 caches out of a pass over a trace equal their direct simulation", "[cache]") {
    for (const std::string& name : own_traces()) {
        const std::string trace = own_trace(name);
        const CacheStudyOptions options{
            .input = trace,
            .frames = Frames,
            .clients = AllClients,
            .line_bytes = {32, 64, 128, 256},
            .layouts = {work::Layout::Linear, work::Layout::Blocked, work::Layout::Blocked6d}};
        CacheStudyResult result;
        study_caches(options, result);
        std::vector<std::pair<const CurveResult*, CacheGeometry>> all;
        for (const CurveResult& curve : result.curves)
            for (const CacheGeometry& shape : told_geometries(options, curve))
                all.emplace_back(&curve, shape);
        REQUIRE(all.size() >= 1000);
        std::mt19937 random(50);
        for (unsigned i = 0; i < 50; ++i) {
            const auto& [curve, shape] = all[random() % all.size()];
            INFO(name << ": client " << static_cast<int>(curve->client) << ", layout "
                      << static_cast<int>(curve->variant.layout) << ", " << shape.sets << "x"
                      << shape.ways << "x" << shape.line_bytes);
            check_equal(curve->sums.counts(shape.sets, shape.ways), simulate(trace, *curve, shape));
        }
    }
}

const CurveResult&
curve_of(const CacheStudyResult& result, LookupClient client, std::uint32_t line_bytes) {
    for (const CurveResult& curve : result.curves)
        if (curve.client == client && curve.line_bytes == line_bytes) return curve;
    FAIL("no such curve");
    return result.curves.front();
}

struct Timed {
    std::string cache; // as stats.json names it
    LookupClient client = LookupClient::Texel;
    CacheGeometry shape{};
};

void check_timed(const Counters& timed, const CacheStudyResult& result, const Timed& what) {
    INFO(what.cache);
    const work::CacheCounts counts = curve_of(result, what.client, what.shape.line_bytes)
                                         .sums.counts(what.shape.sets, what.shape.ways);
    const auto at = [&](const char* figure) { return timed.at(what.cache + '_' + figure); };
    CHECK(counts.accesses > 0);
    CHECK(counts.accesses == at("accesses"));
    CHECK(counts.misses == at("misses"));
    CHECK(counts.compulsory == at("compulsory_misses"));
    CHECK(counts.capacity == at("capacity_misses"));
    CHECK(counts.conflict == at("conflict_misses"));
    CHECK(counts.hits_beyond_lru == at("hits_beyond_lru"));
    // Whole lines are written back.
    CHECK(counts.write_backs * what.shape.line_bytes == at("written_bytes"));
}

timing::TimingConfig whole_line_writes() {
    timing::TimingConfig config;
    config.depth_cache.transfer_bytes = config.color_cache.transfer_bytes = 64;
    return config;
}

CacheStudyResult
study(const std::string& trace, const timing::TimingConfig& timing, CacheStudyOptions options) {
    options.input = trace;
    options.configuration.timing = timing;
    options.line_bytes = {64, 128};
    CacheStudyResult result;
    study_caches(options, result);
    return result;
}

TEST_CASE("the curves hold what the machine in time counts", "[cache]") {
    for (const std::string& name : own_traces()) {
        INFO(name);
        const timing::TimingConfig config = whole_line_writes();
        const Run run = run_trace(own_trace(name), {.timing = config});
        const CacheStudyResult result = study(own_trace(name), config, {.clients = AllClients});
        check_timed(run.timed, result, {"texel_cache", LookupClient::Texel, {64, 4, 64}});
        // Quads of draws that test early overtake those of light_maps' draws that test late.
        if (name != "light_maps")
            check_timed(run.timed, result, {"depth_cache", LookupClient::Depth, {64, 4, 64}});
        check_timed(run.timed, result, {"color_cache", LookupClient::Color, {64, 4, 64}});
        check_timed(run.timed, result, {"vertex_cache", LookupClient::Vertex, {16, 4, 64}});
    }
}

// The work of the trace, with `option` for replay; nothing: none.
std::string saved_work(const std::string& trace, const std::string& path, const char* option) {
    std::vector<std::string> arguments{
        "replay", trace, "--no-images", "--save-work", path, "-o", path + ".out"};
    if (option) arguments.emplace_back(option);
    printed(stderr, [&] { REQUIRE(run(arguments) == 0); });
    return path;
}

TEST_CASE("curves of a machine that tests depth late are of all fragments", "[cache]") {
    timing::TimingConfig config = whole_line_writes();
    config.depth.test = work::DepthTest::Late;
    const TemporaryFolder folder;
    const std::string trace = own_trace("tour");
    const Run run = run_trace(trace, {.timing = config});
    REQUIRE(run.timed.at("texel_cache_accesses") >
            run_trace(trace, {.timing = whole_line_writes()}).timed.at("texel_cache_accesses"));
    for (const std::string& input :
         {trace, saved_work(trace, folder / "values.ffw", "--work-values")}) {
        INFO(input);
        const CacheStudyResult all = study(input, config, {.clients = AllClients});
        check_timed(run.timed, all, {"texel_cache", LookupClient::Texel, {64, 4, 64}});
        check_timed(run.timed, all, {"depth_cache", LookupClient::Depth, {64, 4, 64}});
        check_timed(run.timed, all, {"color_cache", LookupClient::Color, {64, 4, 64}});
        check_timed(run.timed, all, {"vertex_cache", LookupClient::Vertex, {16, 4, 64}});
        const CacheStudyResult texels = study(input, config, {}); // as they were drawn
        check_timed(run.timed, texels, {"texel_cache", LookupClient::Texel, {64, 4, 64}});
    }
}

TEST_CASE("values that the machine does not need move no look-up", "[cache]") {
    const TemporaryFolder folder;
    const std::string trace = own_trace("tour");
    const timing::TimingConfig config = whole_line_writes();
    const Run run = run_trace(trace, {.timing = config});
    const std::string work = saved_work(trace, folder / "values.ffw", "--work-values");
    const CacheStudyResult result = study(work, config, {.clients = AllClients});
    check_timed(run.timed, result, {"texel_cache", LookupClient::Texel, {64, 4, 64}});
    check_timed(run.timed, result, {"depth_cache", LookupClient::Depth, {64, 4, 64}});
    check_timed(run.timed, result, {"color_cache", LookupClient::Color, {64, 4, 64}});
}

TEST_CASE("look-ups of work without the values that they depend on are refused", "[cache]") {
    const TemporaryFolder folder;
    const std::string work = saved_work(own_trace("tour"), folder / "masks.ffw", nullptr);
    const auto refusal = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--set", "depth.test=late"});
        int status = 0;
        std::string line = printed(stderr, [&] { status = run(arguments); });
        CHECK(status == 2);
        CHECK(std::count(line.begin(), line.end(), '\n') == 1);
        return line;
    };
    const std::string by_time = refusal({"time", work, "-o", folder / "timed"});
    CHECK_THAT(by_time, Catch::Matchers::Contains("--work-values"));
    CHECK(refusal({"cache", work}) == by_time);
    CHECK(refusal({"cache", work, "--client", "texel,depth"}) == by_time);
    for (const char* const format : {"din", "xdin"}) {
        const std::string file = folder / "lookups";
        CHECK(refusal({"export", work, "--format", format, "-o", file}) == by_time);
        CHECK_FALSE(std::filesystem::exists(file));
    }
}

TEST_CASE("curves behind a first level are those of the second of the machine", "[cache]") {
    timing::TimingConfig config = whole_line_writes();
    config.texel_cache.sets = 8;
    config.texel_cache.ways = 2;
    config.texel_l2 = {};
    config.texel_l2.enable = true;
    config.texel_l2.sets = 32;
    config.texel_l2.ways = 3;
    config.texel_l2.line_bytes = 128;
    const std::string trace = own_trace("chrome");
    const Run run = run_trace(trace, {.timing = config});
    const CacheStudyResult result = study(trace, config, {.first_level = CacheGeometry{8, 2, 64}});
    check_timed(run.timed, result, {"texel_l2", LookupClient::Texel, {32, 3, 128}});
}

TEST_CASE("curves by fragment are those of the machine that works in fragments", "[cache]") {
    timing::TimingConfig config = whole_line_writes();
    config.raster.granularity = work::Granularity::Fragment;
    config.raster.traversal = work::Traversal::Scanline;
    config.texel_cache.layout = work::Layout::Blocked6d;
    const std::string trace = own_trace("light_maps");
    const Run run = run_trace(trace, {.timing = config, .last_frame = 1});
    const CacheStudyResult result = study(trace, config, {.frames = {0, 1}});
    check_timed(run.timed, result, {"texel_cache", LookupClient::Texel, {64, 4, 64}});
    CHECK(curve_of(result, LookupClient::Texel, 64).reads == run.timed.at("texture_texel_reads"));
}

TEST_CASE("unmerged, quads read each texel; their misses keep within the reads", "[cache]") {
    const std::string trace = own_trace("corridor");
    const CacheStudyResult merged = study(trace, {}, {.frames = {0, 0}});
    const CacheStudyResult each = study(trace, {}, {.frames = {0, 0}, .merges = false});
    const CurveResult& a = curve_of(merged, LookupClient::Texel, 64);
    const CurveResult& b = curve_of(each, LookupClient::Texel, 64);
    CHECK(a.reads == b.reads);
    CHECK(a.sums.counts(1, 1).accesses < b.sums.counts(1, 1).accesses);
    CHECK(b.sums.counts(1, 1).accesses <= b.reads);
    CHECK(a.sums.counts(64, 4).compulsory == b.sums.counts(64, 4).compulsory);
    CHECK(b.sums.counts(1, 1).by_reuse[0] > 0); // A quad's own lines.
    CHECK(a.sums.counts(1, 1).by_reuse[0] == 0);
    CHECK(a.frame_lines == b.frame_lines);
}

} // namespace
} // namespace ffgpu::tools
