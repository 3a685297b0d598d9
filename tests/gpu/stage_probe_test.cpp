// The stage probe hands out what a calculation by hand gives for each stage.

#include "tests/gpu/pixel_probe.h"
#include "tests/gpu/scene.h"

#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// Window-filling, w = 1 on the left and 2 on the right, red and s from 0 to 1.
std::vector<Vertex> receding_quad() {
    return {{-1, -1, -0.5f, 1, 1, 0.5f, 0, 0.5f, 0, 0.5f},
            {2, -2, -1, 2, 1, 0.5f, 0, 0.5f, 1, 0.5f},
            {2, 2, -1, 2, 1, 0.5f, 0, 0.5f, 1, 0.5f},
            {-1, 1, -0.5f, 1, 1, 0.5f, 0, 0.5f, 0, 0.5f}};
}

void set_every_stage(Registers& r) {
    r.combiners[0].rgb.op = r.combiners[0].alpha.op = CombineOp::Modulate;
    r.combiners[0].rgb.arguments[1] = {CombineSource::Previous, CombineOperand::Color};
    r.combiners[0].alpha.arguments[1] = {CombineSource::Previous, CombineOperand::Alpha};
    r.fragment.color_sum = true;
    r.current.values[static_cast<unsigned>(Attribute::SecondaryColor)] = {0.25f, 0, 0.5f, 1};
    r.fog = {.mode = FogMode::Linear,
             .source = FogCoordinateSource::Attribute,
             .color = 10 | 20 << 8 | 30 << 16,
             .start = 0,
             .end = 1};
    r.current.values[static_cast<unsigned>(Attribute::FogCoordinate)] = {0.25f, 0, 0, 1};
    r.fragment.alpha_test = true;
    r.fragment.alpha_compare = Compare::Greater;
    r.fragment.alpha_reference = 100;
    r.stencil.enable = true;
    r.stencil.front.depth_pass = r.stencil.back.depth_pass = StencilOp::Increment;
    r.depth = {.test_enable = true, .write_enable = true};
    r.blend = {.enable = true,
               .rgb_source = BlendFactor::SourceAlpha,
               .rgb_destination = BlendFactor::OneMinusSourceAlpha,
               .alpha_source = BlendFactor::SourceAlpha,
               .alpha_destination = BlendFactor::OneMinusSourceAlpha,
               .write_mask = 0b1011};
}

// Two rows of two texels.
const std::vector<std::uint32_t> Texels{0xff00ff00, 0xff00ffff, 0xff00ff64, 0xff00ffc8};

} // namespace

TEST_CASE("the probe tells each stage's values of a fragment as calculated by hand") {
    // Pixel (9, 5) of 16 x 16: u = 9.5/16, 1/w = 1 - u/2, s = (u/2) w; its left neighbour 8.5/16.
    const double u = 9.5 / 16, left = 8.5 / 16;
    const double s = u / 2 / (1 - u / 2), s_left = left / 2 / (1 - left / 2);
    const Stages& stages = *GENERATE(&FastStages, &ReferenceStages);
    Scene scene(16, 16, {.threads = 2, .stages = &stages});
    scene.clear(0xff402000);
    scene.texture(2, Texels);
    scene.registers.samplers[0].magnify_linear = true;
    scene.registers.samplers[0].wrap = {Wrap::ClampToEdge, Wrap::ClampToEdge, Wrap::ClampToEdge};
    set_every_stage(scene.registers);
    PixelProbe told(9, 5);
    scene.gpu.set_stage_probe(&told);
    scene.gpu.number_from(7, 0);
    scene.draw(PrimitiveType::Quads, receding_quad());
    scene.gpu.finish();

    CHECK(told.order == std::vector<std::string>{"coverage",
                                                 "depth",
                                                 "perspective",
                                                 "colors",
                                                 "tex_coords",
                                                 "sampling",
                                                 "environment",
                                                 "color_sum",
                                                 "fog",
                                                 "alpha_test",
                                                 "stencil_depth",
                                                 "color_write"});
    CHECK(told.records == 2); // two triangles
    CHECK(told.empty == 0);
    CHECK(told.inside_disagrees == 0);
    CHECK(told.frame == 7);
    CHECK(told.key.draw == 0);
    CHECK(told.key.primitive == told.record_key);
    CHECK((told.key.sequence >> 4 & 0x1fff) == 9 / 2);
    CHECK((told.key.sequence >> 2 & 3) == 3); // the lane in its quad
    CHECK(told.depth_value == 4194304);       // 1/4 of 2^24 - 1, to nearest

    CHECK(told.inverse_w_left / told.inverse_w == Approx((1 - left / 2) / (1 - u / 2)));
    CHECK(told.w * told.inverse_w == Approx(1));
    CHECK(told.fog_coordinate == Approx(0.25));
    CHECK(told.fog_over_w * told.w == Approx(told.fog_coordinate));
    for (unsigned i = 0; i < 4; ++i)
        CHECK(told.primary_over_w[i] * told.w == Approx(255 * std::array{1., 0.5, 0., 0.5}[i]));
    for (unsigned i = 0; i < 3; ++i)
        CHECK(told.secondary_over_w[i] * told.w == Approx(255 * std::array{0.25, 0., 0.5}[i]));
    CHECK(told.primary == Color{255, 128, 0, 128});
    CHECK(told.secondary == Color{64, 0, 128, 0});
    CHECK(told.s == Approx(s));
    CHECK(told.t == Approx(0.5));
    CHECK(told.s_over_w * told.w == Approx(told.s));

    CHECK(told.levels.step_x[0] == Approx(s - s_left).epsilon(1e-4));
    CHECK(told.levels.step_x[1] == Approx(0).margin(1e-6));
    CHECK(told.levels.footprint_x == Approx(4 * (s - s_left) * (s - s_left)).epsilon(1e-3));
    CHECK(std::abs(told.levels.lambda - 256 * std::log2(2 * (s - s_left))) < 3);
    CHECK(told.levels.probes == 1);
    CHECK(told.levels.level == 0);
    CHECK(told.levels.linear);
    CHECK(told.probe.coordinates[0] == Approx(s));
    // 512 s = 216.2: texels 0 and 1 with 216 - 128 = 88; t in the middle of both rows.
    CHECK(told.filter.weight[0] == 88);
    CHECK(told.filter.weight[1] == 128);
    CHECK(told.filter.access.level == 0);
    REQUIRE(told.filter.texel_count == 4);
    for (unsigned i = 0; i < 4; ++i) {
        const probed::Texel& texel = told.filter.texels[i];
        CHECK(texel.x == i % 2);
        CHECK(texel.y == i / 2);
        CHECK(texel.layer == 0);
        CHECK(texel.bytes == 4);
        CHECK(std::memcmp(texel.stored.data(), &Texels[i], 4) == 0);
        CHECK(texel.color == unpacked(Texels[i]));
    }
    // (0 * 168 + 255 * 88 + 128) / 256, (100 * 168 + 200 * 88 + 128) / 256, and their middle.
    CHECK(told.filter.along_x[0] == Color{88, 255, 0, 255});
    CHECK(told.filter.along_x[1] == Color{134, 255, 0, 255});
    CHECK(told.filter.along_y[0] == Color{111, 255, 0, 255});
    CHECK(told.filter.color == told.filter.along_y[0]);
    CHECK(told.probe.color == told.filter.color);
    CHECK(told.sampled == told.filter.color);

    CHECK(told.previous == told.primary);
    CHECK(told.combined == Color{111, 128, 0, 128});
    CHECK(told.summed == Color{175, 128, 128, 128});
    CHECK(told.fog_factor == 191);                   // 3/4 of 255
    CHECK(told.fogged == Color{134, 101, 103, 128}); // (191 c + 64 fog) / 255
    CHECK(told.before_alpha);
    CHECK(told.after_alpha);
    CHECK_FALSE(told.early);
    CHECK(told.passed_stencil);
    CHECK(told.passed_depth);
    CHECK(told.stored_depth == 0xffffff);
    CHECK(told.new_depth == 4194304);
    CHECK(told.stored_stencil == 0);
    CHECK(told.new_stencil == 1);
    CHECK(told.source == told.fogged);
    CHECK(told.destination == Color{0, 32, 64, 255});
    CHECK(told.blended == Color{67, 67, 84, 191}); // (128 s + 127 d) / 255
    CHECK(told.stored == Color{67, 67, 64, 191});  // Blue is masked.
    CHECK(told.writes == 1);
    CHECK(unpacked(scene.pixel(9, 5)) == told.stored);
}

TEST_CASE("the probe tells edges, the early test, and where a fragment ends") {
    Scene scene(16, 16);
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0);
    scene.draw(PrimitiveType::Triangles,
               {{-1, -1, -1, 1, 1, 1, 1, 1, 0, 0},
                {1, -1, -1, 1, 1, 1, 1, 1, 0, 0},
                {-1, 1, -1, 1, 1, 1, 1, 1, 0, 0}});
    PixelProbe told(3, 5);
    scene.gpu.set_stage_probe(&told);
    scene.draw(PrimitiveType::Triangles,
               {{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                {1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                {-1, 1, 0, 1, 1, 1, 1, 1, 0, 0}});
    scene.gpu.finish();
    CHECK(told.order == std::vector<std::string>{"coverage", "depth", "stencil_depth"});
    CHECK(told.first_vertex.x == 0);
    CHECK(told.key.draw == 1);
    // a X + b Y + floor((E(0, 0) - t) / 256) with sides of 4096: the lower and the left one own
    // their boundary; the slanted one, E(0, 0) = 2^24 - 2^20, does not.
    std::multiset<std::int64_t> edges(told.edges.begin(), told.edges.begin() + 3);
    CHECK(edges == std::multiset<std::int64_t>{
                       4096 * 3 + 2048, 4096 * 5 + 2048, (1 << 16) - 4096 - 1 - 4096 * 8});
    CHECK(told.edges[3] == 0);
    CHECK(told.inside_disagrees == 0);
    CHECK(told.early);
    CHECK_FALSE(told.passed_depth);
    CHECK(told.stored_depth == 0);
    CHECK(told.new_depth == 0);
}

TEST_CASE("the probe tells area coverage and its product with alpha") {
    Scene scene(16, 16);
    scene.registers.primitive.polygon_smooth = true;
    scene.clear(0);
    PixelProbe told(8, 5);
    scene.gpu.set_stage_probe(&told);
    // Up to x = 8.25: a quarter of the column's pixels.
    const float right = 8.25f / 8 - 1;
    scene.draw(PrimitiveType::Triangles,
               {{-1, 0, 0, 1, 1, 1, 1, 0.8f, 0, 0},
                {right, -1, 0, 1, 1, 1, 1, 0.8f, 0, 0},
                {right, 1, 0, 1, 1, 1, 1, 0.8f, 0, 0}});
    scene.gpu.finish();
    CHECK(told.order == std::vector<std::string>{"coverage", "colors", "antialias", "color_write"});
    CHECK(told.covered == 64);       // 255 / 4
    CHECK(told.alpha_before == 204); // 255 * 0.8
    CHECK(told.alpha_after == 51);   // 204 * 64 / 255
}

TEST_CASE("the probe tells samples before and behind the sample mask, and each sample's write") {
    Scene scene(16, 16);
    scene.registers.targets.color[0].samples = scene.registers.targets.depth.samples = MaxSamples;
    scene.registers.multisample.enable = true;
    scene.registers.multisample.sample_mask = 0b0110;
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0);
    PixelProbe told(8, 5);
    scene.gpu.set_stage_probe(&told);
    // Up to the middle of the column: the samples left of it are 0 and 2 (-32 and -96 of 256).
    const float right = 8.5f / 8 - 1;
    scene.draw(PrimitiveType::Quads,
               {{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                {right, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                {right, 1, 0, 1, 1, 1, 1, 1, 0, 0},
                {-1, 1, 0, 1, 1, 1, 1, 1, 0, 0}});
    scene.gpu.finish();
    CHECK(told.samples_before == 0b0101);
    CHECK(told.samples_after == 0b0100);
    CHECK(told.writes == 1);
}
