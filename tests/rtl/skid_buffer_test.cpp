// rtl/skid_buffer.sv gives what it takes, in order. The tag is a bit of the data like others.

#include "Vskid_buffer.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct SkidBuffer {
    static constexpr const char* Name = "skid_buffer";
    static constexpr std::uint64_t ShortItems = 200000, LongItems = 10000000;

    struct Item {
        bool tag = false;
        std::uint8_t value = 0;

        template <class Self, class Visitor>
        static void visit(Self& self, Visitor&& field) {
            field("tag", self.tag, 1);
            field("value", self.value, 7);
        }
    };
    using Dut = Vskid_buffer;
    using State = NoState;
    using Input = Item;
    using Output = Item;

    static void set_tag(Item& item, unsigned tag) { item.tag = tag != 0; }
    static State random_state(Random&) { return {}; }
    static Item random_input(Random& random, const State&) {
        return {false, static_cast<std::uint8_t>(random.below(128))};
    }

    static void declare(Bins& bins) { bins.declare("value", 128); }
    static void cover(Bins& bins, const State&, const Item& item) { bins.hit("value", item.value); }

    static void expect(const State&, const Item& item, std::vector<Item>& outputs) {
        outputs.push_back(item);
    }
};
using Unit = SkidBuffer;

// Ready is a flop: it says by itself in the cycle after the receiver stopped that there is no room.
TEST_CASE("the buffer's ready does not see the receiver's") {
    Vskid_buffer dut;
    const auto clock = [&dut] {
        dut.clk_i = 1;
        dut.eval();
        dut.clk_i = 0;
        dut.eval();
    };
    dut.clk_i = 0;
    dut.rst_ni = 1;
    dut.eval();
    dut.rst_ni = 0;
    dut.eval();
    dut.rst_ni = 1;
    dut.in_valid_i = 1;
    dut.out_ready_i = 0;
    clock();
    CHECK(dut.in_ready_o == 1);
    clock();
    CHECK(dut.in_ready_o == 0);
    dut.out_ready_i = 1;
    dut.eval();
    CHECK(dut.in_ready_o == 0);
    clock();
    CHECK(dut.in_ready_o == 1);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
