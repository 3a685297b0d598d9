// rtl/reciprocal.sv against reciprocal(): every mantissa.

#include "Vreciprocal.h"
#include "model/arith/range.h"
#include "model/arith/reciprocal.h"
#include "rtl/bundles/tagged_float.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct Reciprocal {
    static constexpr const char* Name = "reciprocal";
    static constexpr std::string_view Latency = "ReciprocalLatency";
    static constexpr std::uint64_t ShortItems = 1000000, LongItems = 10000000;

    using Dut = Vreciprocal;
    using State = NoState;
    using Input = TaggedFloat;
    using Output = TaggedFloat;

    static void set_tag(TaggedFloat& item, unsigned tag) { item.tag = tag != 0; }

    static State random_state(Random&) { return {}; }
    static TaggedFloat random_input(Random& random, const State&) {
        const std::uint32_t exponent = 1 + random.below(252);
        const std::uint32_t near = (1u << random.below(24)) + random.below(3) - 1;
        const std::uint32_t fraction = random.one_in(20)   ? 0
                                       : random.one_in(20) ? near & 0x7fffff
                                                           : random.word() >> 9;
        return {false,
                static_cast<std::uint16_t>(random.below(1024)),
                std::bit_cast<float>(random.word() << 31 | exponent << 23 | fraction)};
    }

    static void declare(Bins& bins) {
        bins.declare("sign", 2);
        bins.declare("exponent", 252);
        bins.declare("power of two, rounded down, up", 3);
    }
    static void cover(Bins& bins, const State&, const TaggedFloat& item) {
        const auto bits = std::bit_cast<std::uint32_t>(item.value);
        bins.hit("sign", bits >> 31);
        bins.hit("exponent", (bits >> 23 & 255) - 1);
        const double exact = 1.0 / double{item.value}; // 29 bits more: enough to tell
        const double rounded = double{reciprocal(item.value)};
        bins.hit("power of two, rounded down, up",
                 rounded == exact                      ? 0
                 : std::abs(rounded) < std::abs(exact) ? 1
                                                       : 2);
    }

    static void expect(const State&, const TaggedFloat& item, std::vector<TaggedFloat>& outputs) {
        outputs.push_back({item.tag, item.place, reciprocal(item.value)});
    }
};
using Unit = Reciprocal;

// 2^23 inputs; of the short form each sixteenth.
TEST_CASE("the reciprocal equals the model's on every mantissa") {
    Reciprocal unit;
    UnitBench<Reciprocal> bench(unit);
    const unsigned step = std::getenv("FFGPU_RTL_LONG") ? 1 : 16;
    const unsigned count = (1u << 23) / step;
    const auto state = [](unsigned) { return NoState{}; };
    const auto input = [step](unsigned, unsigned i) {
        const std::uint32_t mantissa = i * step + i % step;
        return TaggedFloat{false,
                           static_cast<std::uint16_t>(i & 1023),
                           std::bit_cast<float>(0x3f800000 | mantissa)};
    };
    bench.run(counted_source<Reciprocal>(1, count, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == count);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
