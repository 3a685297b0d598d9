// `ffgpu info` and `ffgpu dump`: files told by their content, not by what wrote them.

#include "model/capture/capture_writer.h"
#include "model/gpu/functional_gpu.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"

#include <cstdlib>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string output_of(const std::vector<std::string>& arguments, int status = 0) {
    return printed(stdout, [&] { CHECK(run(arguments) == status); });
}

TEST_CASE("info tells a trace's calls, frames, sizes, contexts and draws") {
    const TemporaryFile trace(trace::in_snappy(clears(3, true)));
    const std::string text = output_of({"info", trace.path()});
    // A context, a binding, a viewport; of each frame a colour, a clear, a rectangle and a swap.
    CHECK_THAT(text,
               StartsWith(trace.path() + ": a trace (version 6): 15 calls in 1 thread, 1 "
                                         "context made\n"));
    CHECK_THAT(text, Contains("frames: 3, 0 to 2\n       3 of 8x4 pixels\n"));
    CHECK_THAT(text, Contains("draws: 3 of 12 vertices, 0 images, 3 clears, "));
    CHECK_THAT(text, Contains("       3 8x4 rgba8\n"));
    CHECK_THAT(text, Contains("extensions: none with functions of their own\n"));
    CHECK_THAT(text, Contains("       3 glRectf\n"));
    CHECK_THAT(text, Contains("textures: 0\n"));
}

TEST_CASE("info names the extension that a function comes from") {
    trace::TraceWriter writer;
    writer.call(0, "glActiveTextureARB", {"texture"}, {[&] { writer.enumeration(0, 0x84c1); }});
    writer.call(1, "glCreateShader", {"type"}, {[&] { writer.enumeration(0, 0x8b31); }});
    writer.call(2, "glActiveTexture", {"texture"}, {[&] { writer.enumeration(0, 0x84c1); }});
    const TemporaryFile trace(trace::in_snappy(writer.bytes));
    const std::string text = output_of({"info", trace.path()});
    CHECK_THAT(text, Contains("       1 GL_ARB_multitexture\n       1 GL_VERSION_2_0\ncalls of"));
    CHECK_THAT(text, Contains("note: not supported yet: glCreateShader\n"));
}

TEST_CASE("info tells the same of a capture and a work file as of the frames they are made from") {
    const TemporaryFolder folder;
    const TemporaryFile trace(trace::in_snappy(clears(4, true)));
    const std::string capture = folder / "two.ffc", work = folder / "two.ffw";
    REQUIRE(run({"replay",
                 trace.path(),
                 "--frames",
                 "1-2",
                 "--capture",
                 capture,
                 "--save-work",
                 work}) == 0);
    for (const std::string& file : {capture, work}) {
        const std::string text = output_of({"info", file});
        CHECK_THAT(text,
                   StartsWith(file + (file == capture ? ": a device capture" : ": a work file")));
        CHECK_THAT(text, Contains("frames: 2, 1 to 2\n       2 of 8x4 pixels\n"));
        CHECK_THAT(text, Contains("draws: 2 of 8 vertices, 0 images, 2 clears, 0 copies"));
    }
    for (const std::vector<std::string>& verb :
         {std::vector<std::string>{"replay", "-o", folder / "x"},
          {"explain", "--frame", "1", "--pixel", "0,0"},
          {"diff"}}) {
        std::vector<std::string> words = verb;
        words.push_back(work);
        CHECK_THAT(printed(stderr, [&] { CHECK(run(words) == 2); }),
                   StartsWith("ffgpu: " + work + ": is a work file, ") &&
                       Contains("ffgpu time, cache, export, sweep and info read it"));
    }
    CHECK(run({"info", folder / "missing"}) == 2);
    CHECK(run({"dump", trace.path()}) == 2);
}

// Frame 7 of a capture: density of fog changed, one clear.
std::string small_capture(const std::string& path) {
    FunctionalGpu gpu({.memory_bytes = 1 << 20});
    capture::CaptureWriter writer(gpu);
    const std::vector<std::byte> bytes(3, std::byte{9});
    writer.write_memory(4098, bytes);
    Fog fog;
    fog.mode = FogMode::Exp2;
    CommandStream commands;
    commands.write(find_register_address<&Registers::fog>(), fog);
    writer.submit(commands);
    writer.begin(path, 7);
    fog.density = 0.25f;
    commands.clear();
    commands.write(find_register_address<&Registers::fog>(), fog);
    commands.add(ClearCommand{.depth = true, .depth_value = 77});
    commands.add(EndFrameCommand{});
    writer.submit(commands);
    writer.frame_shown(
        7, {.address = 4096, .format = Format::Rgba8, .width = 16, .height = 8, .stride = 64});
    writer.end();
    return path;
}

TEST_CASE("dump prints commands by name, and of registers the fields that change") {
    const TemporaryFile file("", ".ffc");
    const std::string text = output_of({"dump", small_capture(file.path())});
    CHECK(text == "memory 1048576 bytes, first frame 7\n"
                  "write_memory: address 0x00001000, bytes 4096\n"
                  "fog: mode Exp2\n"
                  "snapshot_end: next draw 0\n"
                  "fog: density 0.25\n"
                  "clear: color 0, depth 1, stencil 0, stencil_value 0, color_value 0, "
                  "depth_value 77\n"
                  "end_frame\n"
                  "shown: frame 7, address 0x00001000, 16x8 rgba8\n");
}

TEST_CASE("dump --readmemh prints the commands' words, and all else in comments") {
    const TemporaryFile file("", ".ffc");
    std::istringstream lines(output_of({"dump", "--readmemh", small_capture(file.path())}));
    std::vector<std::uint32_t> words;
    std::string comments;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("// ")) {
            comments += line + '\n';
            continue;
        }
        REQUIRE(line.size() == 8);
        words.push_back(static_cast<std::uint32_t>(std::strtoul(line.c_str(), nullptr, 16)));
    }
    CommandStream expected;
    Fog fog;
    fog.mode = FogMode::Exp2;
    expected.write(find_register_address<&Registers::fog>(), fog);
    fog.density = 0.25f;
    expected.write(find_register_address<&Registers::fog>(), fog);
    expected.add(ClearCommand{.depth = true, .depth_value = 77});
    expected.add(EndFrameCommand{});
    CHECK(words == expected.words);
    CHECK_THAT(comments, Contains("// fog\n// snapshot_end: next draw 0\n// fog\n// clear\n"));
}

} // namespace
} // namespace ffgpu::tools
