// A stream from a damaged capture: one clear line, never a crash.

#include "tests/gpu/scene.h"

#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

std::string complaint(Scene& scene, const CommandStream& stream) {
    try {
        scene.gpu.submit(stream);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("each fault in a stream is named with its word") {
    Scene scene(32, 32);
    scene.clear(0);
    CommandStream stream;
    stream.words = {CommandStream::header(Opcode::EndFrame, 0), 0x02000010, 1, 2};
    CHECK(complaint(scene, stream) == "command stream, word 1: the payload of 16 words is cut off");
    stream.words = {0x77000000};
    CHECK(complaint(scene, stream) == "command stream, word 0: there is no opcode 119");
    stream.words = {CommandStream::header(Opcode::WriteRegister, 1), 9999};
    CHECK(complaint(scene, stream) == "command stream, word 0: there is no register 9999");
    stream.words = {CommandStream::header(Opcode::WriteRegister, 2), 0, 0};
    CHECK_THAT(complaint(scene, stream), Catch::Contains("opcode 1 has 2 words, expected"));

    DrawCommand draw;
    draw.count = draw.vertex_count = 3;
    draw.vertex_address = 0xfffffff0;
    stream.clear();
    stream.add(draw);
    CHECK_THAT(complaint(scene, stream), Catch::Contains("vertices do not lie in device memory"));
    draw.vertex_address = 0;
    draw.count = 0xffffffff;
    stream.clear();
    stream.add(draw);
    CHECK_THAT(complaint(scene, stream), Catch::Contains("exceed those in memory"));
}

TEST_CASE("registers with values that do not exist are refused when something is drawn") {
    Scene scene(32, 32);
    scene.registers.blend.rgb_source = static_cast<BlendFactor>(15);
    CHECK_THROWS_WITH(scene.clear(0),
                      Catch::Contains("blend.rgb_source holds no value of its kind"));
    scene.registers.blend.rgb_source = BlendFactor::One;
    scene.registers.targets.color[0].address = 0xfff00000;
    CHECK_THROWS_WITH(scene.clear(0), Catch::Contains("target does not lie in device memory"));
    scene.registers.targets.color[0].address = ColorAt;
    scene.registers.vertex_format.elements[0] = {4, 200};
    CHECK_THROWS_WITH(scene.clear(0), Catch::Contains("vertex element"));
    scene.registers.vertex_format.elements[0] = {4, 0};
    CHECK_NOTHROW(scene.clear(0));
}

TEST_CASE("without a target nothing is drawn, and what follows is") {
    const Vertex corner{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0};
    Vertex right = corner, top = corner;
    right.x = top.y = 3; // The triangle covers the window.
    for (const unsigned threads : {1u, 2u}) {
        Scene scene(64, 64, {.threads = threads});
        scene.clear(0);
        const Targets targets = scene.registers.targets;
        scene.registers.targets = {};
        scene.draw(PrimitiveType::Triangles, {corner, right, top});
        scene.gpu.finish();
        CHECK(counters(scene.gpu).at("fragments_covered") == 0);
        scene.registers.targets = targets;
        scene.draw(PrimitiveType::Triangles, {corner, right, top});
        CHECK(scene.pixel(63, 63) == 0xffffffff);
    }
}

TEST_CASE("streams with random words do not crash") {
    std::mt19937 random(99);
    for (int round = 0; round < 300; ++round) {
        Scene scene(64, 64, {.threads = round % 7 == 0 ? 2u : 1u});
        scene.clear(0);
        scene.texture(8, std::vector<std::uint32_t>(64, 0xff00ff00));
        scene.send();
        CommandStream stream;
        // Whole commands with some bits flipped come further than noise.
        Registers changed = scene.registers;
        changed.viewport.x = 3;
        changed.fog.mode = FogMode::Exp;
        changed.stencil.enable = true;
        changed.blend.enable = true;
        changed.primitive.point_size = 9;
        changed.lighting.enable = true;
        changed.tex_coords[0].matrix_enable = true;
        changed.samplers[0].max_anisotropy = 4;
        write_changes(scene.registers, changed, stream);
        DrawCommand draw;
        draw.primitive = static_cast<PrimitiveType>(random() % 10);
        draw.count = draw.vertex_count = random() % 64;
        draw.vertex_address = random() % 4096 * 4;
        stream.add(draw);
        stream.add(ClearCommand{.color = true, .depth = true});
        DrawImageCommand image;
        image.address = TextureAt;
        image.stride = 32;
        image.width = image.height = 8;
        stream.add(image);
        stream.add(Opcode::EndFrame);
        for (int flips = 0; flips < round % 40; ++flips)
            stream.words[random() % stream.words.size()] ^= 1u << random() % 32;
        try {
            scene.gpu.submit(stream);
        } catch (const InputError&) {
        }
        scene.gpu.finish();
    }
    SUCCEED();
}
