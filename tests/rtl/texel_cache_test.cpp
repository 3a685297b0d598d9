// rtl/texel_cache.sv, before a memory that answers in any order, against the model's tags and the
// memory's closed form.

#include "Vtexel_cache_loop.h"
#include "model/work/tag_array.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct TexelRead {
    bool tag = false;
    std::uint16_t place = 0;
    std::uint32_t address = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("address", self.address, 32);
    }
};

struct TexelData {
    bool tag = false;
    std::uint16_t place = 0;
    bool missed = false;
    std::array<std::uint32_t, 4> block{};
    std::uint8_t way = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("missed", self.missed, 1);
        visit_lanes(field, "block", self.block, 32);
        field("way", self.way, 2);
    }
};

struct TexelCache {
    static constexpr const char* Name = "texel_cache";
    static constexpr bool TakesEachCycle = false;
    static constexpr std::uint64_t ShortItems = 150000, LongItems = 10000000;
    static constexpr std::uint32_t Sets = 4, Ways = 4, LineBits = 6; // as in texel_cache_loop.sv

    using Dut = Vtexel_cache_loop;
    using State = NoState;
    using Input = TexelRead;
    using Output = TexelData;

    static void set_tag(TexelRead& read, unsigned tag) { read.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    // Steps through an image, lines that come again soon or late, lines far away, and such whose
    // number is another one's but for a bit.
    TexelRead random_input(Random& random, const State&) {
        if (random.one_in(50)) at_ = random.word();
        if (random.one_in(6)) at_ += (random.below(9) - 4) << (LineBits + random.below(4));
        at_ += 16 * (random.below(3) - 1);
        std::uint32_t address =
            random.one_in(3) ? 0x4000 + (random.below(24) << LineBits) + random.below(64) : at_;
        if (random.one_in(16)) address ^= 1u << (LineBits + random.below(32 - LineBits));
        return {.place = static_cast<std::uint16_t>(random.below(1024)), .address = address};
    }

    static void declare(Bins& bins) {
        bins.declare("set", Sets);
        bins.declare("block", 4);
        bins.declare("hit, miss in an empty place, miss that evicts", 3);
        bins.declare("hit in a line that was used last, earlier", 2);
    }
    void cover(Bins& bins, const State&, const TexelRead& read) {
        bins.hit("set", read.address >> LineBits & (Sets - 1));
        bins.hit("block", read.address >> 4 & 3);
        bins.hit("hit, miss in an empty place, miss that evicts", !missed_ ? 0 : evicted_ ? 2 : 1);
        const std::uint32_t line = read.address >> LineBits;
        if (!missed_) bins.hit("hit in a line that was used last, earlier", line != last_);
        last_ = line;
    }

    void reset() { tags_ = work::TagArray(Sets, Ways); }
    void expect(const State&, const TexelRead& read, std::vector<TexelData>& outputs) {
        const std::uint32_t line = read.address >> LineBits;
        work::TagArray::Line* at = tags_.find(line);
        missed_ = at == nullptr;
        if (missed_) {
            work::TagArray::Evicted evicted;
            at = &tags_.replace(line, evicted);
            evicted_ = evicted.number != work::TagArray::Empty;
        } else {
            tags_.use(*at);
        }
        TexelData data{.tag = read.tag,
                       .place = read.place,
                       .missed = missed_,
                       .way = static_cast<std::uint8_t>(tags_.place(*at) % Ways)};
        for (std::uint32_t i = 0; i < 4; ++i)
            data.block[i] = ((read.address & ~15u) + 4 * i) * 0x9e3779b1u;
        outputs.push_back(data);
    }

private:
    work::TagArray tags_{Sets, Ways};
    std::uint32_t at_ = 0, last_ = 0;
    bool missed_ = false, evicted_ = false;
};
using Unit = TexelCache;

// Cycles for reads of these addresses, one after the other.
std::uint64_t cycles_for(const std::vector<std::uint32_t>& addresses) {
    TexelCache unit;
    UnitBench<TexelCache> bench(unit);
    const auto state = [](unsigned) { return NoState{}; };
    const auto input = [&](unsigned, unsigned i) { return TexelRead{.address = addresses[i]}; };
    const auto count = static_cast<unsigned>(addresses.size());
    bench.run(counted_source<TexelCache>(1, count, state, input), Stall::Never, 1);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == count);
    return bench.cycles();
}

TEST_CASE(
    "a read takes a cycle where lines are there, and lines are asked for before others come") {
    constexpr unsigned Count = 1000;
    std::vector<std::uint32_t> addresses;
    const std::uint64_t first = cycles_for({0});
    for (unsigned i = 0; i < Count; ++i)
        addresses.push_back(16 * (i % 4));
    CHECK(cycles_for(addresses) == first + Count - 1);
    // No line twice: the memory gives one of eight in about eight cycles, and one alone in 32.
    for (unsigned i = 0; i < Count; ++i)
        addresses[i] = i << TexelCache::LineBits;
    CHECK(cycles_for(addresses) < 16 * Count);
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
