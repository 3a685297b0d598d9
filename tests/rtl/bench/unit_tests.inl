// What holds for every unit. Included by its test, which has named it `Unit` in this namespace.

#include "tests/support/printed.h"

namespace ffgpu::rtl {
namespace {

// Items of the random test: a short form for ctest, a long one for `./dev rtl_check --long`.
std::uint64_t item_count() {
    return std::getenv("FFGPU_RTL_LONG") ? Unit::LongItems : Unit::ShortItems;
}

// Draws of 1 to 64 items, `items` altogether.
Source<Unit> random_source(Unit& unit, Random& random, std::uint64_t items) {
    struct Progress {
        std::uint64_t items;
        unsigned left = 0;
        Unit::State state{};
    };
    auto progress = std::make_shared<Progress>(Progress{items});
    return {
        [&unit, &random, progress]() -> std::optional<Unit::State> {
            if (progress->items == 0) return std::nullopt;
            progress->left = 1 + random.below(64);
            return progress->state = unit.random_state(random);
        },
        [&unit, &random, progress]() -> std::optional<Unit::Input> {
            if (progress->left == 0 || progress->items == 0) return std::nullopt;
            --progress->left;
            --progress->items;
            return unit.random_input(random, progress->state);
        },
    };
}

TEST_CASE("the unit equals the model on random states and inputs, whatever stalls") {
    Unit unit;
    Bins bins;
    unit.declare(bins);
    std::uint64_t compared = 0;
    for (const Stall stall : AllStalls) {
        UnitBench<Unit> bench(unit, 1 + static_cast<unsigned>(stall));
        bench.bins = &bins;
        Random random(77 + static_cast<unsigned>(stall));
        // Stalled cycles cost as much as others and show no more.
        const std::uint64_t share = stall == Stall::Never ? item_count() : item_count() / 16;
        bench.run(random_source(unit, random, share), stall, 5);
        INFO(bench.report);
        CHECK(bench.mismatches == 0);
        CHECK(bench.stuck == 0);
        compared += bench.compared;
    }
    CHECK(bins.empty() == "");
    CHECK(compared > 0);
}

// A unit without a name in the table is a part of a loop of its test's.
template <class U>
std::string_view latency_name() {
    if constexpr (requires { U::Latency; }) return U::Latency;
    return {};
}

TEST_CASE("the latency is that of the table of the pipe's numbers") {
    const std::string_view name = latency_name<Unit>();
    if (name.empty()) return;
    Unit unit;
    UnitBench<Unit> bench(unit);
    Random random(21);
    bench.run(random_source(unit, random, 300), Stall::Never, 2);
    CHECK(bench.least_latency == pipe_number(name));
}

// Units of which an item may take longer have a test of their own of how long.
template <class U>
constexpr bool takes_each_cycle() {
    if constexpr (requires { U::TakesEachCycle; }) return U::TakesEachCycle;
    return true;
}

TEST_CASE("an item is taken in each cycle where nothing stalls") {
    if (!takes_each_cycle<Unit>()) return;
    Unit unit;
    UnitBench<Unit> bench(unit);
    Random random(23);
    bench.run(random_source(unit, random, 300), Stall::Never, 2);
    CHECK(bench.refused == 0);
    CHECK(bench.compared > 0);
}

TEST_CASE("a reset in mid-stream leaves nothing behind") {
    Unit unit;
    UnitBench<Unit> bench(unit, 9);
    bench.resets_one_in = 50;
    Random random(3);
    bench.run(random_source(unit, random, 5000), Stall::Bursts, 6);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.stuck == 0);
    CHECK(bench.report == "");
    CHECK(bench.compared > 500);
}

TEST_CASE("what flops wake up with reaches no output") {
    Unit unit;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        UnitBench<Unit> bench(unit, seed);
        Random random(seed);
        bench.run(random_source(unit, random, 20), Stall::Never, seed);
        INFO(bench.report);
        CHECK(bench.mismatches == 0);
        CHECK(bench.report == "");
    }
}

TEST_CASE("ready does not see its own valid, and valid not the receiver's ready") {
    Unit unit;
    UnitBench<Unit> bench(unit, 4);
    bench.probes_dependences = true;
    Random random(11);
    bench.run(random_source(unit, random, 3000), Stall::Bursts, 12);
    CHECK(bench.dependences == 0);
    CHECK(bench.mismatches == 0);
}

TEST_CASE("the bench sees one wrong bit") {
    Unit unit;
    UnitBench<Unit> bench(unit, 5);
    Random random(13);
    std::uint64_t corrupted = 0;
    bench.corrupt = [&](Bits& bits) {
        if (!random.one_in(10)) return;
        const unsigned at = random.below(bits.count);
        put(bits, at, 1, take(bits, at, 1) ^ 1);
        ++corrupted;
    };
    const std::string text =
        printed(stderr, [&] { bench.run(random_source(unit, random, 500), Stall::Never, 14); });
    CHECK(corrupted > 0);
    CHECK(bench.mismatches == corrupted);
    // The first of the lines that run a vector again is whole: eight digits a word.
    const std::string line = text.substr(0, text.find('\n')), begin = "FFGPU_RTL_VECTOR=";
    const std::string end = std::string(" build/tests/rtl/rtl_") + Unit::Name + "_test '[again]'";
    const unsigned words = Bits{.count = bits_of<Unit::State>()}.word_count() +
                           Bits{.count = bits_of<Unit::Input>()}.word_count();
    INFO(line);
    CHECK(line.starts_with(begin));
    CHECK(line.ends_with(end));
    CHECK(line.size() == begin.size() + 8 * words + 1 + end.size());
}

// One vector, as a failure printed it: STATE/INPUT in hexadecimal.
TEST_CASE("a vector that failed", "[.][again]") {
    const char* const text = std::getenv("FFGPU_RTL_VECTOR");
    REQUIRE(text != nullptr);
    const std::string vector = text;
    const std::size_t slash = vector.find('/');
    REQUIRE(slash != std::string::npos);
    const auto state =
        from_bits<Unit::State>(bits_from_hex(bits_of<Unit::State>(), vector.substr(0, slash)));
    const auto input =
        from_bits<Unit::Input>(bits_from_hex(bits_of<Unit::Input>(), vector.substr(slash + 1)));
    Unit unit;
    UnitBench<Unit> bench(unit);
    unsigned draws = 1, inputs = 1;
    bench.run({[&] { return draws-- ? std::optional(state) : std::nullopt; },
               [&] { return inputs-- ? std::optional(input) : std::nullopt; }},
              Stall::Never,
              1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared > 0);
}

} // namespace
} // namespace ffgpu::rtl
