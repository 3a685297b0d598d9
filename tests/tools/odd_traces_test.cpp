// Traces that are not just frames of draws: what comes behind the last frame is in no figure, lines
// that are overwritten miss, machines that need values are told them.

#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/scene_trace.h"
#include "tests/tools/tool.h"
#include "tools/image/image.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;

constexpr GlEnum TriangleFan{6};

void draw(SceneTrace& scene, float size) {
    scene.call("glBegin", TriangleFan);
    for (const auto& [s, t] : {std::pair(0.f, 0.f), {1.f, 0.f}, {1.f, 1.f}, {0.f, 1.f}}) {
        scene.call("glTexCoord2f", s, t);
        scene.call("glVertex2f", size * (2 * s - 1), size * (2 * t - 1));
    }
    scene.call("glEnd");
}

// Textured squares in each frame, and where it goes on, another and an upload.
std::string trace_of(unsigned frames, bool goes_on) {
    SceneTrace scene;
    scene.texture(Luminance, 16, std::string(256, '\x40'), Nearest);
    for (unsigned i = 0; i < frames; ++i) {
        draw(scene, 0.5f);
        draw(scene, 0.9f);
        scene.swap();
    }
    if (goes_on) {
        draw(scene, 1);
        scene.texture(Luminance, 16, std::string(256, '\x50'), Nearest);
        draw(scene, 0.7f);
        scene.call("glFinish");
    }
    return scene.file();
}

std::string work_of(const TemporaryFile& trace, const std::string& path) {
    printed(stderr, [&] {
        REQUIRE(run({"replay", trace.path(), "--no-images", "--save-work", path}) == 0);
    });
    return path;
}

std::string printed_by(const std::vector<std::string>& arguments) {
    return printed(stdout, [&] {
        const std::string said = printed(stderr, [&] { CHECK(run(arguments) == 0); });
        INFO(said);
    });
}

TEST_CASE("What comes behind the last frame is in no curve and no export") {
    const TemporaryFolder folder;
    const TemporaryFile whole(trace_of(2, false), ".trace"), longer(trace_of(2, true), ".trace");
    const std::string work = work_of(longer, folder / "longer.ffw");
    const auto outputs_of = [&](const std::string& input) {
        std::vector<std::string> outputs;
        for (const char* const client : {"texel", "texel,color"})
            outputs.push_back(printed_by({"cache", input, "--client", client}));
        for (const char* const format : {"xdin", "csv", "dram_commands", "vcd", "perfetto"}) {
            const std::string path = folder / format;
            outputs.push_back(printed_by({"export", input, "--format", format, "-o", path}));
            outputs.push_back(content(path));
        }
        return outputs;
    };
    const std::vector<std::string> expected = outputs_of(whole.path());
    CHECK(outputs_of(longer.path()) == expected);
    CHECK(outputs_of(work) == expected);
}

TEST_CASE("Of a program that shows no frame there are no curves and no exports") {
    const TemporaryFile none(trace_of(0, true), ".trace");
    const TemporaryFolder folder;
    const std::string path = folder / "out";
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"cache", none.path()},
          {"export", none.path(), "--format", "xdin", "-o", path},
          {"export", none.path(), "--format", "csv", "-o", path}}) {
        const std::string said = printed(stderr, [&] { CHECK(run(arguments) == 2); });
        CHECK_THAT(said, Contains("has no whole frame"));
        CHECK(content(path).empty());
    }
}

TEST_CASE("A miss map shows the misses of lines that were overwritten") {
    // 16x16 bytes are four lines of 64, each of which misses once until it is overwritten.
    SceneTrace scene;
    const std::string texels(256, '\x40');
    constexpr GlEnum Texture2d{0x0de1}, UnsignedByte{0x1401};
    scene.texture(Luminance, 16, texels, Nearest);
    for (unsigned frame = 0; frame < 3; ++frame) {
        if (frame == 1)
            scene.call(
                "glTexSubImage2D", Texture2d, 0, 0, 0, 16, 16, Luminance, UnsignedByte, texels);
        draw(scene, 1);
        scene.swap();
    }
    const TemporaryFile trace(scene.file(), ".trace");
    const TemporaryFolder folder;
    printed_by({"cache", trace.path(), "-o", folder.path(), "--miss-map", "64x4x64"});
    std::vector<unsigned> missed;
    for (const char* const name : {"miss_map_0000.png", "miss_map_0001.png", "miss_map_0002.png"}) {
        const Image map = read_image(folder / name);
        unsigned misses = 0; // of all pixels of quads: blue one, green two, red more
        for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
            const unsigned red = map.rgb[i], green = map.rgb[i + 1], blue = map.rgb[i + 2];
            REQUIRE(red <= std::max(green, blue));
            if (green + blue > 0) misses += green > blue ? 2 : 1;
        }
        missed.push_back(misses / 4);
    }
    CHECK(missed == std::vector<unsigned>{4, 4, 0});
}

TEST_CASE("A pixel is explained on machines that need values") {
    const TemporaryFile trace(trace_of(1, false), ".trace");
    for (const char* const setting :
         {"depth.test=late", "color_blocks.compression=true", "depth.test=as_gl_allows"}) {
        const std::string text = printed_by({"explain",
                                             trace.path(),
                                             "--frame",
                                             "0",
                                             "--pixel",
                                             "16,16",
                                             "--timing",
                                             "--set",
                                             setting});
        CHECK_THAT(text, Contains("cycle"));
    }
}

} // namespace
} // namespace ffgpu::tools
