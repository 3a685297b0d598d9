// Replacement policies and index hashes on recorded look-ups: known sequences, a brute-force search
// for the fewest misses, and optimal replacement against all others.

#include "model/work/line_replay.h"
#include "model/work/tag_array.h"
#include "tests/work/fewest_misses.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr Replacement All[] = {
    Replacement::Lru, Replacement::Fifo, Replacement::Random, Replacement::Optimal};

std::uint64_t misses(const Trace& trace,
                     std::uint32_t ways,
                     Replacement replacement,
                     std::uint32_t sets = 1,
                     IndexHash hash = IndexHash::Modulo) {
    return count_misses(trace, sets, ways, {replacement, 7, hash});
}

Trace random_trace(std::mt19937& random, std::size_t length, std::uint64_t lines) {
    Trace trace(length);
    for (std::uint64_t& line : trace)
        line = random() % lines;
    return trace;
}

TEST_CASE("the textbook's reference string: 15 faults with FIFO, 12 with LRU, 9 at best") {
    // A. Silberschatz, P. Galvin, G. Gagne, Operating System Concepts, page replacement: 3 frames.
    const Trace string{7, 0, 1, 2, 0, 3, 0, 4, 2, 3, 0, 3, 2, 1, 2, 0, 1, 7, 0, 1};
    CHECK(misses(string, 3, Replacement::Fifo) == 15);
    CHECK(misses(string, 3, Replacement::Lru) == 12);
    CHECK(misses(string, 3, Replacement::Optimal) == 9);
}

TEST_CASE("Belady's anomaly: FIFO misses more often with four places than with three") {
    const Trace string{1, 2, 3, 4, 1, 2, 5, 1, 2, 3, 4, 5};
    CHECK(misses(string, 3, Replacement::Fifo) == 9);
    CHECK(misses(string, 4, Replacement::Fifo) == 10);
}

TEST_CASE("a cycle of one line too many: LRU misses always, optimal once in n - 1") {
    Trace trace;
    for (int i = 0; i < 400; ++i)
        trace.push_back(static_cast<std::uint64_t>(i % 5));
    CHECK(misses(trace, 4, Replacement::Lru) == 400);
    // Five at first, then every fourth look-up.
    CHECK(misses(trace, 4, Replacement::Optimal) == 4 + (400 - 4 + 3) / 4);
}

TEST_CASE("optimal replacement has the fewest misses of any choice of victims") {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const Trace trace = random_trace(random, 6 + random() % 8, 3 + random() % 4);
        const unsigned ways = 1 + static_cast<unsigned>(random() % 4);
        CHECK(misses(trace, ways, Replacement::Optimal) == fewest(trace, 0, {}, ways));
    }
}

TEST_CASE("optimal replacement never misses more than another policy of the same shape") {
    std::mt19937 random(2);
    unsigned better = 0;
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t sets = 1u << random() % 4, ways = 1 + random() % 8;
        const auto hash = static_cast<IndexHash>(random() % 2);
        Trace trace = random_trace(random, 2000, 2 * sets * ways + 1);
        for (std::size_t at = 1; at < trace.size(); ++at) // With locality, as caches have it.
            if (random() % 2) trace[at] = trace[at - 1] + random() % 3;
        const auto optimal = misses(trace, ways, Replacement::Optimal, sets, hash);
        for (const Replacement other : All) {
            CHECK(optimal <= misses(trace, ways, other, sets, hash));
            better += optimal < misses(trace, ways, other, sets, hash);
        }
    }
    CHECK(better > 300);
}

TEST_CASE("random replacement repeats with its seed and differs with another") {
    std::mt19937 random(3);
    const Trace trace = random_trace(random, 5000, 64);
    const auto with_seed = [&](std::uint32_t seed) {
        return count_misses(trace, 4, 8, {Replacement::Random, seed, IndexHash::Modulo});
    };
    CHECK(with_seed(5) == with_seed(5));
    CHECK((with_seed(5) != with_seed(6) || with_seed(5) != with_seed(7)));
    // 32 of 64 equally likely lines are held.
    CHECK(static_cast<double>(with_seed(5)) == Approx(2500).epsilon(0.05));
}

TEST_CASE("random replacement chooses every way about equally often") {
    ReplacementPolicy policy({Replacement::Random, 1, IndexHash::Modulo});
    std::vector<std::uint64_t> stamps(5);
    std::vector<unsigned> chosen(5);
    for (int i = 0; i < 10000; ++i)
        ++chosen[policy.victim(stamps)];
    for (const unsigned n : chosen) // Five standard deviations of a binomial distribution.
        CHECK(n == Approx(2000).margin(5 * 40));
}

TEST_CASE("folding the index spreads a stride that is a multiple of the sets") {
    Trace trace;
    for (int round = 0; round < 4; ++round)
        for (std::uint64_t i = 0; i < 64; ++i)
            trace.push_back(64 * i);
    CHECK(misses(trace, 1, Replacement::Lru, 64, IndexHash::Modulo) == 256);
    CHECK(misses(trace, 1, Replacement::Lru, 64, IndexHash::Xor) == 64);
}

TEST_CASE("both index hashes give each set the same number of lines") {
    for (const IndexHash hash : {IndexHash::Modulo, IndexHash::Xor}) {
        for (const std::uint32_t sets : {1u, 2u, 64u, 1024u}) {
            const SetIndex set_of(sets, hash);
            std::vector<unsigned> lines(sets);
            for (std::uint64_t line = 0; line < 4 * sets; ++line)
                ++lines.at(set_of((std::uint64_t{1} << 28) + line));
            CHECK(std::all_of(lines.begin(), lines.end(), [](unsigned n) { return n == 4; }));
        }
    }
}

TEST_CASE("a dropped line leaves a place that the next line of its set takes") {
    TagArray tags(2, 2);
    TagArray::Evicted evicted;
    for (const std::uint64_t number : {0u, 2u, 1u})
        tags.replace(number, evicted);
    tags.find(0)->dirty = 1;
    tags.drop(*tags.find(2));
    CHECK(tags.find(2) == nullptr);
    tags.replace(4, evicted);
    CHECK(evicted.number == TagArray::Empty);
    tags.replace(6, evicted); // 0 is the least recently used.
    CHECK(evicted.number == 0);
    CHECK(evicted.line.dirty == 1);
    CHECK(tags.find(4) != nullptr);
    CHECK(tags.find(1) != nullptr);
}

} // namespace
} // namespace ffgpu::work
