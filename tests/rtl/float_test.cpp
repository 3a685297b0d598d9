// The units of binary32 against the host's IEEE arithmetic, on zeros and normal numbers whose
// results are such: what the range rule lets into the fragment path.

#include "Vfloat_units.h"
#include "model/arith/range.h"
#include "tests/rtl/bench/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <catch2/catch.hpp>
#include <verilated.h>

namespace ffgpu::rtl {
namespace {

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

// Mantissas of few bits come often: their sums and products end in ties.
float random_float(Random& random, int least, int most) {
    if (random.one_in(50)) return random.one_in(2) ? 0.0f : -0.0f;
    const std::uint32_t kept = random.below(24);
    std::uint32_t mantissa = random.word() >> 9;
    if (random.one_in(2)) mantissa = mantissa >> kept << kept;
    if (random.one_in(8)) mantissa ^= 0x7fffff;
    const auto exponent = static_cast<std::uint32_t>(127 + least) +
                          random.below(static_cast<std::uint32_t>(most - least + 1));
    return std::bit_cast<float>(random.word() << 31 | exponent << 23 | mantissa);
}

// A mantissa of 24 bits whose product with an odd one ends in `low` 24 bits, if there is one: the
// inverse modulo a power of two, whose bits double with each step of Newton's.
std::optional<std::uint32_t> other_mantissa(std::uint32_t odd, std::uint32_t low) {
    std::uint32_t inverse = odd;
    for (unsigned bits = 3; bits < 24; bits *= 2)
        inverse *= 2 - odd * inverse;
    const std::uint32_t other = low * inverse & 0xffffff;
    return (other & 0x800000) != 0 ? std::optional(other) : std::nullopt;
}

// Whether the lowest bit of a product keeps it from the middle of two numbers of 24 bits.
bool is_beside_tie(std::uint64_t product) {
    const std::uint64_t half = std::uint64_t{1} << (std::bit_width(product) - 25);
    const std::uint64_t rest = product & (2 * half - 1);
    return rest == half - 1 || rest == half + 1;
}

// Which way the exact result went: down, up, exact, or from a tie.
unsigned rounding(double exact, float rounded) {
    const double below = std::nextafter(rounded, -INFINITY),
                 above = std::nextafter(rounded, INFINITY);
    if (exact == rounded) return 0;
    if (exact == (rounded + below) / 2 || exact == (rounded + above) / 2) return 3;
    return exact < rounded ? 1 : 2;
}

class Checker {
public:
    Checker() { dut_.enable_i = 1; }

    void check(float a, float b) {
        dut_.a_i = bits(a);
        dut_.b_i = bits(b);
        dut_.eval();
        check_disabled();
        const float product = a * b, sum = a + b;
        carries += std::abs(product) == 1 && std::abs(double{a} * b) < 1;
        if (is_ordinary(product) && std::abs(double{a} * b) >= 0x1p-126)
            compare("product", product, dut_.product_o, double{a} * b);
        if (product == 0 && (a == 0 || b == 0)) compare("product", product, dut_.product_o, 0);
        // Exact in binary64 where the exponents are near.
        if (is_ordinary(sum)) compare("sum", sum, dut_.sum_o, double{a} + b);
        check_clamp(a, 1, dut_.clamped_o);
        check_clamp(a, 3, dut_.clamped_wide_o);
        if (a >= 0 && a < 1048576 && dut_.integer_o != static_cast<std::uint32_t>(a))
            tell("integer", a, b);
        if (std::abs(a) < 0x1p22f) {
            const float nearest = std::nearbyint(a);
            halves += std::abs(a - nearest) == 0.5f;
            const auto expected = static_cast<std::uint32_t>(static_cast<std::int32_t>(nearest));
            if (dut_.nearest_o != (expected & 0xffffff)) tell("nearest integer", a, b);
        }
    }
    void check_conversion(std::uint32_t integer) {
        dut_.signed_i = integer;
        dut_.eval();
        check_disabled();
        const auto exact = static_cast<std::int32_t>(integer);
        const auto expected = static_cast<float>(exact);
        ++conversions[rounding(exact, expected)];
        if (bits(expected) != dut_.converted_o) tell("conversion", exact, 0);
    }
    std::uint64_t wrong = 0, compared = 0, carries = 0; // of a rounding into the exponent
    std::array<std::uint64_t, 4> products{}, sums{}, conversions{};
    std::uint64_t halves = 0;               // rounded to an integer
    std::array<std::uint64_t, 4> clamped{}; // below, inside, at the most, above

private:
    void compare(const char* what, float expected, std::uint32_t got, double exact) {
        static const bool blind = std::getenv("FFGPU_RTL_BLIND") != nullptr;
        if (blind) return;
        ++compared;
        ++(what[0] == 'p' ? products : sums)[rounding(exact, expected)];
        if (bits(expected) != got) tell(what, exact, got);
    }
    // Where nobody looks, what can be let not to compute is 0.
    void check_disabled() {
        dut_.enable_i = 0;
        dut_.eval();
        if (dut_.product_o != 0 || dut_.sum_o != 0 || dut_.converted_o != 0)
            tell("not enabled", 0, 0);
        dut_.enable_i = 1;
        dut_.eval();
    }
    void check_clamp(float a, float most, std::uint32_t got) {
        ++clamped[a < 0 ? 0 : a < most ? 1 : a == most ? 2 : 3];
        if (bits(a <= 0 ? 0.0f : std::min(a, most)) != got) tell("clamped", a, most);
    }
    void tell(const char* what, double a, double b) {
        if (++wrong < 4) UNSCOPED_INFO(what << ' ' << a << ' ' << b);
    }

    Vfloat_units dut_;
};

TEST_CASE("products, sums, conversions and clamps of binary32 equal the host's") {
    Checker checker;
    Random random(5);
    const std::uint64_t count = std::getenv("FFGPU_RTL_LONG") ? 10000000 : 1000000;
    std::uint64_t beside_ties = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const float a = random_float(random, -60, 60);
        // Sums of near exponents cancel.
        const int near = a == 0 ? 0 : std::ilogb(a);
        const float b = random.one_in(2) ? random_float(random, near - 27, near + 27)
                                         : random_float(random, -60, 60);
        checker.check(a, b);
        if (random.one_in(16)) checker.check(a, -a);
        // Integers of any magnitude, often of few bits, and their neighbours.
        const std::uint32_t dropped = random.below(32);
        std::uint32_t integer = random.word() >> random.below(32);
        if (random.one_in(2)) integer = integer >> dropped << dropped;
        if (random.one_in(2)) integer = 0 - integer;
        checker.check_conversion(integer + random.below(3) - 1);
        // Halves and their neighbours, rounded to integers.
        if (random.one_in(16)) {
            const float whole = static_cast<float>(random.word() >> (10 + random.below(22)));
            const float half = random.one_in(2) ? whole + 0.5f : -whole - 0.5f;
            checker.check(half, whole);
            checker.check(std::nextafter(half, 0.0f), whole);
            checker.check(std::nextafter(half, 2 * half), whole);
        }
        if (random.one_in(64)) checker.check(random.one_in(2) ? 1.0f : 3.0f, a);
        // Products beside a power of two: half of those below are rounded up to it.
        if (a != 0 && random.one_in(4)) checker.check(a, 1 / a);
        // Products that the lowest of 47 or 48 bits keeps from a tie.
        if (random.one_in(4)) {
            const std::uint32_t odd = random.word() >> 8 | 0x800001;
            const std::uint32_t half = random.one_in(2) ? 0x400000 : 0x800000;
            const std::uint32_t above = random.word() & ~(2 * half - 1);
            const auto other = other_mantissa(odd, (above | half) + (random.one_in(2) ? 1 : -1u));
            if (!other) continue;
            beside_ties += is_beside_tie(std::uint64_t{odd} * *other);
            checker.check(static_cast<float>(odd), static_cast<float>(*other));
        }
    }
    CHECK(checker.wrong == 0);
    CHECK(checker.compared > count);
    CHECK(checker.carries > 0);
    CHECK(checker.halves > 0);
    CHECK(beside_ties > count / 32);
    for (unsigned way = 0; way < 4; ++way) {
        CHECK(checker.products[way] > 0);
        CHECK(checker.sums[way] > 0);
        CHECK(checker.conversions[way] > 0);
        CHECK(checker.clamped[way] > 0);
    }
}

} // namespace
} // namespace ffgpu::rtl
