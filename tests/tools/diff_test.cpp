// `ffgpu diff`: equal backends, one planted fault in each stage, other inputs, other programs.

#include "model/base/input_error.h"
#include "model/capture/capture_writer.h"
#include "tests/gpu/busy_scene.h"
#include "tests/support/temporary_file.h"
#include "tests/tools/diff_faults.h"
#include "tests/tools/tool.h"
#include "tools/diff/difference.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;
using namespace ffgpu::tools;

namespace {

// A capture of the busy scene, a frame with `samples` samples a pixel. `draw` of its draws is
// another by one register.
void write_capture(const std::string& path, unsigned samples = 1, int changed_draw = -1) {
    Scene scene(96, 80);
    capture::CaptureWriter writer(scene.gpu);
    writer.begin(path, 0);
    scene.into = &writer;
    Targets& targets = scene.registers.targets;
    targets.color[0].samples = targets.depth.samples = static_cast<std::uint8_t>(samples);
    scene.registers.multisample.enable = samples > 1;
    draw_mixture(scene, [&](int draw) {
        const PrimitiveType type = vary_busily(scene.registers, draw);
        if (draw == changed_draw) scene.registers.fragment.alpha_reference ^= 1;
        return type;
    });
    writer.finish();
    writer.frame_shown(0, targets.color[0]);
    writer.end();
}

std::optional<Difference>
difference_of(const std::string& path, const Stages* stages, std::size_t most = 1) {
    DiffOptions options{.a = {.input = path, .stages = &ReferenceStages},
                        .b = {.input = path, .stages = stages},
                        .question = {},
                        .most_entries = most};
    return find_difference(options);
}

} // namespace

TEST_CASE("The functional GPU and its reference give the same account of the busy scene") {
    const TemporaryFile one("", ".ffc"), four("", ".ffc");
    write_capture(one.path());
    write_capture(four.path(), MaxSamples);
    CHECK_FALSE(difference_of(one.path(), &FastStages));
    CHECK_FALSE(difference_of(four.path(), &FastStages));
}

// Every other draw is of the stencil alone: where its colours would be, batches have what was
// there.
TEST_CASE("A colour that nobody looks at is in no account") {
    const TemporaryFile file("", ".ffc");
    Scene scene(96, 80);
    capture::CaptureWriter writer(scene.gpu);
    writer.begin(file.path(), 0);
    scene.into = &writer;
    scene.registers.stencil.enable = true;
    scene.registers.stencil.front.depth_pass = StencilOp::IncrementWrap;
    draw_mixture(scene, [&](int draw) {
        const PrimitiveType type = vary_busily(scene.registers, draw);
        scene.registers.blend.write_mask = draw % 2 == 0 ? 0xf : 0;
        scene.registers.fragment.alpha_test = false;
        return type;
    });
    writer.finish();
    writer.frame_shown(0, scene.registers.targets.color[0]);
    writer.end();
    CHECK_FALSE(difference_of(file.path(), &FastStages));
}

TEST_CASE("Of a fault in one lane of a stage, diff names the stage, quad, lane and field") {
    const TemporaryFile one("", ".ffc"), four("", ".ffc");
    write_capture(one.path());
    write_capture(four.path(), MaxSamples);
    for (const Fault& fault : planted_faults()) {
        INFO(fault.part << " " << fault.field);
        FaultyBackend backend;
        fault.plant(backend);
        const auto found = difference_of((fault.samples ? four : one).path(), &backend.stages);
        REQUIRE(found);
        REQUIRE(found->entries.size() == 1);
        const DifferentEntry& entry = found->entries[0];
        CHECK(entry.part == fault.part);
        CHECK(entry.field == fault.field);
        CHECK(entry.a != entry.b);
        CHECK(entry.place.find(fault.place) != std::string::npos);
    }
}

TEST_CASE("Of another register diff names the draw and the register's field") {
    const TemporaryFile a("", ".ffc"), b("", ".ffc");
    write_capture(a.path());
    write_capture(b.path(), 1, 15);
    const auto found =
        find_difference({.a = {.input = a.path()}, .b = {.input = b.path()}, .question = {}});
    REQUIRE(found);
    CHECK(found->draw == "15");
    CHECK(found->command == 16); // A clear came before the draws.
    CHECK(found->entries[0].part == "registers");
    CHECK(found->entries[0].field == "alpha_reference");
    CHECK(found->entries[0].a == "none");
    CHECK(found->entries[0].b == "41");
}

TEST_CASE("A trace is equal to its capture, which has no calls") {
    const TemporaryFile trace(trace::in_snappy(clears(3, true))), capture("", ".ffc");
    REQUIRE(run({"replay", trace.path(), "--capture", capture.path()}) == 0);
    CHECK(run({"diff", trace.path(), capture.path()}) == 0);
    CHECK(run({"diff", capture.path(), trace.path()}) == 0);
    const TemporaryFile other(trace::in_snappy(clears(3)));
    CHECK(run({"diff", other.path(), capture.path()}) == 1);
}

TEST_CASE("diff's exit status and words") {
    const TemporaryFile a("", ".ffc"), b("", "it's b.ffc");
    write_capture(a.path());
    write_capture(b.path(), 1, 15);
    int status = -1;
    const auto diff = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "diff");
        return printed(stdout, [&] { status = run(words); });
    };
    CHECK(diff({a.path()}).find("Equal") != std::string::npos);
    CHECK(status == 0);
    const std::string text = diff({a.path(), b.path()});
    CHECK(status == 1);
    CHECK(text.find("draw 15") != std::string::npos);
    CHECK(text.find("--command 16") != std::string::npos);
    CHECK(text.find("it'\\''s b.ffc' --backend-a") != std::string::npos); // as a shell reads it
    CHECK(diff({a.path(), b.path(), "--command", "15"}).find("Equal") != std::string::npos);
    CHECK(status == 0);
    diff({a.path(), b.path(), "--command", "16", "--most", "5"});
    CHECK(status == 1);
    diff({a.path(), "--backend-b", "nobody"});
    CHECK(status == 2);
    diff({"/nonexistent.trace"});
    CHECK(status == 2);
    diff({a.path(), "--program-b", "/nonexistent/ffgpu"});
    CHECK(status == 2);
    diff({a.path(), "--command", "4711"});
    CHECK(status == 2);
    diff({a.path(), "--frames", "5-7"});
    CHECK(status == 2);
}
