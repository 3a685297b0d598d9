// Curves are drawn without colours, but where they decide: of a picture that becomes a texture
// whose alpha is tested, all is drawn again.

#include "model/capture/capture_writer.h"
#include "model/work/lookup_walk.h"
#include "tests/gpu/scene.h"
#include "tests/support/temporary_file.h"
#include "tools/cache/cache_study.h"
#include "tools/replay/interruption.h"
#include "tools/work/work_player.h"

#include <csignal>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

constexpr std::uint32_t Size = 64;

void pane(test::Scene& scene, float bottom, float top, float depth, float alpha) {
    const auto corner = [&](float x, float y) {
        return test::Vertex{x, y, depth, 1, 1, 1, 1, alpha, 0.5f + 0.5f * x, 0.5f + 0.5f * y};
    };
    scene.draw(PrimitiveType::Quads,
               {corner(-1, bottom), corner(1, bottom), corner(1, top), corner(-1, top)});
}

// The upper half of the picture is opaque. It becomes a texture; a pane of it, nearer than what
// follows, is left where its alpha is above a half; a pane behind that reads texels elsewhere.
void write_capture(const std::string& path, bool tests_alpha) {
    test::Scene scene(Size, Size);
    capture::CaptureWriter writer(scene.gpu);
    writer.begin(path, 0);
    scene.into = &writer;
    scene.clear(0);
    pane(scene, 0, 1, 0.5f, 1);
    scene.texture(Size, std::vector<std::uint32_t>(std::size_t{Size} * Size, 0xffffffff));
    const Surface from = scene.registers.targets.color[0];
    Surface to = from;
    to.address = test::TextureAt;
    scene.command(
        CopyRectangleCommand{.source = from, .destination = to, .width = Size, .height = Size});
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.registers.fragment.alpha_test = tests_alpha;
    scene.registers.fragment.alpha_compare = Compare::Greater;
    scene.registers.fragment.alpha_reference = 128;
    pane(scene, -1, 1, -0.5f, 1);
    scene.registers.fragment.alpha_test = false;
    pane(scene, -1, 1, 0, 1);
    CommandStream stream;
    stream.add(Opcode::EndFrame);
    writer.submit(stream);
    writer.finish();
    writer.frame_shown(0, from);
    writer.end();
}

class ReadCount final : public work::LookupSink {
public:
    void lookups(work::LookupClient client,
                 const work::LookupPlace&,
                 std::span<const work::LineLookup>,
                 std::uint32_t reads) override {
        if (client == work::LookupClient::Texel) texels += reads;
    }
    void flush(work::LookupClient) override {}
    void overwritten(work::LookupClient, std::span<const work::OverwrittenLine>) override {}
    void end_frame(std::uint32_t) override {}

    std::uint64_t texels = 0;
};

// By whole commands.
std::uint64_t texels_read(const std::string& path, bool colors, std::uint64_t at_least_frames = 0) {
    ReadCount count;
    const work::WorkConfig config;
    work::LookupWalk walk(config, {}, count);
    work::MachineOrder order(config, walk);
    play_work({.input = path, .colors = colors, .at_least = at_least_frames},
              order,
              [](const work::FrameFigures&) {});
    return count.texels;
}

CacheStudyResult curves_of(const std::string& path) {
    CacheStudyResult result;
    study_caches({.input = path, .clients = {work::LookupClient::Texel}, .line_bytes = {64}},
                 result);
    return result;
}

} // namespace

TEST_CASE("A capture whose alpha test reads the picture is drawn with its colours", "[undrawn]") {
    const TemporaryFile file("", ".ffc");
    write_capture(file.path(), true);
    CHECK_THROWS_AS(texels_read(file.path(), false), MissedColors);
    // Of the first textured pane all, nearest; of the second what the first leaves.
    constexpr std::uint64_t All = std::uint64_t{Size} * Size;
    CHECK(texels_read(file.path(), true) == All + All / 2);
    const CacheStudyResult result = curves_of(file.path());
    REQUIRE(result.curves.size() == 1);
    CHECK(result.curves[0].reads == All + All / 2);
    CHECK(result.frames.size() == 1);
    CHECK(result.curves[0].frame_lines.size() == 1);
}

TEST_CASE("Ctrl-C before it is drawn again leaves the frames that were drawn", "[undrawn]") {
    const TemporaryFile file("", ".ffc");
    write_capture(file.path(), true);
    std::uint64_t next = 0;
    try {
        texels_read(file.path(), false);
    } catch (const MissedColors& missed) {
        next = missed.next;
    }
    CHECK(next == 1);
    {
        const Interruption interruption;
        std::raise(SIGINT);
        REQUIRE(Interruption::signal() == SIGINT);
        CHECK(texels_read(file.path(), true) == 0);
        CHECK(texels_read(file.path(), true, next) == std::uint64_t{Size} * Size * 3 / 2);
    }
    const Interruption none_came;
}

TEST_CASE("A capture whose alpha is not tested is drawn without colours", "[undrawn]") {
    const TemporaryFile file("", ".ffc");
    write_capture(file.path(), false);
    constexpr std::uint64_t All = std::uint64_t{Size} * Size;
    CHECK(texels_read(file.path(), false) == All); // The second pane is hidden.
    CHECK(curves_of(file.path()).curves[0].reads == All);
}

} // namespace ffgpu::tools
