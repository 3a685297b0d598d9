// The fragment pipe in RTL against the model: target bytes after every draw, with memories of any
// latency that stall at random; draws behind each other in the pipe; what is left to the model.

#include "tests/gpu/busy_scene.h"
#include "tests/rtl_pipe/close_draws.h"
#include "tests/tools/tool.h"

namespace ffgpu::tools {
namespace {

using Catch::Contains;

TEST_CASE("The pipe draws a busy scene as the model does, however memory answers") {
    for (const rtl::PipeOptions& options : Memories) {
        PipeComparison comparison(options);
        test::Scene scene(32, 24);
        comparison.attach(scene.gpu, scene.gpu);
        scene.into = &comparison;
        test::draw_mixture(scene, [&](int draw) {
            INFO(comparison.summary());
            REQUIRE(comparison.equal()); // A faulty pipe may take long for each draw.
            return test::vary_busily(scene.registers, draw);
        });
        INFO(comparison.summary());
        CHECK(comparison.equal());
        CHECK(comparison.fragments().at("") > 5000);
        // What it leaves to the model is named.
        CHECK(comparison.fragments().at("smooth primitives") > 100);
        CHECK(comparison.fragments().at("cube maps") > 100);
    }
}

TEST_CASE("The pipe draws random states as the model does") {
    constexpr std::array Depths{Format::Depth24Stencil8, Format::Depth16, Format::None};
    for (unsigned seed = 0; seed < 6; ++seed) {
        PipeComparison comparison(Memories[seed % Memories.size()]);
        test::Scene scene(40, 36);
        comparison.attach(scene.gpu, scene.gpu);
        scene.into = &comparison;
        test::RandomStates random(seed);
        Targets& targets = scene.registers.targets;
        targets.depth.format = Depths[seed % 3];
        targets.color[0].format = static_cast<Format>(1 + (seed * 4 + 3) % 9);
        space_rows(targets.color[0]);
        space_rows(targets.depth);
        prepare(scene);
        for (unsigned draw = 0; draw < 25; ++draw) {
            random.vary(scene.registers, textured_units(random));
            // Textures change, too.
            const std::array<std::uint32_t, 64> texels{random.bits(), random.bits()};
            scene.into->write_memory(test::TextureAt, std::as_bytes(std::span(texels)));
            scene.draw(random.chance(6) ? PrimitiveType::Lines : PrimitiveType::Triangles,
                       triangles(random, 4));
            INFO("seed " << seed << ", " << told(comparison, draw));
            REQUIRE(comparison.equal());
        }
        CHECK(comparison.fragments().at("") > 2000);
    }
}

// Draws close behind each other, two at a time inside: each is under registers of its own.
TEST_CASE("Draws follow each other through the pipe without a gap") {
    for (const rtl::PipeOptions& options : Memories) {
        CloseDraws draws(options);
        for (int draw = 0; draw < 60; ++draw)
            draws.draw();
        // As fast as targets are slow: quads of two draws stand in the queues before them.
        for (int draw = 0; draw < 300; ++draw)
            draws.draw_textured(0);
        const TargetDifference difference = draws.difference();
        INFO(target_text(difference));
        CHECK(difference.target.empty());
    }
}

// Who waits for the pipe would wait too long, or not long enough: no picture tells.
TEST_CASE("A pipe that has ended its draws stays idle") {
    CloseDraws draws(Memories[0]);
    for (int draw = 0; draw < 8; ++draw)
        draws.draw();
    CHECK(draws.difference().target.empty());
    const std::uint64_t ended = draws.pipe().cycles();
    for (int time = 0; time < 4; ++time)
        draws.pipe().forget_textures(); // two cycles, behind the wait
    CHECK(draws.pipe().finish());
    CHECK(draws.pipe().cycles() == ended + 8);
}

// Quads, requests, stores and textures' banks of before are gone: nothing of them comes out later.
TEST_CASE("A reset in mid-stream leaves nothing behind in the pipe") {
    for (const rtl::PipeOptions& options : Memories) {
        CloseDraws draws(options);
        for (std::size_t turn = 0; turn < 12; ++turn) {
            draws.draw();
            draws.draw(turn % 3);
            draws.reset();
            draws.equalize();
            draws.draw();
            draws.draw();
            const TargetDifference difference = draws.difference();
            INFO("turn " << turn << "\n" << target_text(difference));
            CHECK(difference.target.empty());
        }
    }
}

// A quad waits for the one before it, wherever that stands between its read and its store.
TEST_CASE("Quads of one place see what was stored before them") {
    for (const rtl::PipeOptions& options : Memories) {
        PipeComparison comparison(options);
        test::Scene scene(64, 8);
        comparison.attach(scene.gpu, scene.gpu);
        scene.into = &comparison;
        scene.clear(0);
        scene.registers.blend.enable = true;
        scene.registers.blend.rgb_destination = BlendFactor::One;
        scene.registers.stencil.enable = true;
        scene.registers.stencil.front.depth_pass = StencilOp::IncrementWrap;
        std::vector<test::Vertex> vertices;
        constexpr float Step = 2.0f / 255; // of two levels, 48 times
        // Rows of 1 to 12 quads, four of each: a place comes again behind so many others.
        for (unsigned i = 0; i < 48; ++i) {
            const float right = -1 + static_cast<float>(1 + i / 4) / 12;
            for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {right, -1.0f}, {-1.0f, -0.5f}})
                vertices.push_back({x, y, 0, 1, Step, Step, Step, Step, 0, 0});
        }
        scene.draw(PrimitiveType::Triangles, vertices);
        INFO(comparison.summary());
        CHECK(comparison.equal());
        CHECK(scene.pixel(0, 0) == 0x02606060);
    }
}

TEST_CASE("A byte that the pipe stores wrong is told with draw, place and both values") {
    PipeComparison comparison({.faulty_store = 0});
    test::Scene scene(8, 8);
    comparison.attach(scene.gpu, scene.gpu);
    comparison.number_draws_from(7);
    scene.into = &comparison;
    scene.clear(0);
    // Draws that give no fragments count as well.
    DrawCommand feedback;
    feedback.output = DrawOutput::Feedback;
    feedback.feedback_address = test::VerticesAt;
    feedback.feedback_bytes = 64;
    scene.command(feedback);
    const auto corner = [](float x, float y) { return test::Vertex{x, y, 0, 1, 1, 1, 1, 1, 0, 0}; };
    // The right upper quarter, white.
    scene.draw(PrimitiveType::TriangleFan,
               {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
    REQUIRE_FALSE(comparison.equal());
    const PipeDifference& difference = *comparison.difference();
    CHECK(difference.draw == 8);
    CHECK(difference.target.target == "colour target 0");
    CHECK(difference.target.x == 4);
    CHECK(difference.target.y == 4);
    CHECK(difference.target.expected == 0xffffffff);
    CHECK(difference.target.got == 0xfefefefe);
    CHECK_THAT(comparison.summary(), Contains("rtl: draw 8 is the first that parts"));
}

TEST_CASE("replay --rtl fragment_pipe draws a frame, and says what it compared") {
    int status = -1;
    const std::string text = printed(stderr, [&] {
        status = run({"replay", FFGPU_PIPE_TRACE, "--rtl", "fragment_pipe", "--frames", "0-0"});
    });
    INFO(text);
    CHECK(status == 0);
    CHECK_THAT(text, Contains("target bytes equal to the model's after each"));
    CHECK_THAT(text, Contains("million cycles a second"));
    CHECK_THAT(
        printed(stderr,
                [&] {
                    status = run({"replay", FFGPU_PIPE_TRACE, "--rtl", "fragment_pipe,blend"});
                }),
        Contains("fragment_pipe has all units, and stands alone"));
    CHECK(status == 2);
}

} // namespace
} // namespace ffgpu::tools
