// What a register may hold is not trusted: no image reaches out of memory, no coordinate out of an
// image.

#include "tests/texture/texture_fixture.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <catch2/catch.hpp>
#include <sys/mman.h>
#include <unistd.h>

namespace ffgpu::test {
namespace {

const TextureShape Shape{TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 5, 0};

bool compiles(TextureShape shape, DeviceAddress address, std::size_t memory_bytes) {
    const std::vector<std::byte> memory(memory_bytes + 64);
    return compile_texture_unit({shape, address}, Sampler{}, std::span(memory).first(memory_bytes))
        .valid;
}

TEST_CASE("an image must lie in memory to its last byte") {
    const auto bytes = static_cast<std::size_t>(texture_bytes(Shape));
    CHECK(compiles(Shape, 0, bytes));
    CHECK_FALSE(compiles(Shape, 0, bytes - 1));
    CHECK(compiles(Shape, 64, bytes + 64));
    CHECK_FALSE(compiles(Shape, 128, bytes + 64));
    CHECK_FALSE(compiles(Shape, 0xffffffc0, bytes));
}

TEST_CASE("a shape no driver makes is refused") {
    const auto refused = [](auto change) {
        TextureShape shape = Shape;
        change(shape);
        return !compiles(shape, 0, 1 << 20);
    };
    CHECK(refused([](auto& s) { s.kind = TextureKind::None; }));
    CHECK(refused([](auto& s) { s.kind = static_cast<TextureKind>(7); }));
    CHECK(refused([](auto& s) { s.format = Format::None; }));
    CHECK(refused([](auto& s) { s.format = Format::Stencil8; }));
    CHECK(refused([](auto& s) { s.format = static_cast<Format>(31); }));
    CHECK(refused([](auto& s) { s.levels = 0; }));
    CHECK(refused([](auto& s) { s.width = 0; }));
    CHECK(refused([](auto& s) { s.height = 8191; }));
    CHECK(refused([](auto& s) { s.kind = TextureKind::ThreeD, s.depth = 1023; }));
    CHECK_FALSE(refused([](auto& s) { s.levels = 15; })); // Cut to the most that there are.
}

TEST_CASE("a refused image is opaque black and reads nothing") {
    const TextureUnit unit = compile_texture_unit({Shape, 0}, Sampler{}, {});
    const auto planes = make_planes(2, [](unsigned) { return Coordinates{}; });
    ColorPlanes out;
    TexelFootprints footprints;
    sample(unit, *planes, all_quads(2), out, &footprints);
    CHECK(color_of(out, 0) == Color{0, 0, 0, 255});
    CHECK(color_of(out, 7) == Color{0, 0, 0, 255});
    CHECK(footprints.empty());
}

// Memory whose slack ends where no page is mapped: a read beyond faults.
class GuardedMemory {
public:
    explicit GuardedMemory(std::size_t bytes)
        : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE)))
        , mapped_((bytes + 64 + page_ - 1) / page_ * page_) {
        void* map =
            mmap(nullptr, mapped_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        REQUIRE(map != MAP_FAILED);
        map_ = static_cast<std::byte*>(map);
        REQUIRE(mprotect(map_ + page_, mapped_, PROT_READ | PROT_WRITE) == 0);
        span_ = {map_ + page_ + mapped_ - 64 - bytes, bytes};
    }
    ~GuardedMemory() { munmap(map_, mapped_ + 2 * page_); }
    GuardedMemory(const GuardedMemory&) = delete;
    GuardedMemory& operator=(const GuardedMemory&) = delete;

    std::span<const std::byte> span() const { return span_; }

private:
    std::size_t page_, mapped_;
    std::byte* map_ = nullptr;
    std::span<std::byte> span_;
};

TEST_CASE("no coordinate, wrap or format reads outside of memory") {
    Random random(11);
    const float infinity = std::numeric_limits<float>::infinity();
    const std::array<float, 12> edges{0.0f,
                                      -0.0f,
                                      1.0f,
                                      -1.0f,
                                      1e-40f,
                                      8388607.5f,
                                      3e38f,
                                      -3e38f,
                                      infinity,
                                      -infinity,
                                      NAN,
                                      0.999999f};
    for (unsigned i = 0; i < 2000; ++i) {
        TextureShape shape;
        shape.kind = static_cast<TextureKind>(1 + below(random, 5));
        shape.format = static_cast<Format>(1 + below(random, 15));
        shape.width = 1 + below(random, 40);
        shape.height = shape.kind == TextureKind::OneD ? 1 : 1 + below(random, 40);
        shape.depth = shape.kind == TextureKind::ThreeD ? 1 + below(random, 9) : 1;
        shape.border = random() % 2;
        const GuardedMemory memory(static_cast<std::size_t>(texture_bytes(shape)));
        const auto wrap = static_cast<Wrap>(below(random, 8));
        const Sampler sampler = random() % 2 ? linear_sampler(wrap) : nearest_sampler(wrap);
        const TextureUnit unit = compile_texture_unit({shape, 0}, sampler, memory.span());
        REQUIRE(unit.valid);
        const auto planes = make_planes(16, [&](unsigned) {
            const auto one = [&] {
                const float edge = edges[below(random, edges.size())];
                return random() % 2 ? edge : static_cast<float>(random()) * 0x1p-30f - 2;
            };
            return Coordinates{one(), one(), one()};
        });
        ColorPlanes out;
        sample(unit, *planes, all_quads(16), out, nullptr);
        for (unsigned lane = 0; lane < 64; ++lane)
            REQUIRE(color_of(out, lane)[0] <= 255);
    }
}

} // namespace
} // namespace ffgpu::test
