// The texels' look-ups straight from what was drawn, against those of whole commands that were
// brought into a machine's order.

#include "model/work/lookup_walk.h"
#include "model/work/texel_scan.h"
#include "tests/work/recorded_work.h"

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// A quad's look-ups of texels, and how far back the ones before lie; or lines that were
// overwritten, without reads.
struct Told {
    std::vector<LineLookup> lines;
    std::uint32_t reads = 0;
    Reuse since_last = Reuse::Quad;

    bool operator==(const Told&) const = default;
};

class TexelList final : public LookupSink {
public:
    void lookups(LookupClient client,
                 const LookupPlace& place,
                 std::span<const LineLookup> lines,
                 std::uint32_t reads) override {
        if (client != LookupClient::Texel) return;
        const Reuse since = all.empty() ? Reuse::EarlierFrame : place.since(last_);
        all.push_back({{lines.begin(), lines.end()}, reads, since});
        last_ = place.number;
    }
    void flush(LookupClient) override {}
    void overwritten(LookupClient client, std::span<const OverwrittenLine> lines) override {
        if (client != LookupClient::Texel) return;
        Told& told = all.emplace_back();
        for (const OverwrittenLine& line : lines)
            told.lines.push_back({line.line, false});
        ++rewrites;
    }
    void end_frame(std::uint32_t) override {}

    std::vector<Told> all;
    std::size_t rewrites = 0;

private:
    std::uint64_t last_ = 0;
};

// Two frames; the second meets textures that were rewritten.
void draw(WorkSink& sink, const FunctionalGpu::Config& host, WorkDetail detail) {
    test::Scene scene(150, 100, host);
    scene.gpu.set_work_sink(&sink, detail);
    for (int frame = 0; frame < 2; ++frame) {
        draw_varied(scene);
        end_frame(scene);
    }
    scene.gpu.set_work_sink(nullptr);
}

std::vector<Told> by_walk(const WorkConfig& config, WorkDetail detail = WorkDetail::Masks) {
    TexelList list;
    LookupWalk walk(config, {}, list);
    MachineOrder order(config, walk);
    CommandAssembler assembler(order);
    draw(assembler, {.threads = 1}, detail);
    CHECK(list.rewrites > 0);
    return list.all;
}

std::vector<Told> by_scan(const WorkConfig& config,
                          const FunctionalGpu::Config& host,
                          WorkDetail detail = WorkDetail::Masks) {
    TexelList list;
    TexelScan scan(config, list);
    DrawSplitter splitter(scan);
    draw(splitter, host, detail);
    return list.all;
}

std::vector<Told> by_scan_of_commands(const WorkConfig& config,
                                      WorkDetail detail = WorkDetail::Masks) {
    TexelList list;
    TexelScan scan(config, list);
    CommandAssembler assembler(scan);
    draw(assembler, {.threads = 1}, detail);
    return list.all;
}

TEST_CASE("a scan of what was drawn tells the look-ups of the machine's order", "[scan]") {
    for (const Traversal traversal : {Traversal::Scanline,
                                      Traversal::Column,
                                      Traversal::Tiled,
                                      Traversal::Nested,
                                      Traversal::Morton,
                                      Traversal::Hilbert})
        for (const Layout layout : {Layout::Linear, Layout::Blocked, Layout::Blocked6d}) {
            WorkConfig config;
            config.raster.traversal = traversal;
            config.raster.tile_width = traversal == Traversal::Tiled ? 4 : 16;
            config.texel_cache.layout = layout;
            config.texel_cache.line_bytes = layout == Layout::Linear ? 32 : 128;
            config.merges_texel_reads = layout != Layout::Blocked6d;
            config.depth_test = layout == Layout::Blocked ? DepthTest::Late : config.depth_test;
            INFO("traversal " << static_cast<int>(traversal) << ", layout "
                              << static_cast<int>(layout));
            const std::vector<Told> expected = by_walk(config);
            REQUIRE(expected.size() > 1000);
            CHECK(by_scan(config, {.threads = 1}) == expected);
            CHECK(by_scan(config, {.threads = 2, .tile_size = 16, .bin_bytes = 20000}) == expected);
            CHECK(by_scan_of_commands(config) == expected);
        }
}

TEST_CASE("a scan of work with values leaves out what the machine's tests end", "[scan]") {
    WorkConfig config;
    config.depth_test = DepthTest::Late;
    const std::vector<Told> without = by_walk(config);
    for (const DepthTest test :
         {DepthTest::AsGlAllows, DepthTest::EarlyWhereExact, DepthTest::Late}) {
        INFO("test " << static_cast<int>(test));
        config.depth_test = test;
        const std::vector<Told> expected = by_walk(config, WorkDetail::Values);
        CHECK(by_scan(config, {.threads = 1}, WorkDetail::Values) == expected);
        CHECK(by_scan(config,
                      {.threads = 2, .tile_size = 16, .bin_bytes = 20000},
                      WorkDetail::Values) == expected);
        CHECK(by_scan_of_commands(config, WorkDetail::Values) == expected);
        if (test == DepthTest::Late) CHECK(expected.size() > without.size());
    }
}

TEST_CASE("machines that a scan does not read are named", "[scan]") {
    WorkConfig config;
    CHECK(TexelScan::reads(config));
    config.raster.granularity = Granularity::Fragment;
    CHECK_FALSE(TexelScan::reads(config));
    config = {};
    config.raster.architecture = Architecture::TileBased;
    CHECK_FALSE(TexelScan::reads(config));
}

} // namespace
} // namespace ffgpu::work
