#include "model/fragment/sample_mask.h"

#include <bit>

#include <catch2/catch.hpp>

using namespace ffgpu;

TEST_CASE("A larger alpha covers the samples of a smaller one, none at 0 and all at 255") {
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            REQUIRE(alpha_coverage(0, x, y) == 0);
            REQUIRE(alpha_coverage(255, x, y) == 0xf);
            unsigned before = 0;
            for (std::uint32_t alpha = 1; alpha < 256; ++alpha) {
                const unsigned now = alpha_coverage(alpha, x, y);
                REQUIRE((before & ~now) == 0);
                before = now;
            }
        }
}

TEST_CASE("Over a block of 4x4 pixels coverage is proportional to alpha") {
    for (std::uint32_t alpha = 0; alpha < 256; ++alpha) {
        int samples = 0;
        for (std::uint32_t y = 0; y < 4; ++y)
            for (std::uint32_t x = 0; x < 4; ++x)
                samples += std::popcount(alpha_coverage(alpha, x, y));
        // 64 samples: within half of one.
        REQUIRE(std::abs(samples * 255 - static_cast<int>(alpha) * 64) * 2 <= 255);
    }
}

TEST_CASE("Multisample operations are off with multisampling, and narrow coverage in order") {
    FragmentBatch batch{};
    batch.quad_count = 1;
    batch.x[0] = batch.y[0] = 0;
    for (unsigned lane = 0; lane < 4; ++lane)
        batch.live.set(lane);
    batch.samples.fill(batch.live);
    batch.color.a.fill(0);
    Multisample state{
        .enable = false, .alpha_to_coverage = true, .alpha_to_one = true, .sample_mask = 0x5};

    SECTION("off") {
        apply_sample_mask(state, batch);
        CHECK(batch.live.count() == 4);
        CHECK(batch.samples[1].count() == 4);
        CHECK(batch.color.a[0] == 0);
    }
    SECTION("alpha 0 covers nothing, although it becomes 1") {
        state.enable = true;
        apply_sample_mask(state, batch);
        CHECK_FALSE(batch.live.any());
        CHECK(batch.color.a[0] == 255);
    }
    SECTION("the mask takes samples, not fragments") {
        state = {.enable = true, .sample_mask = 0x5};
        apply_sample_mask(state, batch);
        CHECK(batch.live.count() == 4);
        CHECK(batch.samples[0].count() == 4);
        CHECK(batch.samples[1].count() == 0);
        CHECK(batch.samples[2].count() == 4);
        CHECK(batch.samples[3].count() == 0);
    }
    SECTION("an empty mask kills") {
        state = {.enable = true, .sample_mask = 0};
        apply_sample_mask(state, batch);
        CHECK_FALSE(batch.live.any());
    }
}
