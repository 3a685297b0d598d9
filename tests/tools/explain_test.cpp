// Histories of pixels of frames made by hand: what is listed, and its values, as calculated by
// hand.

#include "tests/tools/explain_scene.h"
#include "tools/explain/history_json.h"
#include "tools/explain/history_text.h"

#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Contains;
using Kind = PixelEvent::Kind;

constexpr std::array<float, 4> Red{1, 0, 0, 1}, HalfGreen{0, 1, 0, 128 / 255.0f};
constexpr std::uint32_t RedWord = 0xff0000ff, Blue = 0xffff0000;

std::vector<Kind> kinds(const PixelHistory& history) {
    std::vector<Kind> all;
    for (const PixelEvent& event : history.events)
        all.push_back(event.kind);
    return all;
}

void blend_by_alpha(Registers& registers) {
    registers.blend.enable = true;
    registers.blend.rgb_source = registers.blend.alpha_source = BlendFactor::SourceAlpha;
    registers.blend.rgb_destination = registers.blend.alpha_destination =
        BlendFactor::OneMinusSourceAlpha;
}

TEST_CASE("a history is a pixel's clears and fragments in order, each with the value after it") {
    ExplainScene scene;
    scene.clear(Blue);
    scene.fill(Red);
    blend_by_alpha(scene.registers);
    scene.fill(HalfGreen);
    const PixelHistory history = scene.history(9, 10); // window pixel (9, 5)
    CHECK(kinds(history) == std::vector<Kind>{Kind::Clear, Kind::Fragment, Kind::Fragment});
    CHECK(history.before[0].color[0] == 0);
    CHECK(history.events[0].after.color[0] == Blue);
    CHECK(history.events[0].depth_after == 0xffffffu);
    CHECK(history.events[0].stencil_after == 0u);
    CHECK(history.events[1].after.color[0] == RedWord);
    // 128/255 of green over red; alpha (128 128 + 127 255) / 255 = 191.25.
    CHECK(history.events[2].after.color[0] == (127u | 128u << 8 | 191u << 24));
    CHECK(history.value == history.events[2].after.color[0]);

    const FragmentNote& first = *history.events[1].fragment;
    const FragmentNote& second = *history.events[2].fragment;
    CHECK(first.key.draw == 0);
    CHECK(second.key.draw == 1);
    CHECK((first.x == 9 && first.y == 5));
    CHECK(first.key.sequence == (2u << 17 | 4u << 4 | 3u << 2)); // quad row 2, column 4, lane 3
    CHECK(second.writes.size() == 1);
    CHECK(second.writes[0].destination == RedWord);
    CHECK(second.writes[0].source == Rgba{0, 255, 0, 128});
    // Corners (0, 0), (32, 0) and (0, 32): the centre (9.5, 5.5) in shares of 32.
    CHECK(first.primitive->weights(9, 5) == std::vector<double>{17 / 32.0, 9.5 / 32, 5.5 / 32});
    CHECK(first.primitive->vertices[1].x == 32 * 256);
    // Twice the areas over each side in pixels, 32 long, and in 1/256 pixel of distance.
    CHECK(first.edges ==
          std::vector<std::int64_t>{8192 * 5 + 4096, 8192 * 17 - 1, 8192 * 9 + 4096});
}

TEST_CASE("weights with perspective are those by area over w") {
    PrimitiveNote primitive{PrimitiveShape::Triangle, true, std::vector<WindowVertex>(3)};
    primitive.vertices[1].x = primitive.vertices[2].y = 4 * 256;
    primitive.vertices[1].inverse_w = 0.5f;
    // At (1.5, 0.5): shares 1/2, 3/8, 1/8; over w 1/2, 3/16, 1/8 of 13/16.
    CHECK(primitive.weights(1, 0) == std::vector<double>{0.5, 0.375, 0.125});
    const std::vector<double> shares = primitive.perspective_weights(1, 0);
    CHECK(shares[0] == Approx(8 / 13.0));
    CHECK(shares[1] == Approx(3 / 13.0));
    CHECK(shares[2] == Approx(2 / 13.0));
    primitive.shape = PrimitiveShape::Line;
    CHECK(primitive.weights(1, 0).empty());
}

TEST_CASE("a fragment of a clipped triangle is told with the piece that it is of") {
    ExplainScene scene;
    // The near plane cuts one corner off: what is left has four corners and is drawn in two pieces.
    const auto vertex = [](float x, float y, float z) {
        return test::Vertex{x, y, z, 1, 1, 0, 0, 1, 0, 0};
    };
    scene.draw({vertex(-1, -1, -3), vertex(3, -1, 1), vertex(-1, 3, 1)});
    std::vector<std::pair<unsigned, unsigned>> pixels;
    for (unsigned i = 0; i < ExplainScene::Side * ExplainScene::Side; ++i)
        pixels.emplace_back(i % ExplainScene::Side, i / ExplainScene::Side);
    std::set<unsigned> pieces;
    for (const PixelHistory& history : scene.histories(pixels))
        for (const PixelEvent& event : history.events) {
            CHECK(event.piece == event.fragment->piece);
            pieces.insert(event.piece);
        }
    CHECK(pieces == std::set<unsigned>{0, 1});
}

TEST_CASE("a fragment that ends early is listed with the test's both sides") {
    ExplainScene scene;
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(Blue);
    scene.fill(Red, -1);
    scene.fill(HalfGreen, 1);
    scene.registers.fragment = {
        .alpha_test = true, .alpha_compare = Compare::Greater, .alpha_reference = 128};
    scene.fill(HalfGreen, -1); // Alpha 128 is not above 128.
    scene.registers.fragment.alpha_reference = 127;
    scene.fill(HalfGreen, 1); // Depth is tested late now.
    const PixelHistory history = scene.history(0, 0);
    REQUIRE(kinds(history) ==
            std::vector<Kind>{
                Kind::Clear, Kind::Fragment, Kind::Fragment, Kind::Fragment, Kind::Fragment});
    const auto note = [&](std::size_t i) -> const FragmentNote& {
        return *history.events[i].fragment;
    };
    CHECK(note(1).end == FragmentEnd::Written);
    CHECK(note(1).visits[0].stored_depth == 0xffffff);
    CHECK(note(1).visits[0].depth == 0);
    CHECK(note(1).visits[0].new_depth == 0);
    CHECK(note(2).end == FragmentEnd::EarlyDepth);
    CHECK(note(2).visits[0].depth == 0xffffff);
    CHECK(note(2).visits[0].stored_depth == 0);
    CHECK_FALSE(note(2).has_colors); // Nobody asked for its colour any more.
    CHECK(note(3).end == FragmentEnd::Alpha);
    CHECK(note(3).alpha == 128);
    CHECK(note(3).visits.empty());
    CHECK(note(4).end == FragmentEnd::Depth);
    CHECK(*note(4).alpha_passed);
    CHECK_FALSE(note(4).visits[0].early);
    for (std::size_t i = 1; i < 5; ++i)
        CHECK(history.events[i].after.color[0] == RedWord);
}

TEST_CASE("the stencil test is told with what is stored and what it becomes") {
    ExplainScene scene;
    scene.clear(Blue);
    scene.registers.stencil.enable = true;
    StencilFace& face = scene.registers.stencil.front;
    face = {.compare = Compare::Equal, .fail = StencilOp::Increment, .reference = 1};
    scene.registers.stencil.back = face;
    scene.fill(Red); // 1 == 0 fails, 0 becomes 1.
    scene.fill(HalfGreen);
    const PixelHistory history = scene.history(3, 3);
    REQUIRE(history.events.size() == 3);
    const DepthVisit& failed = history.events[1].fragment->visits.at(0);
    CHECK_FALSE(failed.passed_stencil);
    CHECK((failed.stored_stencil == 0 && failed.new_stencil == 1));
    CHECK(history.events[1].fragment->end == FragmentEnd::Stencil);
    const DepthVisit& passed = history.events[2].fragment->visits.at(0);
    CHECK(passed.passed_stencil);
    CHECK((passed.stored_stencil == 1 && passed.new_stencil == 1));
    CHECK(history.events[2].fragment->end == FragmentEnd::Written);
}

TEST_CASE("what the scissor keeps from a pixel is listed and changes nothing") {
    ExplainScene scene;
    scene.clear(Blue);
    scene.registers.scissor = {0, 0, 8, 16};
    scene.clear(RedWord);
    scene.fill(Red);
    const PixelHistory outside = scene.history(8, 4), inside = scene.history(7, 4);
    CHECK(kinds(outside) == std::vector<Kind>{Kind::Clear, Kind::Clear, Kind::Scissor});
    CHECK(outside.events[1].outside_scissor);
    CHECK(outside.value == Blue);
    CHECK(outside.events[2].after.color[0] == Blue);
    CHECK(kinds(inside) == std::vector<Kind>{Kind::Clear, Kind::Clear, Kind::Fragment});
    CHECK_FALSE(inside.events[1].outside_scissor);
    CHECK(inside.value == RedWord);
}

TEST_CASE("what a stipple takes out is listed and changes nothing") {
    ExplainScene scene;
    scene.clear(Blue);
    scene.registers.primitive.polygon_stipple = true;
    // Of rows 0 mod 4 the pixels 0 mod 8 are kept, of the others none.
    for (std::size_t row = 0; row < 32; ++row)
        scene.registers.polygon_stipple.rows[row] = row % 4 == 0 ? 0x80808080 : 0;
    scene.fill(Red);
    // Window rows count from below: picture row 11 is window row 4.
    const PixelHistory kept = scene.history(8, 11), hole = scene.history(9, 11),
                       other = scene.history(8, 10);
    CHECK(kinds(kept) == std::vector<Kind>{Kind::Clear, Kind::Fragment});
    CHECK(kept.value == RedWord);
    for (const PixelHistory* const history : {&hole, &other}) {
        CHECK(kinds(*history) == std::vector<Kind>{Kind::Clear, Kind::Stipple});
        CHECK(history->events[1].after.color[0] == Blue);
        CHECK(history->value == Blue);
        CHECK_THAT(history_text(*history), Contains("2. taken out by the stipple, draw 0"));
        CHECK(history_json(*history)["events"][1]["event"] == "taken out by the stipple");
    }
    // Where the primitive is not, nothing is taken out.
    scene.draw({{-1, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                {-0.5f, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                {-1, -0.5f, 0, 1, 1, 0, 0, 1, 0, 0}});
    CHECK(kinds(scene.history(9, 11)).size() == 2);
    CHECK(kinds(scene.history(1, 15)).back() == Kind::Stipple);
}

TEST_CASE("of a mean of pictures each picture's fragments are told") {
    ExplainScene scene;
    scene.clear(Blue);
    Surface picture = scene.color;
    picture.address = test::TextureAt;
    scene.registers.targets.depth = {};
    for (unsigned i = 0; i < 4; ++i) {
        scene.registers.targets.color[0] = picture.plane(i);
        scene.clear(0xff000000);
        if (i % 2 == 0) scene.fill(Red);
    }
    scene.command(CopyRectangleCommand{
        .source = picture, .destination = scene.color, .width = 16, .height = 16, .pictures = 4});
    const PixelHistory history = scene.history(3, 3);
    REQUIRE(history.places.size() == 5);
    CHECK(history.places[3].picture == 2);
    CHECK(history.places[3].color.surface == picture.plane(2));
    CHECK(kinds(history) == std::vector<Kind>{Kind::Clear,
                                              Kind::Clear,
                                              Kind::Fragment,
                                              Kind::Clear,
                                              Kind::Clear,
                                              Kind::Fragment,
                                              Kind::Clear,
                                              Kind::Copy});
    CHECK(history.events[5].place == 3);
    CHECK(history.events[7].pictures == 4);
    CHECK(history.value == 0xff000080); // (255 + 0 + 255 + 0) / 4, halves up
    CHECK_THAT(history_text(history), Contains("copied from as picture 2 of 4"));
    CHECK_THAT(history_text(history), Contains("the mean of 4 pictures, the first of them"));
}

TEST_CASE("drawn images, uploads and copies are listed with the value after them") {
    ExplainScene scene;
    scene.clear(Blue);
    const std::vector<std::uint32_t> image{0xff010101, 0xff020202, 0xff030303, 0xff040404};
    scene.upload(test::TextureAt, test::bytes_of(image));
    scene.command(DrawImageCommand{
        .address = test::TextureAt, .stride = 8, .width = 2, .height = 2, .x = 4, .y = 4});
    const std::vector<std::uint32_t> pixel{0xff112233};
    scene.upload(test::ColorAt + 4 * 16 * 5 + 4 * 5, test::bytes_of(pixel));
    // To the picture: (5, 5) becomes (2, 1).
    scene.picture.address = 0x500000;
    scene.command(CopyRectangleCommand{.source = scene.color,
                                       .destination = scene.picture,
                                       .source_x = 4,
                                       .source_y = 4,
                                       .destination_x = 1,
                                       .width = 2,
                                       .height = 2});
    scene.fill({0, 0, 0, 1}); // of the back buffer: too late
    const PixelHistory history = scene.history(2, 14);
    REQUIRE(history.places.size() == 2);
    CHECK((history.places[1].color.x == 5 && history.places[1].color.y == 5));
    CHECK(kinds(history) ==
          std::vector<Kind>{Kind::Clear, Kind::Fragment, Kind::Upload, Kind::Copy});
    CHECK(history.events[1].fragment->image);
    CHECK(history.events[1].fragment->primary == Rgba{4, 4, 4, 255});
    CHECK(history.events[1].after.color[0] == 0xff040404);
    CHECK(history.events[2].after.color[0] == 0xff112233);
    CHECK((history.events[2].place == 1 && history.events[3].place == 0));
    CHECK(history.value == 0xff112233);
    // Beside the copied rectangle the picture has nothing.
    CHECK(scene.history(3, 14).events.empty());
}

TEST_CASE("an image of stencil values is listed with the value that it leaves") {
    ExplainScene scene;
    scene.clear(Blue);
    const std::vector<std::uint8_t> values{5, 6, 7, 8};
    scene.upload(test::TextureAt, test::bytes_of(values));
    scene.command(DrawImageCommand{.format = Format::Stencil8,
                                   .address = test::TextureAt,
                                   .stride = 2,
                                   .width = 2,
                                   .height = 2});
    const PixelHistory history = scene.history(1, 14);
    REQUIRE(kinds(history) == std::vector<Kind>{Kind::Clear, Kind::StencilImage});
    CHECK(history.events[1].stencil_after == 8u);
    CHECK(history.value == Blue);
    CHECK(scene.history(2, 14).events.size() == 1);
}

TEST_CASE("of a multisampled pixel each sample is told, and the copy that resolves them") {
    ExplainScene scene;
    Surface samples = scene.color;
    samples.address = 0x600000;
    samples.samples = 4;
    Surface depths = scene.depth;
    depths.address = 0x700000;
    depths.samples = 4;
    scene.registers.targets.color[0] = samples;
    scene.registers.targets.depth = depths;
    scene.registers.multisample.enable = true;
    scene.clear(0xff000000);
    // Left of x = 9.5: of pixel (9, y) the samples at -2/16 and -6/16, the first and the third.
    const float edge = 9.5f / 8 - 1;
    scene.draw({{-9, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                {edge, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                {edge, 19, 0, 1, 1, 0, 0, 1, 0, 0}});
    scene.command(CopyRectangleCommand{
        .source = samples, .destination = scene.color, .width = 16, .height = 16});
    const PixelHistory history = scene.history(9, 10);
    REQUIRE(history.places.size() == 2);
    REQUIRE(kinds(history) == std::vector<Kind>{Kind::Clear, Kind::Fragment, Kind::Copy});
    const FragmentNote& note = *history.events[1].fragment;
    CHECK(note.samples_covered == 0b0101);
    REQUIRE(note.writes.size() == 2);
    CHECK((note.writes[0].sample == 0 && note.writes[1].sample == 2));
    CHECK(history.events[1].after.samples == 4);
    CHECK(history.events[1].after.color ==
          std::array<std::uint32_t, 4>{RedWord, 0xff000000, RedWord, 0xff000000});
    CHECK(history.value == 0xff000080); // 127.5, halves up
}

TEST_CASE("depths and values are told of fragments that write no colour") {
    ExplainScene scene;
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(Blue);
    scene.registers.blend.write_mask = 0;
    scene.fill(Red, -1);
    scene.registers.targets.color[0] = {};
    scene.fill(Red, -1); // Only depths: 0 < 0 fails.
    const PixelHistory history = scene.history(0, 15);
    REQUIRE(history.events.size() == 3);
    CHECK(history.events[1].fragment->end == FragmentEnd::Written);
    CHECK(history.events[1].fragment->writes.empty());
    CHECK(history.events[2].fragment->end == FragmentEnd::EarlyDepth);
    CHECK(history.value == Blue);
}

TEST_CASE("what came before the frame is where the history begins, and no part of it") {
    ExplainScene scene([](ExplainScene& before) {
        before.clear(RedWord);
        before.fill(Red);
    });
    blend_by_alpha(scene.registers);
    scene.fill(HalfGreen);
    const PixelHistory history = scene.history(4, 4);
    CHECK(history.before[0].color[0] == RedWord);
    REQUIRE(history.events.size() == 1);
    CHECK(history.events[0].draw == 1); // Draws count from the start.
    CHECK(history.value == (127u | 128u << 8 | 191u << 24));
}

} // namespace
} // namespace ffgpu::tools
