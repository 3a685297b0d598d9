#include "model/device/compare.h"
#include "model/fragment/alpha_test.h"
#include "model/fragment/fragment_pipe.h"
#include "model/fragment/stencil_depth.h"
#include "tests/fragment/random_fragments.h"

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

StencilDepthState depth_state(Compare function, bool write = true) {
    return compile_stencil_depth({},
                                 {.test_enable = true, .write_enable = write, .compare = function},
                                 Format::Depth24Stencil8);
}

StencilDepthState stencil_state(const StencilFace& front, const StencilFace& back = {}) {
    return compile_stencil_depth(
        {.enable = true, .front = front, .back = back}, {}, Format::Depth24Stencil8);
}

} // namespace

TEST_CASE("Each comparison decides on both sides of equality") {
    // Below, at and above the reference, at the ends of the range and within.
    const struct {
        Compare function;
        bool below, equal, above;
    } table[] = {
        {Compare::Never, false, false, false},
        {Compare::Less, true, false, false},
        {Compare::Equal, false, true, false},
        {Compare::Lequal, true, true, false},
        {Compare::Greater, false, false, true},
        {Compare::Notequal, true, false, true},
        {Compare::Gequal, false, true, true},
        {Compare::Always, true, true, true},
    };
    for (const auto& row : table)
        for (const std::uint32_t reference : {1u, 0x800000u, 0xfffffeu}) {
            INFO(int(row.function) << " " << reference);
            REQUIRE(compare(row.function, reference - 1, reference) == row.below);
            REQUIRE(compare(row.function, reference, reference) == row.equal);
            REQUIRE(compare(row.function, reference + 1, reference) == row.above);
            const StencilDepthState state = depth_state(row.function);
            const auto passes = [&](std::uint32_t depth) {
                const StencilDepthResult result =
                    test_stencil_depth(state, true, depth, {reference, 5});
                REQUIRE(result.pixel.depth == (result.passes_depth ? depth : reference));
                REQUIRE(result.pixel.stencil == 5);
                return result.passes_depth;
            };
            REQUIRE(passes(reference - 1) == row.below);
            REQUIRE(passes(reference) == row.equal);
            REQUIRE(passes(reference + 1) == row.above);
        }
}

TEST_CASE("A depth test without writes keeps the stored depth") {
    const StencilDepthResult result =
        test_stencil_depth(depth_state(Compare::Always, false), true, 7, {100, 0});
    REQUIRE(result.passes_depth);
    REQUIRE(result.pixel.depth == 100);
}

TEST_CASE("Depth is written only together with the test") {
    const StencilDepthState state = compile_stencil_depth(
        {}, {.test_enable = false, .write_enable = true}, Format::Depth24Stencil8);
    REQUIRE_FALSE(state.active());
    REQUIRE_FALSE(state.writes());
}

TEST_CASE("Stencil operations do as their table says, at both ends of the range") {
    const auto op = [](StencilOp o, unsigned stored) {
        return int(apply_stencil_op(o, static_cast<std::uint8_t>(stored), 0x5a));
    };
    for (const unsigned stored : {0u, 1u, 0x80u, 254u, 255u}) {
        const int s = static_cast<int>(stored);
        REQUIRE(op(StencilOp::Keep, stored) == s);
        REQUIRE(op(StencilOp::Zero, stored) == 0);
        REQUIRE(op(StencilOp::Replace, stored) == 0x5a);
        REQUIRE(op(StencilOp::Increment, stored) == std::min(255, s + 1));
        REQUIRE(op(StencilOp::Decrement, stored) == std::max(0, s - 1));
        REQUIRE(op(StencilOp::Invert, stored) == 255 - s);
        REQUIRE(op(StencilOp::IncrementWrap, stored) == (s + 1) % 256);
        REQUIRE(op(StencilOp::DecrementWrap, stored) == (s + 255) % 256);
    }
}

TEST_CASE("The stencil test compares the reference with the stored value under the mask") {
    const StencilDepthState state =
        stencil_state({.compare = Compare::Less, .reference = 0xf3, .compare_mask = 0x0f});
    REQUIRE(test_stencil_depth(state, true, 0, {0, 0x04}).passes_stencil);
    REQUIRE_FALSE(test_stencil_depth(state, true, 0, {0, 0xf3}).passes_stencil);
    REQUIRE_FALSE(test_stencil_depth(state, true, 0, {0, 0xf2}).passes_stencil);
}

TEST_CASE("Stencil fail, depth fail and depth pass apply their own operation, under the mask") {
    StencilFace face{.compare = Compare::Equal,
                     .fail = StencilOp::Zero,
                     .depth_fail = StencilOp::Replace,
                     .depth_pass = StencilOp::Invert,
                     .reference = 0x3c,
                     .write_mask = 0xf0};
    StencilDepthState state = stencil_state(face);
    state.depth = {.test_enable = true, .write_enable = true, .compare = Compare::Less};
    const auto stored_after = [&](std::uint32_t depth, std::uint8_t stencil) {
        return test_stencil_depth(state, true, depth, {100, stencil}).pixel;
    };
    REQUIRE(stored_after(50, 0x77) == StencilDepthPixel{100, 0x07});
    REQUIRE(stored_after(150, 0x3c) == StencilDepthPixel{100, 0x3c});
    REQUIRE(stored_after(50, 0x3c) == StencilDepthPixel{50, 0xcc});
}

TEST_CASE("Front and back faces have their own stencil state") {
    const StencilDepthState state =
        stencil_state({.depth_pass = StencilOp::Increment}, {.depth_pass = StencilOp::Decrement});
    REQUIRE(test_stencil_depth(state, true, 0, {0, 7}).pixel.stencil == 8);
    REQUIRE(test_stencil_depth(state, false, 0, {0, 7}).pixel.stencil == 6);
}

TEST_CASE("Outside the depth bounds a fragment dies and leaves the stencil alone") {
    StencilDepthState state = stencil_state({.depth_pass = StencilOp::Invert});
    state.depth = {.bounds_enable = true, .bounds_min = 10, .bounds_max = 20};
    const auto stencil_after = [&](std::uint32_t stored) {
        const StencilDepthResult result = test_stencil_depth(state, true, 0, {stored, 0});
        REQUIRE(result.passes_depth == (result.pixel.stencil == 255));
        return int(result.pixel.stencil);
    };
    REQUIRE(stencil_after(9) == 0);
    REQUIRE(stencil_after(10) == 255);
    REQUIRE(stencil_after(20) == 255);
    REQUIRE(stencil_after(21) == 0);
}

TEST_CASE("What the target lacks is off") {
    Stencil stencil;
    stencil.enable = true;
    const DepthControl depth{.test_enable = true, .bounds_enable = true};
    REQUIRE_FALSE(compile_stencil_depth(stencil, depth, Format::None).active());
    REQUIRE_FALSE(compile_stencil_depth(stencil, depth, Format::Depth16).stencil);
    REQUIRE(compile_stencil_depth(stencil, {}, Format::Depth24Stencil8).active());
}

TEST_CASE("A draw that asks for early depth with stencil tests late") {
    test::Scene scene;
    scene.memory.resize(4096);
    scene.registers->targets.depth = {
        .format = Format::Depth24Stencil8, .width = 16, .height = 16, .stride = 64};
    scene.registers->scissor = {.width = 16, .height = 16};
    scene.registers->depth.test_enable = true;
    scene.state.early_depth = true;
    REQUIRE(scene.compile().early_depth);
    scene.registers->stencil.enable = true;
    REQUIRE_FALSE(scene.compile().early_depth);
}

TEST_CASE("The alpha test decides on both sides of the reference, in scalar and batch form") {
    auto batch = std::make_unique<FragmentBatch>();
    batch->quad_count = BatchQuads;
    for (unsigned lane = 0; lane < BatchFragments; ++lane)
        batch->color.a[lane] = static_cast<std::uint16_t>(lane);
    batch->live.words.fill(0xfedcba9876543210);
    for (unsigned function = 0; function < 8; ++function)
        for (unsigned reference = 0; reference < 256; ++reference) {
            const FragmentControl control{.alpha_test = true,
                                          .alpha_compare = static_cast<Compare>(function),
                                          .alpha_reference = static_cast<std::uint8_t>(reference)};
            FragmentMask expected;
            for (unsigned lane = 0; lane < BatchFragments; ++lane)
                if (batch->live.test(lane) && passes_alpha_test(control, lane)) expected.set(lane);
            REQUIRE(alpha_test(control, *batch) == expected);
        }
    REQUIRE(alpha_test({.alpha_test = false, .alpha_compare = Compare::Never}, *batch) ==
            batch->live);
}
