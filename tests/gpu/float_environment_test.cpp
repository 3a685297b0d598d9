// The device under a caller's own floating-point mode.

#include "model/base/float_environment.h"
#include "tests/gpu/scene.h"

#include <cfenv>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// Small and large triangles in perspective. Made before a mode is set.
std::vector<std::vector<Vertex>> make_draws() {
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<float>(random() & 0xffff) / 32768.0f - 1.0f; };
    std::vector<std::vector<Vertex>> draws(30);
    for (std::size_t i = 0; i < draws.size(); ++i)
        for (int corner = 0; corner < 24; ++corner) {
            const float w = 1.5f + unit(), tiny = i % 3 == 0 ? 1e-39f : 1.0f;
            draws[i].push_back({unit() * w,
                                unit() * w,
                                unit() * w * 0.5f,
                                w,
                                unit(),
                                unit() * tiny,
                                unit(),
                                1,
                                unit() * 7,
                                unit() * tiny});
        }
    return draws;
}

struct Pictures {
    std::vector<std::uint32_t> color, depth;
    bool operator==(const Pictures&) const = default;
};

template <class SetMode, class CheckMode>
Pictures draw(unsigned threads, SetMode&& set_mode, CheckMode&& check_mode) {
    const std::vector<std::vector<Vertex>> draws = make_draws();
    std::vector<std::uint32_t> texels;
    for (std::uint32_t i = 0; i < 32 * 32; ++i)
        texels.push_back(0xff000000 | i * 2654435761u >> 8);
    set_mode();
    Scene scene(160, 120, {.threads = threads}); // Its threads inherit the mode.
    scene.texture(32, texels);
    scene.registers.samplers[0].magnify_linear = scene.registers.samplers[0].minify_linear = true;
    scene.registers.depth = {.test_enable = true, .write_enable = true};
    scene.clear(0xff102030);
    for (const std::vector<Vertex>& vertices : draws)
        scene.draw(PrimitiveType::Triangles, vertices);
    Pictures pictures{scene.picture(), scene.depth_buffer()};
    check_mode();
    return pictures;
}

} // namespace

TEST_CASE("a caller's rounding mode reaches no pixel, on any thread") {
    const Pictures expected = draw(
        1, [] {}, [] {});
    for (const unsigned threads : {1u, 3u})
        for (const int mode : {FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD}) {
            int found = -1;
            const Pictures drawn = draw(
                threads,
                [mode] { std::fesetround(mode); },
                [&found] {
                    found = std::fegetround();
                    std::fesetround(FE_TONEAREST);
                });
            CHECK(found == mode);
            CHECK(drawn == expected);
        }
}

#if defined(__x86_64__)
TEST_CASE("a caller that flushes subnormals to zero gets the same pixels") {
    const Pictures expected = draw(
        1, [] {}, [] {});
    constexpr unsigned Mode = 0xffc0;
    for (const unsigned threads : {1u, 3u})
        for (const unsigned control : {0x9fc0u, 0xffc0u}) { // 0x6000 of the latter: toward zero
            unsigned found = 0;
            const Pictures drawn = draw(
                threads,
                [control] { _mm_setcsr(control); },
                [&found] {
                    found = _mm_getcsr();
                    _mm_setcsr(0x1f80);
                });
            CHECK((found & Mode) == control);
            CHECK(drawn == expected);
        }
}

TEST_CASE("an environment sets the usual mode, and gives back the one it found") {
    _mm_setcsr(0xffc0);
    {
        const FloatEnvironment outer;
        CHECK((_mm_getcsr() & 0xffc0) == 0x1f80);
        const FloatEnvironment inner;
        CHECK((_mm_getcsr() & 0xffc0) == 0x1f80);
    }
    const unsigned found = _mm_getcsr();
    _mm_setcsr(0x1f80);
    CHECK(found == 0xffc0);
}
#endif
