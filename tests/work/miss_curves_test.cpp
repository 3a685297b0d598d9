// Curves of all shapes from one pass against a plain cache of each shape.

#include "model/work/miss_curves.h"
#include "tests/work/plain_cache.h"

#include <numeric>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

using test::PlainCache;

// A look-up, or what comes between.
struct Event {
    enum class Kind : std::uint8_t { LookUp, Overwrite, Flush, EndFrame };
    Kind kind = Kind::LookUp;
    std::uint64_t line = 0;
    bool flag = false; // it writes; all of the line is overwritten
};

// Lines in loops and at random, so that there is reuse at all distances.
std::vector<Event> events(unsigned seed, unsigned count, unsigned lines, unsigned disturb) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    std::vector<Event> all;
    std::uint64_t at = 0;
    while (all.size() < count) {
        const unsigned length = 1 + below(20);
        if (below(3) == 0) at = below(lines);
        for (unsigned i = 0; i < length; ++i)
            all.push_back({Event::Kind::LookUp, (at + i / 2) % lines, below(4) == 0});
        if (below(4) == 0) at = (at + length) % lines;
        if (disturb > 0 && below(disturb) == 0)
            all.push_back({Event::Kind::Overwrite, below(lines), below(2) == 0});
        if (disturb > 0 && below(8 * disturb) == 0) all.push_back({Event::Kind::Flush, 0, false});
        if (below(50) == 0) all.push_back({Event::Kind::EndFrame, 0, false});
    }
    all.push_back({Event::Kind::Flush, 0, false});
    return all;
}

void play(const std::vector<Event>& events, MissCurves& curves) {
    LookupPlace place;
    for (const Event& event : events) {
        switch (event.kind) {
        case Event::Kind::LookUp: {
            const LineLookup lookup{event.line, event.flag};
            curves.lookups(place, {&lookup, 1});
            place.began[0] = ++place.number;
            break;
        }
        case Event::Kind::Overwrite: {
            const OverwrittenLine line{event.line, event.flag};
            curves.overwritten({&line, 1});
            break;
        }
        case Event::Kind::Flush:
            curves.flush();
            break;
        case Event::Kind::EndFrame:
            curves.end_frame();
            place.began.fill(place.number);
        }
    }
}

void play(const std::vector<Event>& events, PlainCache& cache) {
    for (const Event& event : events) {
        if (event.kind == Event::Kind::LookUp) cache.access(event.line, event.flag);
        if (event.kind == Event::Kind::Overwrite) cache.overwrite(event.line, event.flag);
        if (event.kind == Event::Kind::Flush) cache.flush();
    }
}

void check_equal(const CacheCounts& ours, const test::PlainCounts& plain) {
    CHECK(ours.accesses == plain.accesses);
    CHECK(ours.misses == plain.misses);
    CHECK(ours.compulsory == plain.compulsory);
    CHECK(ours.capacity == plain.capacity);
    CHECK(ours.conflict == plain.conflict);
    CHECK(ours.hits_beyond_lru == plain.hits_beyond_lru);
    CHECK(ours.write_backs == plain.write_backs);
    CHECK(std::accumulate(ours.by_reuse.begin(), ours.by_reuse.end(), ours.compulsory) ==
          ours.misses);
}

TEST_CASE("curves of one pass equal a plain cache of each shape", "[curves]") {
    for (const unsigned disturb : {0u, 30u, 3u}) {
        const std::vector<Event> all = events(disturb + 1, 6000, 150, disturb);
        MissCurves curves({.most_sets = 8, .most_ways = 20});
        play(all, curves);
        for (std::uint32_t sets = 1; sets <= 8; sets *= 2)
            for (const std::uint32_t ways : {1u, 2u, 3u, 7u, 8u, 9u, 17u, 20u}) {
                INFO("disturbed " << disturb << ": " << sets << " sets, " << ways << " ways");
                PlainCache plain(sets, ways);
                play(all, plain);
                check_equal(curves.sums().counts(sets, ways), plain.counts);
            }
    }
}

// No look-up before `writes_from` writes.
std::vector<Event> read_only(std::vector<Event> events, std::size_t writes_from) {
    for (Event& event : events) {
        if (writes_from-- == 0) break;
        if (event.kind == Event::Kind::LookUp) event.flag = false;
    }
    return events;
}

TEST_CASE("look-ups that only read, and begin to write late, equal a plain cache", "[curves]") {
    constexpr std::size_t Never = ~std::size_t{0};
    for (const std::size_t writes_from : {Never, std::size_t{3000}})
        for (const unsigned lines : {12u, 40u, 400u}) {
            std::vector<Event> all = read_only(events(lines, 6000, lines, 0), writes_from);
            all.insert(all.begin() + 2000, Event{Event::Kind::Flush, 0, false});
            MissCurves curves({.most_sets = 16, .most_ways = 20});
            play(all, curves);
            for (std::uint32_t sets = 1; sets <= 16; sets *= 2)
                for (const std::uint32_t ways : {1u, 2u, 3u, 5u, 8u, 15u, 16u, 17u, 20u}) {
                    INFO(lines << " lines, " << sets << " sets, " << ways << " ways");
                    PlainCache plain(sets, ways);
                    play(all, plain);
                    check_equal(curves.sums().counts(sets, ways), plain.counts);
                }
        }
}

TEST_CASE("lines that are only read, and thrown out, equal a plain cache", "[curves]") {
    for (const unsigned disturb : {30u, 3u, 1u})
        for (const unsigned lines : {12u, 40u, 400u}) {
            const std::vector<Event> all =
                read_only(events(disturb + lines, 6000, lines, disturb), ~std::size_t{0});
            MissCurves curves({.most_sets = 16, .most_ways = 20, .only_reads = true});
            play(all, curves);
            for (std::uint32_t sets = 1; sets <= 16; sets *= 2)
                for (const std::uint32_t ways : {1u, 2u, 3u, 5u, 8u, 15u, 16u, 17u, 20u}) {
                    INFO("disturbed " << disturb << ", " << lines << " lines: " << sets << " sets, "
                                      << ways << " ways");
                    PlainCache plain(sets, ways);
                    play(all, plain);
                    check_equal(curves.sums().counts(sets, ways), plain.counts);
                }
        }
}

// Three quads' look-ups, each told by many quads in turn: once by once, and again at once.
TEST_CASE("look-ups that many quads repeat are told at once", "[curves]") {
    const std::vector<std::vector<LineLookup>> lists{
        {{1}, {5}, {2}, {40}}, {{5}}, {{2}, {9}, {1}, {33}, {2}}};
    for (const bool merges : {true, false})
        for (const std::uint32_t line_bytes : {16u, 64u}) {
            const CurvesShape shape{.line_bytes = line_bytes,
                                    .lookup_bytes = 16,
                                    .most_sets = 8,
                                    .most_ways = 6,
                                    .merges = merges,
                                    .only_reads = true};
            MissCurves one_by_one(shape), at_once(shape);
            LookupPlace place;
            for (unsigned round = 0; round < 6; ++round) {
                const std::vector<LineLookup>& lines = lists[round % lists.size()];
                place.begin(Reuse::Tile);
                one_by_one.lookups(place, lines);
                at_once.lookups(place, lines);
                for (unsigned i = 0; i <= round; ++i) {
                    ++place.number;
                    place.begin(Reuse::Quad);
                    one_by_one.lookups(place, lines);
                }
                at_once.lookups_again(place, lines, round + 1);
                ++place.number;
            }
            for (std::uint32_t sets = 1; sets <= 8; sets *= 2)
                for (std::uint32_t ways = 1; ways <= 6; ++ways)
                    CHECK(at_once.sums().counts(sets, ways) ==
                          one_by_one.sums().counts(sets, ways));
        }
}

TEST_CASE("fully associative caches of any size, past the first window of times", "[curves]") {
    const std::vector<Event> all = events(7, 80000, 3000, 400);
    MissCurves curves({.most_sets = 1, .most_ways = 1});
    play(all, curves);
    for (const std::uint32_t ways : {1u, 17u, 100u, 999u, 2999u, 3000u, 5000u}) {
        INFO(ways << " lines");
        PlainCache plain(1, ways);
        play(all, plain);
        check_equal(curves.sums().counts(1, ways), plain.counts);
    }
}

// Four lines in a cycle, by hand.
TEST_CASE("a cycle of four lines misses always in three ways and never again in four", "[curves]") {
    MissCurves curves({.most_sets = 4, .most_ways = 4});
    std::vector<Event> all;
    for (unsigned i = 0; i < 40; ++i)
        all.push_back({Event::Kind::LookUp, i % 4, false});
    play(all, curves);
    CHECK(curves.sums().counts(1, 3).misses == 40);
    CHECK(curves.sums().counts(1, 3).capacity == 36);
    CHECK(curves.sums().counts(1, 4).misses == 4);
    CHECK(curves.sums().counts(2, 1).misses == 40);
    CHECK(curves.sums().counts(2, 1).capacity == 36); // Two lines hold none of the cycle either.
    CHECK(curves.sums().counts(4, 1).misses == 4);
}

TEST_CASE("lines of several sizes from one walk, merged in a quad or not", "[curves]") {
    const std::vector<LineLookup> quad{{0, false}, {2, true}, {1, false}, {3, false}, {5, false}};
    const auto accesses = [&](std::uint32_t line_bytes, bool merges) {
        MissCurves curves({.line_bytes = line_bytes, .lookup_bytes = 16, .merges = merges});
        curves.lookups({}, quad);
        return curves.sums().counts(1, 1).accesses;
    };
    CHECK(accesses(16, true) == 5);
    CHECK(accesses(32, true) == 3);  // 0, 1, 2
    CHECK(accesses(32, false) == 5); // 0, 1, 0, 1, 2
    CHECK(accesses(64, true) == 2);
    CHECK(accesses(64, false) == 2); // Runs are one.
}

TEST_CASE("a line that is overwritten in parts is whole if all parts are", "[curves]") {
    const auto write_backs = [](const std::vector<OverwrittenLine>& parts) {
        MissCurves curves({.line_bytes = 64, .lookup_bytes = 32});
        const LineLookup lookup{7, true};
        curves.lookups({}, {&lookup, 1});
        curves.overwritten(parts);
        curves.flush();
        return curves.sums().counts(1, 1).write_backs;
    };
    CHECK(write_backs({}) == 1);
    CHECK(write_backs({{6, true}, {7, true}}) == 0);
    CHECK(write_backs({{6, true}, {7, false}}) == 1);
    CHECK(write_backs({{7, true}}) == 1);
    CHECK(write_backs({{4, true}, {5, true}}) == 1); // of another line
}

TEST_CASE("a miss is told by the narrowest scope since the line's last use", "[curves]") {
    MissCurves curves({.most_sets = 1, .most_ways = 1});
    const LineLookup one{1, false}, other{2, false};
    // Quad 10 of the tile from 9, the primitive from 7, the draw from 5, the frame from 3.
    const std::array<std::uint64_t, ReuseScopes> began{10, 9, 7, 5, 3};
    for (const std::uint64_t last : {10u, 9u, 8u, 6u, 4u, 2u}) {
        curves.lookups({.number = last}, {&one, 1});
        curves.lookups({.number = last}, {&other, 1});
        curves.lookups({.number = 10, .began = began}, {&one, 1});
        curves.flush();
    }
    const CacheCounts counts = curves.sums().counts(1, 1);
    CHECK(counts.by_reuse == std::array<std::uint64_t, ReuseScopes + 1>{1, 1, 1, 1, 1, 1});
    CHECK(counts.compulsory == 12);
    CHECK(counts.misses == 18);
}

TEST_CASE("the working set of a frame are its different lines", "[curves]") {
    MissCurves curves({});
    LookupPlace place;
    const auto look_up = [&](std::uint64_t line) {
        const LineLookup lookup{line, false};
        curves.lookups(place, {&lookup, 1});
        ++place.number;
    };
    for (const std::uint64_t line : {1u, 2u, 1u, 3u})
        look_up(line);
    curves.flush(); // The same line again is no other one.
    look_up(3);
    curves.end_frame();
    place.began.fill(place.number);
    look_up(2);
    curves.end_frame();
    CHECK(curves.frame_lines() == std::vector<std::uint64_t>{3, 1});
}

} // namespace
} // namespace ffgpu::work
