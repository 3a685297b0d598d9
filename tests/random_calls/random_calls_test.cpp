// Random programs on the whole machine: nothing that OpenGL defines breaks it, and what is drawn
// depends neither on threads nor on tiles.
//
// FFGPU_RANDOM_PROGRAMS=N runs N programs instead of some hundred, from FFGPU_RANDOM_SEED on;
// FFGPU_RANDOM_VERBOSE=1 prints each call.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"
#include "tests/random_calls/random_walk.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

constexpr unsigned Width = 80, Height = 56;
constexpr unsigned CallsInProgram = 400;

std::uint32_t setting(const char* name, std::uint32_t otherwise) {
    const char* const text = std::getenv(name);
    return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// What a program leaves in both buffers, and its accepted calls are added.
std::vector<std::uint8_t> run_program(const Registry& registry,
                                      WalkMemory& memory,
                                      std::uint32_t seed,
                                      const FunctionalGpu::Config& config,
                                      std::vector<unsigned>& accepted) {
    FunctionalGpu device(config);
    OffscreenContext gl(device, {.width = Width, .height = Height});
    gl.make_current();
    RandomWalk walk(registry, memory, [random = std::mt19937(seed)]() mutable {
        return static_cast<std::uint32_t>(random());
    });
    walk.verbose = setting("FFGPU_RANDOM_VERBOSE", 0) != 0;
    for (unsigned i = 0; i < CallsInProgram; ++i)
        walk.step(gl.context());
    walk.settle();
    std::vector<std::uint8_t> pixels(std::size_t{2} * Width * Height * 4);
    std::size_t at = 0;
    for (const GLenum buffer : {GLenum{GL_FRONT}, GLenum{GL_BACK}}) {
        entry::ReadBuffer(buffer);
        entry::ReadPixels(0, 0, Width, Height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data() + at);
        at += pixels.size() / 2;
    }
    for (std::size_t i = 0; i < accepted.size(); ++i)
        accepted[i] += walk.accepted()[i];
    return pixels;
}

TEST_CASE("Random programs draw the same on any number of threads, in tiles of any size") {
    const Registry registry = read_registry("/usr/share/khronos-api/gl.xml");
    if (registry.empty()) {
        std::cout << "skipped: /usr/share/khronos-api/gl.xml (package khronos-api) is missing\n";
        return;
    }
    const std::uint32_t first = setting("FFGPU_RANDOM_SEED", 1);
    const std::uint32_t programs = setting("FFGPU_RANDOM_PROGRAMS", 300);
    std::vector<unsigned> accepted(static_cast<std::size_t>(Command::Count));
    unsigned drawn = 0;
    WalkMemory memory;
    for (std::uint32_t seed = first; seed < first + programs; ++seed) {
        INFO("seed " << seed);
        constexpr std::uint64_t Memory = std::uint64_t{64} << 20;
        const auto plain = run_program(registry, memory, seed, {.memory_bytes = Memory}, accepted);
        std::vector<unsigned> ignored(accepted.size());
        const auto other = run_program(registry,
                                       memory,
                                       seed,
                                       {.threads = 3, .tile_size = 16, .memory_bytes = Memory},
                                       ignored);
        CHECK(plain == other);
        drawn += std::any_of(plain.begin(), plain.end(), [](auto byte) { return byte != 0; });
    }
    // The walk must get somewhere.
    const auto reached = accepted.size() -
                         static_cast<std::size_t>(std::count(accepted.begin(), accepted.end(), 0u));
    std::cout << programs << " random programs: " << reached << " of " << accepted.size()
              << " commands accepted, " << drawn << " drew something\n";
    CHECK(drawn > programs / 2);
    if (programs >= 300) CHECK(reached > accepted.size() * 9 / 10);
}

} // namespace
} // namespace ffgpu::gl
