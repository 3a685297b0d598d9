// Histories of pixels of real frames: they end with the frame's pixel, and no fragment is missing
// in them. FFGPU_EXPLAIN_PIXELS: how many pixels of each trace are asked for.

#include "tests/system/trace_run.h"
#include "tools/explain/explain.h"

#include <cstdlib>
#include <map>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

unsigned wanted_pixels() {
    const char* const text = std::getenv("FFGPU_EXPLAIN_PIXELS");
    return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 40;
}

// Of each window pixel the fragments that the work stream has, by how they ended.
using Ends = std::array<std::uint64_t, FragmentEndNames.size()>;

class FragmentCensus : public WorkSink {
public:
    void bin(std::shared_ptr<const WorkBin> bin) override {
        for (const WorkTile& tile : bin->tiles)
            for (const WorkBatch& batch : tile.batches)
                for (const WorkQuad& quad : batch.quads)
                    add(quad);
    }
    void end_frame(std::uint32_t) override {}

    std::map<std::pair<unsigned, unsigned>, Ends> pixels;

private:
    void add(const WorkQuad& quad) {
        for (unsigned lane = 0; lane < 4; ++lane) {
            const auto in = [lane](unsigned mask) { return (mask >> lane & 1) != 0; };
            if (!in(quad.covered)) continue;
            const FragmentEnd end = !in(quad.after_early_depth) ? FragmentEnd::EarlyDepth
                                    : !in(quad.after_coverage)  ? FragmentEnd::Coverage
                                    : !in(quad.after_alpha)     ? FragmentEnd::Alpha
                                    : !in(quad.after_stencil)   ? FragmentEnd::Stencil
                                    : !in(quad.after_depth)     ? FragmentEnd::Depth
                                                                : FragmentEnd::Written;
            ++pixels[{quad.x + (lane & 1), quad.y + (lane >> 1)}][static_cast<std::size_t>(end)];
        }
    }
};

Ends ends_of(const PixelHistory& history) {
    Ends ends{};
    for (const PixelEvent& event : history.events)
        if (event.fragment) ++ends[static_cast<std::size_t>(event.fragment->end)];
    return ends;
}

std::vector<PicturePixel> seeded_pixels(const ExplainedFrame& frame, unsigned count) {
    std::mt19937 random(20011);
    std::vector<PicturePixel> pixels;
    for (unsigned i = 0; i < count; ++i) {
        const auto x = static_cast<unsigned>(random() % frame.width());
        const auto y = static_cast<unsigned>(random() % frame.height());
        pixels.emplace_back(x, y);
    }
    return pixels;
}

// That each history ends with the frame's pixel, explain_frame() checks itself; here is asked
// whether it begins where it should and is the frame's.
void explain_pixels(const std::string& path,
                    std::uint64_t number,
                    unsigned count,
                    const ExplainOptions& machine = {}) {
    INFO(path << ", frame " << number);
    ExplainOptions options = machine;
    options.input = path;
    options.frame = number;
    const ExplainedFrame frame(options);
    FragmentCensus census;
    const auto histories = frame.histories(seeded_pixels(frame, count), &census);
    std::uint64_t fragments = 0, silent = 0;
    for (const PixelHistory& history : histories) {
        const std::uint32_t last = history.events.empty() ? history.before[0].color[0]
                                                          : history.events.back().after.color[0];
        CHECK(last == history.value);
        const Ends ends = ends_of(history);
        const auto found = census.pixels.find({history.x, frame.height() - 1 - history.y});
        CHECK(ends == (found == census.pixels.end() ? Ends{} : found->second));
        for (const std::uint64_t one : ends)
            fragments += one;
        for (const PixelEvent& event : history.events)
            silent += event.call.name.empty();
    }
    CHECK(silent == 0);
    std::printf("%s, frame %llu: %zu pixels, %llu fragments\n",
                path.c_str(),
                static_cast<unsigned long long>(number),
                histories.size(),
                static_cast<unsigned long long>(fragments));
}

TEST_CASE("a pixel's history ends with the frame's pixel and misses none of its fragments",
          "[explain]") {
    for (const std::string& name : own_traces())
        explain_pixels(own_trace(name), 2, wanted_pixels());
    ExplainOptions multisampled;
    multisampled.samples = 4;
    explain_pixels(own_trace("corridor"), 1, wanted_pixels(), multisampled);
    ExplainOptions forced;
    forced.configuration.gpu.supersampling = 4;
    forced.configuration.gpu.texture_filter = gl::ForcedFilter::Feline;
    explain_pixels(own_trace("corridor"), 1, wanted_pixels(), forced);
}

TEST_CASE("so it does in programs of others", "[explain][workloads]") {
    unsigned taken = 0;
    for (const std::string name : {"openarena_dm", "chromium", "stairs", "polyhedra", "glxgears"}) {
        if (!std::filesystem::exists(workload_trace(name))) continue;
        explain_pixels(workload_trace(name), 3, wanted_pixels());
        ++taken;
    }
    if (taken == 0) WARN("skipped: traces of real programs are not there");
}

std::map<std::string, std::uint64_t> counters_of(const std::string& path, std::uint64_t frame) {
    const Run before = run_trace(path, {.last_frame = frame - 1});
    Run run = run_trace(path, {.last_frame = frame});
    for (auto& [name, value] : run.functional)
        value -= before.functional.at(name);
    return run.functional;
}

TEST_CASE("of a whole frame the histories hold as many fragments as were counted", "[explain]") {
    const std::string path = own_trace("chrome");
    const ExplainedFrame frame({.input = path, .frame = 1});
    Ends sum{};
    constexpr unsigned Rows = 60; // at a time
    for (unsigned y0 = 0; y0 < frame.height(); y0 += Rows) {
        std::vector<PicturePixel> pixels;
        for (unsigned y = y0; y < y0 + Rows; ++y)
            for (unsigned x = 0; x < frame.width(); ++x)
                pixels.emplace_back(x, y);
        for (const PixelHistory& history : frame.histories(pixels)) {
            const Ends ends = ends_of(history);
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += ends[i];
        }
    }
    const auto counted = counters_of(path, 1);
    const auto of = [&](FragmentEnd end) { return sum[static_cast<std::size_t>(end)]; };
    std::uint64_t all = 0;
    for (const std::uint64_t one : sum)
        all += one;
    CHECK(all == counted.at("fragments_covered"));
    CHECK(of(FragmentEnd::Written) == counted.at("fragments_written"));
    CHECK(of(FragmentEnd::EarlyDepth) == counted.at("fragments_killed_early_depth"));
    CHECK(of(FragmentEnd::Alpha) == counted.at("fragments_killed_alpha"));
    CHECK(of(FragmentEnd::Stencil) == counted.at("fragments_killed_stencil"));
    CHECK(of(FragmentEnd::Depth) == counted.at("fragments_killed_depth"));
}

// Look-ups in the caches of depth and colour, of the pixel's quads.
struct TargetLookups {
    unsigned depth = 0, color = 0, misses = 0;

    void add(const FragmentNote& note, std::uint64_t cycles) {
        for (const TargetLookup& lookup : note.timing.targets) {
            CHECK(lookup.cycle < cycles);
            ++(lookup.cache == TargetLookup::Cache::Depth ? depth : color);
            misses += lookup.missed;
        }
    }
};

void explain_timing(work::Architecture architecture) {
    const std::string path = own_trace("corridor");
    ExplainOptions options{.input = path, .frame = 0, .timing = true};
    options.configuration.timing.raster.architecture = architecture;
    const ExplainedFrame frame(options);
    const auto histories = frame.histories(seeded_pixels(frame, 20));
    const Run run = run_trace(path, {.timing = options.configuration.timing, .last_frame = 0});
    const bool tiled = architecture == work::Architecture::TileBased;
    TargetLookups targets;
    unsigned lookups = 0, hits = 0;
    for (const PixelHistory& history : histories) {
        CHECK(history.cycles == run.cycles.at(0));
        for (const PixelEvent& event : history.events) {
            if (!event.fragment) continue;
            const FragmentNote& note = *event.fragment;
            const bool written = note.end == FragmentEnd::Written;
            targets.add(note, history.cycles);
            const bool has_color =
                std::ranges::any_of(note.timing.targets, [](const TargetLookup& lookup) {
                    return lookup.cache == TargetLookup::Cache::Color;
                });
            const bool writes = written && !note.writes.empty();
            CHECK((!writes || has_color != tiled)); // On chip there is no cache.
            CHECK((!written || note.timing.retired.has_value()));
            for (const TexelLookup& lookup : note.timing.lookups) {
                REQUIRE(lookup.cycle.has_value());
                CHECK(*lookup.cycle < history.cycles);
                CHECK((!written || *lookup.cycle < *note.timing.retired));
                ++lookups;
                hits += !lookup.missed;
            }
        }
    }
    CHECK(lookups > 0);
    CHECK((hits > 0 && hits < lookups));
    CHECK((targets.depth > 0 && targets.color > 0) != tiled);
    CHECK(targets.misses < targets.depth + targets.color + tiled);
}

TEST_CASE("the machine's word for a pixel is that of the machine that replays the frame",
          "[explain]") {
    for (const auto architecture : {work::Architecture::Immediate, work::Architecture::TileBased})
        explain_timing(architecture);
}

} // namespace
} // namespace ffgpu::tools
