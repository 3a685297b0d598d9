// The accounts of stats.json on real traces, read as its users read it: every unit's cycles add up,
// every cache's accesses and misses do, and the bytes on the bus are those of the misses.

#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tools/config/config_file.h"
#include "tools/image/image.h"
#include "tools/replay/replay.h"

#include <fstream>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

// What replay leaves behind.
struct Replayed {
    Json statistics;
    std::vector<Picture> pictures;
};

Replayed replayed(const std::string& trace,
                  FrameRange frames,
                  const std::vector<std::string>& settings,
                  bool timing = true,
                  unsigned samples = 1) {
    const TemporaryFolder folder;
    ReplayOptions options;
    options.input = trace;
    options.output = folder.path();
    options.frames = frames;
    options.timing = timing;
    options.samples = samples;
    for (const std::string& setting : settings)
        apply_setting(setting, options.configuration);
    replay(options);
    std::ifstream file(folder / "stats.json");
    Replayed result{Json::parse(file), {}};
    for (const Json& frame : result.statistics["frames"]) {
        const auto number = frame["frame"].get<std::uint64_t>();
        const std::string picture = folder / fmt::format("frame_{:04}.png", number);
        result.pictures.push_back(picture_of(number, read_image(picture)));
    }
    return result;
}

// A frame's counters of the machine in time.
class TimedFrame {
public:
    explicit TimedFrame(const Json& counters)
        : counters_(counters) {}

    std::uint64_t operator[](const std::string& name) const {
        INFO(name);
        REQUIRE(counters_.contains(name));
        return counters_[name].get<std::uint64_t>();
    }

    // All X for which there is a counter X + suffix.
    std::set<std::string> names(const std::string& suffix) const {
        std::set<std::string> names;
        for (const auto& [name, value] : counters_.items())
            if (name.ends_with(suffix)) names.insert(name.substr(0, name.size() - suffix.size()));
        return names;
    }

    std::uint64_t sum(const std::string& prefix, const std::string& suffix) const {
        std::uint64_t sum = 0;
        for (const auto& [name, value] : counters_.items())
            if (name.starts_with(prefix) && name.ends_with(suffix))
                sum += value.get<std::uint64_t>();
        return sum;
    }

private:
    const Json& counters_;
};

const std::set<std::string> Units = {"host",
                                     "command_processor",
                                     "vertex_fetch",
                                     "geometry",
                                     "clip",
                                     "setup",
                                     "raster",
                                     "depth",
                                     "texture",
                                     "fragment",
                                     "color",
                                     "scan_out",
                                     "arbiter",
                                     "memory"};

const std::set<std::string> TileUnits = {"binner", "parameter_fetch", "tile_memory"};

void check_units(const TimedFrame& frame, bool tile_based) {
    std::set<std::string> units = Units;
    if (tile_based) units.insert(TileUnits.begin(), TileUnits.end());
    CHECK(frame.names("_busy_cycles") == units);
    for (const std::string& unit : units) {
        INFO(unit);
        CHECK(frame[unit + "_busy_cycles"] + frame[unit + "_idle_cycles"] +
                  frame.sum(unit + "_stalled_", "_cycles") ==
              frame["total_cycles"]);
    }
}

// A cache, its lines' size in the configuration, and its client at the memory.
struct CacheNames {
    std::string cache, group, client;
};
const CacheNames Caches[] = {{"index_cache", "vertex", "index"},
                             {"vertex_cache", "vertex", "vertex"},
                             {"texel_cache", "texel_cache", "texture"},
                             {"depth_cache", "depth_cache", "depth"},
                             {"color_cache", "color_cache", "color"}};

void check_cache(const TimedFrame& frame, const CacheNames& names, std::uint64_t line_bytes) {
    INFO(names.cache);
    const auto of = [&](const std::string& what) { return frame[names.cache + "_" + what]; };
    CHECK(of("hits") + of("misses") == of("accesses"));
    CHECK(of("compulsory_misses") + of("capacity_misses") + of("conflict_misses") == of("misses"));
    CHECK(of("misses_without_fetch") <= of("misses"));
    CHECK(of("read_bytes") ==
          line_bytes * (of("misses") - of("misses_without_fetch") + of("partial_fetches")));
    const std::string client = "memory_" + names.client, tile = "tile_" + names.client;
    CHECK(frame[client + "_read_bytes"] == of("read_bytes") + frame.sum(tile, "_loaded_bytes"));
    CHECK(frame[client + "_written_bytes"] ==
          of("written_bytes") + frame.sum(tile, "_stored_bytes"));
}

void check_accounts(const Json& statistics) {
    CHECK(TimedFrame(statistics["frames"][0]["timing"]).names("_misses_without_fetch").size() ==
          std::size(Caches));
    for (const Json& frame : statistics["frames"]) {
        INFO("frame " << frame["frame"]);
        const TimedFrame timing(frame["timing"]);
        check_units(timing, statistics["configuration"]["raster"]["architecture"] == "tile_based");
        for (const CacheNames& cache : Caches)
            check_cache(timing, cache, statistics["configuration"][cache.group]["line_bytes"]);
        const Json& memory = statistics["configuration"]["memory"];
        CHECK(timing["memory_bus_cycles"] ==
              timing["total_cycles"] * memory["channels"].get<std::uint64_t>());
        CHECK(timing["memory_data_cycles"] + timing.sum("memory_lost_", "_cycles") ==
              timing["memory_bus_cycles"]);
        const TimedFrame functional(frame["functional"]);
        CHECK(functional["fragments_covered"] ==
              functional.sum("fragments_killed_", "") + functional["fragments_written"]);
    }
}

void check_totals(const Json& statistics) {
    CHECK(statistics["frame_count"] == statistics["frames"].size());
    for (const char* const part : {"functional", "timing"}) {
        for (const auto& [name, total] : statistics["totals"][part].items()) {
            std::uint64_t sum = 0;
            for (const Json& frame : statistics["frames"])
                sum += frame[part][name].get<std::uint64_t>();
            INFO(name);
            CHECK(total == sum);
        }
    }
}

TEST_CASE("The accounts of each frame of a real trace add up") {
    const Json statistics = replayed(own_trace("corridor"), {}, {}).statistics;
    REQUIRE(statistics["frames"].size() == 8);
    check_accounts(statistics);
    check_totals(statistics);
    const TimedFrame totals(statistics["totals"]["timing"]);
    for (const char* const cache : {"vertex_cache", "texel_cache", "depth_cache", "color_cache"})
        CHECK(totals[std::string(cache) + "_misses"] > 0);
}

TEST_CASE("The accounts of a real program's trace add up") {
    for (const std::string& name : workload_traces()) {
        if (name != "openarena_dm" && name != "chromium" && name != "polyhedra") continue;
        INFO(name);
        const Json statistics = replayed(workload_trace(name), {0, 1}, {}).statistics;
        check_accounts(statistics);
        check_totals(statistics);
    }
}

// The smallest machine that can be configured, and others of extreme shapes.
const std::vector<std::string> Tiny = {"vertex.cache_sets=1",
                                       "vertex.cache_ways=1",
                                       "vertex.line_bytes=16",
                                       "vertex.fetch_queue=1",
                                       "vertex.reuse_entries=0",
                                       "setup.queue=1",
                                       "raster.queue=1",
                                       "texel_cache.sets=1",
                                       "texel_cache.ways=1",
                                       "texel_cache.line_bytes=16",
                                       "texel_cache.fragment_fifo=1",
                                       "texel_cache.outstanding_lines=1",
                                       "texel_cache.lookups_per_cycle=1",
                                       "depth_cache.sets=1",
                                       "depth_cache.ways=1",
                                       "depth_cache.line_bytes=16",
                                       "depth_cache.fragment_fifo=1",
                                       "depth_cache.outstanding_lines=1",
                                       "color_cache.sets=1",
                                       "color_cache.ways=1",
                                       "color_cache.line_bytes=16",
                                       "color_cache.fragment_fifo=1",
                                       "color_cache.outstanding_lines=1",
                                       "fragment.queue=1",
                                       "memory.channels=1",
                                       "memory.banks=1",
                                       "memory.queue=1",
                                       "memory.bytes_per_cycle=1",
                                       "memory.page_policy=closed"};
const std::vector<std::string> Huge = {"vertex.cache_sets=1024",
                                       "vertex.cache_ways=16",
                                       "vertex.line_bytes=512",
                                       "vertex.fetch_queue=4096",
                                       "vertex.reuse_entries=4096",
                                       "setup.queue=4096",
                                       "raster.queue=4096",
                                       "raster.quads_per_cycle=16",
                                       "texel_cache.sets=4096",
                                       "texel_cache.ways=16",
                                       "texel_cache.line_bytes=512",
                                       "texel_cache.fragment_fifo=65536",
                                       "texel_cache.outstanding_lines=65536",
                                       "texel_cache.lookups_per_cycle=64",
                                       "texel_cache.bilinear_quads_per_cycle=16",
                                       "depth_cache.sets=4096",
                                       "depth_cache.line_bytes=512",
                                       "depth_cache.fragment_fifo=65536",
                                       "depth_cache.lookups_per_cycle=64",
                                       "color_cache.sets=4096",
                                       "color_cache.line_bytes=512",
                                       "color_cache.fragment_fifo=65536",
                                       "color_cache.lookups_per_cycle=64",
                                       "fragment.queue=4096",
                                       "memory.channels=16",
                                       "memory.banks=64",
                                       "memory.interleave_bytes=1024",
                                       "memory.queue=1024",
                                       "memory.bytes_per_cycle=256"};
const std::vector<std::string> FullyAssociative = {"texel_cache.sets=1",
                                                   "texel_cache.ways=64",
                                                   "texel_cache.layout=linear",
                                                   "depth_cache.sets=1",
                                                   "depth_cache.ways=64",
                                                   "depth_cache.layout=linear",
                                                   "color_cache.sets=1",
                                                   "color_cache.ways=64",
                                                   "color_cache.layout=linear",
                                                   "raster.traversal=scanline"};
const std::vector<std::string> TileBased = {
    "raster.architecture=tile_based", "raster.bin_size=16", "texel_cache.layout=blocked_6d"};

TEST_CASE("Caches and queues of any size leave the pixels alone, and their accounts add up") {
    const std::string trace = own_trace("light_maps");
    const FrameRange frames{1, 1};
    const Replayed untimed = replayed(trace, frames, {}, false);
    std::vector<std::uint64_t> cycles;
    for (const auto& settings : {Tiny, {}, Huge, FullyAssociative, TileBased}) {
        INFO((settings.empty() ? "default" : settings.front()));
        const Replayed run = replayed(trace, frames, settings);
        REQUIRE(run.pictures.size() == 1);
        CHECK(run.pictures == untimed.pictures);
        CHECK(run.statistics["totals"]["functional"]["fragments_written"] ==
              untimed.statistics["totals"]["functional"]["fragments_written"]);
        check_accounts(run.statistics);
        const TimedFrame totals(run.statistics["totals"]["timing"]);
        cycles.push_back(totals["total_cycles"]);
        if (settings == FullyAssociative) {
            CHECK(totals["texel_cache_conflict_misses"] == 0);
            CHECK(totals["depth_cache_conflict_misses"] == 0);
        }
    }
    CHECK(cycles[0] > cycles[1]); // The tiny machine, the usual one, the huge one.
    CHECK(cycles[1] > cycles[2]);
    CHECK(std::set(cycles.begin(), cycles.end()).size() == 5); // They were five.
}

TEST_CASE("The accounts of a multisampled trace add up on machines of any size") {
    const FrameRange frames{2, 2};
    const Replayed untimed = replayed(own_trace("corridor"), frames, {}, false, MaxSamples);
    for (const auto& settings : {Tiny, {}, Huge, TileBased}) {
        INFO((settings.empty() ? "default" : settings.front()));
        const Replayed run = replayed(own_trace("corridor"), frames, settings, true, MaxSamples);
        CHECK(run.pictures == untimed.pictures);
        check_accounts(run.statistics);
        const TimedFrame totals(run.statistics["totals"]["functional"]);
        CHECK(totals["samples_written"] > totals["fragments_written"]);
        CHECK(totals["samples_covered"] <= MaxSamples * totals["fragments_covered"]);
        CHECK(totals["samples_written"] <= totals["samples_covered"]);
    }
}

} // namespace
} // namespace ffgpu::tools
