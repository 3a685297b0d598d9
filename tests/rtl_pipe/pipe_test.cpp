// The fragment pipe in RTL against the model: target bytes after every draw, with memories of any
// latency that stall at random; draws behind each other in the pipe; what is left to the model.

#include "tests/gpu/busy_scene.h"
#include "tests/rtl_pipe/random_draws.h"
#include "tests/tools/tool.h"
#include "tools/rtl/pipe_comparison.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Catch::Contains;

constexpr rtl::PipeOptions memory(unsigned latency, unsigned stall_percent, std::uint64_t seed) {
    return {
        .latency = latency, .stall_percent = stall_percent, .seed = seed, .quiet_cycles = 1 << 14};
}

const std::array Memories{memory(1, 0, 1), memory(20, 25, 2), memory(90, 60, 3)};

std::vector<test::Vertex> triangles(test::RandomStates& random, unsigned count) {
    const auto unit = [&] { return static_cast<float>(random.below(65536)) / 32768.0f - 1.0f; };
    const float size = random.chance(3) ? 1.5f : 0.3f;
    const bool flat = random.chance(3);
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < count; ++i) {
        const float x = unit(), y = unit();
        for (int corner = 0; corner < 3; ++corner) {
            const float w = flat ? 1.0f : 1.5f + unit();
            vertices.push_back({(x + size * unit()) * w,
                                (y + size * unit()) * w,
                                unit() * w * 0.7f,
                                w,
                                unit(),
                                unit(),
                                unit(),
                                unit(),
                                unit() * 4,
                                unit() * 4});
        }
    }
    return vertices;
}

// Noise under the textures; coordinates for all units, those of four words divided by q.
void prepare(test::Scene& scene) {
    std::mt19937 random(5);
    std::vector<std::uint32_t> noise(0x40000);
    std::ranges::generate(noise, random);
    scene.into->write_memory(test::TextureAt, std::as_bytes(std::span(noise)));
    auto& elements = scene.registers.vertex_format.elements;
    constexpr std::array<VertexElement, TextureUnits> Coordinates{
        {{2, 8}, {4, 6}, {3, 7}, {4, 4}, {2, 6}, {4, 5}, {3, 5}, {4, 6}}};
    std::ranges::copy(Coordinates, &elements[static_cast<unsigned>(Attribute::TexCoord0)]);
    elements[static_cast<unsigned>(Attribute::SecondaryColor)] = {3, 5};
    elements[static_cast<unsigned>(Attribute::FogCoordinate)] = {1, 8};
    scene.clear(0x80402010);
}

// Rows of an odd number of pairs: in small formats the two of a quad begin at different bytes.
void space_rows(Surface& surface) {
    surface.stride = format_info(surface.format).block_bytes * (surface.width + 2u);
}

// Up to three in most draws, up to all in some.
unsigned textured_units(test::RandomStates& random) {
    return random.chance(4) ? random.below(TextureUnits + 1) : random.below(4);
}

std::string told(const PipeComparison& comparison, unsigned draw) {
    return fmt::format("draw {}\n{}", draw, comparison.summary());
}

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

// Many blocks wide and high, a texel a pixel: none lies where another one does.
TEST_CASE("The pipe finds each texel of images of every format") {
    constexpr std::uint32_t Width = 64, Height = 32;
    PipeComparison comparison(Memories[0]);
    test::Scene scene(Width, Height);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    prepare(scene);
    scene.texture(1, {0}); // its sampler
    const auto corner = [](float x, float y) {
        return test::Vertex{x, y, 0, 1, 1, 1, 1, 1, 0.5f + x / 2, 0.5f + y / 2};
    };
    for (auto format = static_cast<unsigned>(Format::Rgba8);
         format <= static_cast<unsigned>(Format::Depth24Stencil8);
         ++format) {
        INFO(format_info(static_cast<Format>(format)).name);
        scene.clear(0);
        scene.registers.images[0].shape = {
            TextureKind::TwoD, static_cast<Format>(format), Width, Height, 1, 1, 0};
        scene.draw(PrimitiveType::TriangleFan,
                   {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
        INFO(comparison.summary());
        REQUIRE(comparison.equal());
        const std::vector<std::uint32_t> picture = scene.picture();
        CHECK(std::set(picture.begin(), picture.end()).size() > 8);
    }
    CHECK(comparison.fragments() ==
          std::map<std::string, std::uint64_t>{{"", 17 * Width * Height}});
}

// Draws for a pipe without a gap between them, and the model's.
class CloseDraws {
public:
    explicit CloseDraws(const rtl::PipeOptions& options)
        : pipe_(open_rtl_pipe(options)) {
        targets_.fill(model_.registers.targets);
        targets_[1].color[0] = beside(targets_[1].color[0], Format::Rgb565);
        targets_[1].depth = beside(targets_[1].depth, Format::Depth16);
        targets_[2].depth.format = Format::None; // Its quads wait for no pixels between others.
        for (test::Scene* scene : {&model_, &drawn_})
            for (const Targets& targets : targets_) {
                scene->registers.targets = targets;
                prepare(*scene);
            }
        drawn_.gpu.settled_memory(); // The clear is in it.
        pipe_->set_memory(bytes_);
    }

    rtl::Pipe& pipe() { return *pipe_; }

    // The pipe's part of one may be given up after some records.
    void draw(std::size_t most_records = SIZE_MAX) {
        draw_textured(textured_units(random_), most_records);
    }
    void draw_textured(unsigned units, std::size_t most_records = SIZE_MAX) {
        vary(units);
        draw_as_set(triangles(random_, 1 + random_.below(3)), most_records);
    }
    // The registers of the next draw.
    Registers& vary(unsigned units) {
        random_.vary(model_.registers, units);
        model_.registers.targets = targets_[random_.below(3)];
        return model_.registers;
    }
    void draw_as_set(const std::vector<test::Vertex>& vertices,
                     std::size_t most_records = SIZE_MAX) {
        model_.draw(PrimitiveType::Triangles, vertices);
        // Behind everything that a draw reads.
        constexpr DeviceAddress At = test::VerticesAt;
        std::memcpy(bytes_.data() + At, vertices.data(), vertices.size() * sizeof vertices[0]);
        DrawCommand command;
        command.primitive = PrimitiveType::Triangles;
        command.count = command.vertex_count = static_cast<std::uint32_t>(vertices.size());
        command.vertex_address = At;
        records_.make(model_.registers, number_, command);
        pipe_->begin_draw(records_.context(), number_++);
        std::size_t added = 0;
        records_.for_each([&](const SetupRecord& record) {
            if (added++ < most_records) pipe_->add(record);
        });
    }

    // Draws are numbered anew, too: nothing may be known by a number of before.
    void reset() {
        pipe_->reset();
        number_ = 0;
    }

    // What the pipe draws on becomes what the model has.
    void equalize() { std::ranges::copy(model_.gpu.settled_memory(), bytes_.begin()); }

    TargetDifference difference() {
        REQUIRE(pipe_->finish());
        TargetDifference found;
        for (const Targets& targets : targets_)
            if (found.target.empty())
                found = TargetComparison().compare(targets, model_.gpu, drawn_.gpu);
        return found;
    }

private:
    // Another target behind this one, in another format.
    static Surface beside(Surface surface, Format format) {
        surface.address += 0x100000;
        surface.format = format;
        space_rows(surface);
        return surface;
    }

    std::unique_ptr<rtl::Pipe> pipe_;
    test::Scene model_{40, 36}, drawn_{40, 36};
    std::array<Targets, 3> targets_;
    std::span<std::byte> bytes_ = drawn_.gpu.settled_memory();
    PipeRecords records_{bytes_};
    test::RandomStates random_{11};
    std::uint32_t number_ = 0;
};

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

// Of a draw many samples are on their way, sixteen texels each, when the next one's second and
// third unit want the bank that those are under.
TEST_CASE("A bank of the texture unit is another unit's when its last sample has come") {
    for (const rtl::PipeOptions& options : Memories) {
        CloseDraws draws(options);
        for (int turn = 0; turn < 8; ++turn) {
            Registers& registers = draws.vary(1);
            registers.images[0].shape = {TextureKind::ThreeD, Format::Rgba8, 16, 16, 8, 3, 0};
            registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear = true;
            registers.samplers[0].mip_filter = MipFilter::Linear;
            std::vector<test::Vertex> whole;
            for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {3.0f, -1.0f}, {-1.0f, 3.0f}})
                whole.push_back({x, y, 0, 1, 1, 1, 1, 1, 6 * x, 5 * y});
            draws.draw_as_set(whole);
            draws.draw_textured(3);
        }
        const TargetDifference difference = draws.difference();
        INFO(target_text(difference));
        CHECK(difference.target.empty());
    }
}

// The same with a texel a sample, all of a line that has not come: sixty-four samples, of as many
// quads as may wait for theirs.
TEST_CASE("A bank of the texture unit waits for all samples that may be on their way") {
    for (const rtl::PipeOptions& options : {memory(250, 0, 4), memory(250, 30, 5)}) {
        CloseDraws draws(options);
        for (int turn = 0; turn < 24; ++turn) {
            const float at = (static_cast<float>(turn) + 0.5f) / 24;
            std::vector<test::Vertex> whole;
            for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {3.0f, -1.0f}, {-1.0f, 3.0f}})
                whole.push_back({x, y, 0, 1, 1, 1, 1, 1, at, at});
            for (const unsigned units : {1u, 3u}) {
                Registers& registers = draws.vary(units);
                const Scissor all = registers.scissor;
                registers.scissor = {8, 8, 8, 8};
                registers.depth.test_enable = registers.stencil.enable = false;
                registers.fragment.alpha_test = false;
                registers.blend.write_mask = 0xf;
                if (units == 1) {
                    registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 64, 64, 1, 1, 0};
                    registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear =
                        false;
                    registers.samplers[0].mip_filter = MipFilter::None;
                }
                draws.draw_as_set(whole);
                registers.scissor = all;
            }
            // Without a quad: the next but one has its registers at once.
            for (int empty = 0; empty < 2; ++empty) {
                draws.vary(0);
                draws.draw_as_set({});
            }
        }
        const TargetDifference difference = draws.difference();
        INFO(target_text(difference));
        CHECK(difference.target.empty());
    }
}

// A draw's combiner names a unit that the draw does not sample: black, whatever the one before it,
// under the other registers, has sampled there.
TEST_CASE("The pipe has no sample of a unit that only the other draw samples") {
    for (unsigned first = 0; first < 2; ++first) {
        PipeComparison comparison(Memories[0]);
        test::Scene scene(32, 24);
        comparison.attach(scene.gpu, scene.gpu);
        scene.into = &comparison;
        prepare(scene);
        scene.texture(1, {0}); // its sampler and combiner
        Registers& registers = scene.registers;
        registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 1, 0};
        registers.images[1] = registers.images[0];
        registers.samplers[1] = registers.samplers[0];
        const Combiner own = registers.combiners[0];
        test::RandomStates random(3);
        for (unsigned draw = first; draw < 6; ++draw) {
            const bool both = draw % 2 == 0;
            registers.images[1].shape.kind = both ? TextureKind::TwoD : TextureKind::None;
            registers.combiners[1] = own;
            registers.combiners[1].enable = true;
            for (CombineHalf* half : {&registers.combiners[1].rgb, &registers.combiners[1].alpha}) {
                half->op = CombineOp::Replace;
                half->arguments[0].source = CombineSource::Texture1;
            }
            scene.clear(0x40302010);
            scene.draw(PrimitiveType::Triangles, triangles(random, 4));
            INFO(told(comparison, draw));
            CHECK(comparison.equal());
        }
        CHECK(comparison.fragments().at("") > 500);
    }
}

// Of eight units that are sampled each is shown once, alone: no bit of its samples may be lost.
TEST_CASE("The pipe shades with the sample of each unit at each lane") {
    PipeComparison comparison(Memories[0]);
    test::Scene scene(32, 24);
    comparison.attach(scene.gpu, scene.gpu);
    scene.into = &comparison;
    prepare(scene);
    scene.texture(1, {0}); // its sampler and combiner
    Registers& registers = scene.registers;
    registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 1, 0};
    registers.images.fill(registers.images[0]);
    registers.samplers.fill(registers.samplers[0]);
    registers.combiners[0].enable = true;
    registers.combiners.fill(registers.combiners[0]);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        registers.images[unit].address += 0x4000 * unit;
    Combiner& last = registers.combiners[TextureUnits - 1];
    test::RandomStates random(4);
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        for (CombineHalf* half : {&last.rgb, &last.alpha}) {
            half->op = CombineOp::Replace;
            half->arguments[0].source =
                static_cast<CombineSource>(static_cast<unsigned>(CombineSource::Texture0) + unit);
        }
        scene.clear(0);
        scene.draw(PrimitiveType::Triangles, triangles(random, 12));
        INFO(told(comparison, unit));
        CHECK(comparison.equal());
        CHECK(scene.colors() > 16);
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
