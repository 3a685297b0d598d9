// Histories of textured pixels: texels, shares, lerps, environments, and what writers make of them.

#include "tests/support/temporary_file.h"
#include "tests/tools/explain_scene.h"
#include "tests/tools/tool.h"
#include "tools/explain/footprint.h"
#include "tools/explain/footprint_picture.h"
#include "tools/explain/history_json.h"
#include "tools/explain/history_text.h"
#include "tools/explain/region_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Contains;

// Two rows of two texels, the lower first; (0, 0) is black.
const std::vector<std::uint32_t> Texels{0xff000000, 0xff0000ff, 0xff00ff00, 0xffff0000};

// Linear, clamped to the edge, times the primary colour.
void set_texture(ExplainScene& scene) {
    scene.upload(test::TextureAt, test::bytes_of(Texels));
    Registers& r = scene.registers;
    r.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 2, 2, 1, 1, 0};
    r.images[0].address = test::TextureAt;
    r.samplers[0].mip_filter = MipFilter::None;
    r.samplers[0].minify_linear = true;
    r.samplers[0].wrap = {Wrap::ClampToEdge, Wrap::ClampToEdge, Wrap::ClampToEdge};
    Combiner& combiner = r.combiners[0];
    combiner.enable = true;
    combiner.rgb.op = combiner.alpha.op = CombineOp::Modulate;
    combiner.rgb.arguments[0] = {CombineSource::Texture0, CombineOperand::Color};
    combiner.alpha.arguments[0] = {CombineSource::Texture0, CombineOperand::Alpha};
    combiner.rgb.arguments[1] = {CombineSource::Previous, CombineOperand::OneMinusColor};
    combiner.alpha.arguments[1] = {CombineSource::Previous, CombineOperand::Alpha};
}

// Window pixel (9, 5): s = 9.5/16, t = 5.5/16; in texels 1.1875 and 0.6875, from the centres 0.6875
// and 0.1875: 176/256 and 48/256.
PixelHistory textured(ExplainScene& scene) {
    scene.clear(0xff000000);
    set_texture(scene);
    scene.fill({0, 0, 0, 1});
    return scene.history(9, 10);
}

TEST_CASE("texels are told with place, bytes, value and share, and each interpolation") {
    ExplainScene scene;
    const PixelHistory history = textured(scene);
    const FragmentNote& note = *history.events.back().fragment;
    REQUIRE(note.textures.size() == 1);
    const TextureNote& texture = note.textures[0];
    CHECK(texture.coordinates[0] == 9.5f / 16);
    CHECK(texture.coordinates[1] == 5.5f / 16);
    CHECK(texture.quad->step_x[0] == 1.0f / 16);
    CHECK(texture.quad->footprint_x == 1.0f / 64); // (2/16)^2
    REQUIRE(texture.probes.size() == 1);
    REQUIRE(texture.probes[0].levels.size() == 1);
    const probed::LevelFilter& filter = texture.probes[0].levels[0];
    CHECK((filter.weight[0] == 176 && filter.weight[1] == 48));
    CHECK(filter.texel_count == 4);
    CHECK(filter.texels[3].stored[2] == std::byte{255});
    CHECK(filter.along_x[0] == Rgba{175, 0, 0, 255}); // 255 176/256 = 175.3
    const auto shares = texel_shares(texture);
    REQUIRE(shares.size() == 4);
    CHECK(shares.at({0, 0, 0, 1}) == Approx(0.6875 * 0.8125));
    CHECK(shares.at({0, 0, 1, 0}) == Approx(0.3125 * 0.1875));
    double sum = 0;
    for (const auto& [texel, share] : shares)
        sum += share;
    CHECK(sum == Approx(1));
    // The primary colour is black: what is left is the texture's own.
    REQUIRE(note.environments.size() == 1);
    CHECK(note.environments[0].previous == Rgba{0, 0, 0, 255});
    CHECK(note.environments[0].result == texture.color);
    CHECK((history.value & 0xff) == texture.color[0]);
}

// A picture of 16 x 16 pixels with a texture of 64 x 64 texels.
PixelHistory filtered(ExplainScene& scene, TextureFilter filter) {
    constexpr unsigned Across = 64;
    scene.clear(0xff000000);
    set_texture(scene);
    std::vector<std::uint32_t> texels;
    for (unsigned i = 0; i < Across * Across; ++i)
        texels.push_back(0xff000000 | i * 2654435761u >> 8);
    scene.upload(test::TextureAt, test::bytes_of(texels));
    Registers& r = scene.registers;
    r.images[0].shape = {TextureKind::TwoD, Format::Rgba8, Across, Across, 1, 1, 0};
    r.samplers[0].filter = filter;
    r.samplers[0].wrap = {Wrap::Repeat, Wrap::Repeat, Wrap::Repeat};
    if (filter == TextureFilter::RipMap) // A pixel covers 1.5 texels: between four images.
        r.samplers[0].source_width = r.samplers[0].source_height = 24;
    if (filter == TextureFilter::Bicubic) r.samplers[0].max_lod = 0; // magnified
    if (filter == TextureFilter::Feline) {                           // four times as long as wide
        r.tex_coords[0].matrix_enable = true;
        r.tex_coords[0].matrix[5] = 0.25f;
    }
    scene.fill({0, 0, 0, 1});
    return scene.history(9, 10);
}

TEST_CASE("of a filter of the extension each texel is told, and their shares make its colour") {
    const std::pair<TextureFilter, std::size_t> filters[] = {{TextureFilter::Bicubic, 1},
                                                             {TextureFilter::RipMap, 4},
                                                             {TextureFilter::Elliptic, 1},
                                                             {TextureFilter::Feline, 7}};
    for (const auto& [filter, probes] : filters) {
        INFO(static_cast<int>(filter));
        ExplainScene scene;
        const PixelHistory history = filtered(scene, filter);
        const TextureNote& texture = history.events.back().fragment->textures[0];
        CHECK(texture.probes.size() == probes);
        std::map<TexelName, Rgba> texels;
        for (const ProbeNote& probe : texture.probes)
            for (const probed::LevelFilter& level : probe.levels)
                for (unsigned i = 0; i < level.texel_count; ++i)
                    texels[{level.access.level,
                            level.texels[i].layer,
                            level.texels[i].y,
                            level.texels[i].x}] = level.texels[i].color;
        const auto shares = texel_shares(texture);
        REQUIRE(shares.size() == texels.size());
        std::array<double, 3> color{};
        double sum = 0;
        for (const auto& [texel, share] : shares) {
            sum += share;
            for (std::size_t channel = 0; channel < 3; ++channel)
                color[channel] += share * texels.at(texel)[channel];
        }
        CHECK(sum == Approx(1));
        for (std::size_t channel = 0; channel < 3; ++channel)
            CHECK(std::fabs(std::clamp(color[channel], 0.0, 255.0) - texture.color[channel]) < 2);
        CHECK_THAT(history_text(history), Contains("     filter "));
        CHECK(history_json(history)["events"][1]["textures"][0]["probes"].size() == probes);
    }
}

TEST_CASE("text and JSON hold what the history holds") {
    ExplainScene scene;
    const PixelHistory history = textured(scene);
    const TextureNote& texture = history.events.back().fragment->textures[0];
    const std::string text = history_text(history);
    CHECK_THAT(text, Contains("frame 7, pixel (9, 10) from the upper left"));
    CHECK_THAT(text,
               Contains("level 0 texel (1, 0) of layer 0: stored ff0000ff, (255, 0, 0, 255)"));
    CHECK_THAT(text, Contains("weights 176/256, 48/256"));
    CHECK_THAT(text, Contains("rgb: Modulate(Texture0.Color = "));
    CHECK_THAT(text, Contains("Previous.OneMinusColor = (255, 255, 255, 0)"));
    CHECK_THAT(text, Contains("the GL calls are not in it"));
    CHECK(text.find(" cycle") == std::string::npos);

    const auto json = history_json(history);
    CHECK(json["events"][0]["event"] == "clear");
    const auto& fragment = json["events"][1];
    CHECK(fragment["call"].is_null());
    CHECK(fragment["window"] == std::vector<int>{9, 5});
    const auto& filter = fragment["textures"][0]["probes"][0]["levels"][0];
    CHECK(filter["texels"][1]["stored"] == "ff0000ff");
    CHECK(filter["along_x"][0] == std::vector<int>{175, 0, 0, 255});
    CHECK(fragment["environments"][0]["rgb"]["arguments"][1]["value"] ==
          std::vector<int>{255, 255, 255, 0});
    CHECK(fragment["textures"][0]["color"] ==
          std::vector<int>(texture.color.begin(), texture.color.end()));
    CHECK(fragment["end"] == "written");
    CHECK(json["value"] == fragment["after"]);
}

TEST_CASE("the footprint's picture shows the texels, the lowest row below, with their shares") {
    ExplainScene scene;
    const PixelHistory history = textured(scene);
    const Image image = footprint_picture(scene.tape(), history);
    // Two columns and rows of 24 pixels with 6 around.
    REQUIRE((image.width == 60 && image.height == 60));
    const auto at = [&](unsigned x, unsigned y) {
        const auto pixel = image.rgb.begin() + 3 * (std::ptrdiff_t{y} * 60 + x);
        return std::vector<int>(pixel, pixel + 3);
    };
    CHECK(at(0, 0) == std::vector<int>{0, 0, 0});
    CHECK(at(6, 6) == std::vector<int>{255, 255, 255}); // a frame
    CHECK(at(12, 12) == std::vector<int>{0, 255, 0});   // (0, 1) stands above
    CHECK(at(36, 12) == std::vector<int>{0, 0, 255});
    CHECK(at(12, 36) == std::vector<int>{0, 0, 0});
    CHECK(at(36, 36) == std::vector<int>{255, 0, 0});
    // (1, 0) has 143/256 of 20 pixels: 11.
    CHECK(at(32 + 10, 50) == std::vector<int>{255, 60, 200});
    CHECK(at(32 + 11, 50) == std::vector<int>{255, 0, 0});
    ExplainScene plain;
    plain.fill({1, 1, 1, 1});
    CHECK(footprint_picture(plain.tape(), plain.history(0, 0)).pixels() == 0);
}

TEST_CASE("the page of a region holds each pixel's history and colour") {
    ExplainScene scene;
    scene.clear(0xff0000ff);
    scene.registers.scissor = {1, 0, 15, 16};
    scene.fill({0, 1, 0, 1});
    const auto histories = scene.histories({{0, 0}, {1, 0}});
    const std::string page = region_page({"a <title>", 0, 0, 2, 1}, histories);
    const std::string begin = "id=\"data\">";
    const std::size_t from = page.find(begin) + begin.size();
    const auto data = nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
    CHECK(page.find("<h1>a &lt;title&gt;</h1>") != std::string::npos);
    CHECK(data["colors"] == std::vector<std::string>{"ff0000", "00ff00"});
    for (std::size_t i = 0; i < 2; ++i) {
        std::string text;
        for (const std::size_t line : data["pixels"][i])
            text += data["lines"][line].get<std::string>() + '\n';
        CHECK(text == history_text(histories[i]));
    }
    CHECK(page.find("://") == std::string::npos); // Nothing is asked of a network.
}

TEST_CASE("ffgpu explain refuses what it cannot explain, and says why") {
    const TemporaryFile trace(trace::in_snappy(clears(2, true)));
    const std::string path = trace.path(), page = path + ".html";
    const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
        int status = 0;
        const std::string said = printed(stderr, [&] { status = run(arguments); });
        CHECK(status == 2);
        CHECK_THAT(said, Contains(why));
    };
    const auto explain = [&](std::vector<std::string> more, const std::string& why) {
        std::vector<std::string> arguments{"explain", path, "--frame", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        refused(arguments, why);
    };
    explain({"--pixel", "8,0"}, "pixel 8,0: the picture has 8x4 pixels");
    explain({"--pixel", "0,4"}, "pixel 0,4: the picture has 8x4 pixels");
    explain({"--pixel", "0,4", "--lower-left"}, "the picture has 4 rows");
    for (const std::string text : {"0", "0,1,", "0,1x", "x,0", ","})
        explain({"--pixel", text}, "expected 2 numbers with commas between");
    explain({}, "expected --pixel X,Y or --explain-region X,Y,W,H");
    explain({"--pixel", "0,0", "--explain-region", "0,0,1,1", "-o", page}, "expected --pixel");
    explain({"--explain-region", "0,0,1,1"}, "goes with -o PAGE.html");
    explain({"--explain-region", "7,0,2,1", "-o", page}, "the picture has 8x4 pixels");
    explain({"--explain-region", "0,0,0,1", "-o", page}, "expected 1 to 4096 pixels");
    const auto frame = [&](const std::string& text, const std::string& why) {
        refused({"explain", path, "--frame", text, "--pixel", "0,0"}, why);
    };
    frame("2", "--frame 2: " + path + " ends before frame 2");
    frame("90", "--frame 90: " + path + " ends before frame 2");
    for (const std::string text : {"-1", "1x", "99999999999999999999"})
        frame(text, "--frame " + text + ": expected a frame's number, counted from 0");
    // No fragment reads a texture: that there will be no picture hides no wrong path.
    const std::string in_a_device = "/dev/null/picture.png";
    explain({"--pixel", "0,0", "--footprint", in_a_device}, in_a_device + ": cannot be written");
    explain({"--pixel", "0,0", "--footprint", "/"}, "--footprint /: is a folder");
    for (const std::string option : {"--footprint", "--output", "--set"})
        explain({"--pixel", "0,0", option, ""}, option + ": expected a value");
    for (const std::string wrong : {"gpu.texture_filter=", "gpu.texture_filter", "=3"})
        explain({"--pixel", "0,0", "--set", wrong}, "--set " + wrong + ": expected NAME=VALUE");
    refused({"explain", path, "--pixel", "0,0"}, "--frame is required");
}

TEST_CASE("ffgpu explain names the calls of a trace, from the upper or the lower left") {
    const TemporaryFile trace(trace::in_snappy(clears(2, true))), out("", ".txt"),
        page("", ".html");
    const std::vector<std::string> frame{"explain", trace.path(), "--frame", "1"};
    const auto explain = [&](std::vector<std::string> more) {
        more.insert(more.begin(), frame.begin(), frame.end());
        return run(more);
    };
    REQUIRE(explain({"--pixel", "0,3", "-o", out.path()}) == 0);
    const std::string text = content(out.path());
    CHECK_THAT(text, Contains("(255, 255, 255, 255)"));
    CHECK_THAT(text, Contains("clear, call"));
    CHECK_THAT(text, Contains("glClear"));
    REQUIRE(explain({"--pixel", "0,0", "--lower-left", "-o", out.path()}) == 0);
    CHECK(content(out.path()) == text);
    REQUIRE(explain({"--pixel", "0,0", "--json", "-o", out.path()}) == 0);
    const auto json = nlohmann::json::parse(content(out.path()));
    CHECK(json["calls"] == true);
    CHECK(json["value"] == std::vector<int>{0, 255, 0, 255});
    CHECK(json["events"].back()["call"]["name"] == "glClear");
    REQUIRE(explain({"--explain-region", "0,0,8,4", "-o", page.path()}) == 0);
    CHECK_THAT(content(page.path()), Contains("8x4 pixels"));
}

} // namespace
} // namespace ffgpu::tools
