// rtl/quad_interlock.sv around a read, six stages and a store: what a quad reads is what the one
// before it at its place has stored, whatever stalls.

#include "Vinterlock_loop.h"
#include "rtl/bundles/quad.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <map>

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct QuadInterlock {
    static constexpr const char* Name = "quad_interlock";
    static constexpr bool TakesEachCycle = false;
    static constexpr std::uint64_t ShortItems = 60000, LongItems = 10000000;

    using Dut = Vinterlock_loop;
    using State = NoState;
    using Input = Quad;
    using Output = Quad;

    static void set_tag(Quad& quad, unsigned tag) { quad.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    // The place of the quad before it, a neighbour in one bit, or any of the window's 256 quads.
    Quad random_input(Random& random, const State&) {
        Quad quad = random_quad(random);
        if (random.one_in(3)) {
            x_ = random.below(16);
            y_ = random.below(16);
        } else if (random.one_in(2)) {
            (random.one_in(2) ? x_ : y_) ^= 1u << random.below(4);
        }
        quad.x = static_cast<std::uint16_t>(2 * x_);
        quad.y = static_cast<std::uint16_t>(2 * y_);
        return quad;
    }

    // How many quads ago there was one of this place: 1 to 4, longer.
    static void declare(Bins& bins) { bins.declare("distance to the same place", 5); }
    void cover(Bins& bins, const State&, const Quad&) const {
        bins.hit("distance to the same place", distance_);
    }

    void expect(const State&, const Quad& input, std::vector<Quad>& outputs) {
        Quad quad = input;
        const std::pair<unsigned, unsigned> place{quad.x, quad.y};
        quad.depth[0] = count_[place]++;
        const std::uint64_t last = quad.depth[0] == 0 ? 0 : last_[place];
        distance_ = quad.depth[0] == 0 || now_ - last > 4 ? 4 : now_ - last - 1;
        last_[place] = now_++;
        outputs.push_back(quad);
    }
    void reset() {
        count_.clear();
        last_.clear();
    }

private:
    unsigned x_ = 0, y_ = 0;
    std::map<std::pair<unsigned, unsigned>, std::uint32_t> count_;
    std::map<std::pair<unsigned, unsigned>, std::uint64_t> last_;
    std::uint64_t now_ = 0, distance_ = 4;
};
using Unit = QuadInterlock;

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"

namespace ffgpu::rtl {
namespace {

// Cycles between the ends of two quads that came one behind the other.
unsigned cycles_between(const Quad& first, const Quad& second) {
    VerilatedContext context;
    Vinterlock_loop dut(&context);
    dut.clk_i = dut.in_valid_i = 0;
    dut.out_ready_i = 1;
    for (const int reset : {1, 0, 1}) {
        dut.rst_ni = static_cast<std::uint8_t>(reset);
        dut.eval();
    }
    const std::array offered{to_bits(first), to_bits(second)};
    std::array<unsigned, 2> ended{};
    std::size_t taken = 0, left = 0;
    for (unsigned cycle = 0; left < 2 && cycle < 100; ++cycle) {
        dut.in_valid_i = taken < 2;
        if (taken < 2) drive(dut.in_data_i, offered[taken]);
        dut.eval();
        if (dut.in_valid_i && dut.in_ready_o) ++taken;
        if (dut.out_valid_o) ended[left++] = cycle;
        dut.clk_i = 1;
        dut.eval();
        dut.clk_i = 0;
    }
    REQUIRE(left == 2);
    return ended[1] - ended[0];
}

// Those that the table lets in, and the one that waits in front of it.
TEST_CASE("as many quads are on their way as the table has places") {
    VerilatedContext context;
    Vinterlock_loop dut(&context);
    dut.clk_i = dut.in_valid_i = dut.out_ready_i = 0;
    for (const int reset : {1, 0, 1}) {
        dut.rst_ni = static_cast<std::uint8_t>(reset);
        dut.eval();
    }
    unsigned taken = 0;
    dut.in_valid_i = 1;
    for (unsigned cycle = 0; cycle < 20; ++cycle) {
        drive(dut.in_data_i, to_bits(Quad{.x = static_cast<std::uint16_t>(2 * taken)}));
        dut.eval();
        taken += dut.in_ready_o;
        dut.clk_i = 1;
        dut.eval();
        dut.clk_i = 0;
    }
    CHECK(taken == 4 + 1);
}

// All bits of a place are compared: no quad waits for one of another place.
TEST_CASE("a quad waits for one of its own place alone") {
    Random random(3);
    const Quad quad = random_quad(random);
    CHECK(cycles_between(quad, quad) > 6);
    for (unsigned bit = 1; bit < 13; ++bit) {
        INFO(bit);
        for (std::uint16_t Quad::*const axis : {&Quad::x, &Quad::y}) {
            Quad other = quad;
            other.*axis = static_cast<std::uint16_t>(other.*axis ^ 1u << bit);
            CHECK(cycles_between(quad, other) == 1);
        }
    }
}

} // namespace
} // namespace ffgpu::rtl
