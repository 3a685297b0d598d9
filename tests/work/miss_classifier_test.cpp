// The three kinds of miss over random look-ups, flushes and discards, against a model that only
// keeps a list.

#include "model/work/miss_classifier.h"
#include "model/work/tag_array.h"

#include <algorithm>
#include <deque>
#include <random>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// Lines of a fully associative cache, most recently used first, and all that were touched.
struct NaiveShadow {
    std::size_t capacity;
    std::deque<std::uint64_t> held{};
    std::set<std::uint64_t> touched{};

    // Whether the line was held, and touched, before.
    std::pair<bool, bool> access(std::uint64_t line) {
        const auto at = std::find(held.begin(), held.end(), line);
        const bool hit = at != held.end();
        if (hit) held.erase(at);
        held.push_front(line);
        if (held.size() > capacity) held.pop_back();
        return {hit, !touched.insert(line).second};
    }
    void drop(std::uint64_t line) {
        held.erase(std::remove(held.begin(), held.end(), line), held.end());
        touched.erase(line);
    }
    void flush() {
        held.clear();
        touched.clear();
    }
};

struct Counts {
    unsigned hits = 0, compulsory = 0, capacity = 0, conflict = 0;
};

// Look-ups with locality, now and then a discarded line or range or a flush, of a cache that does
// the same, checked step by step.
Counts run(std::uint32_t sets, std::uint32_t ways, Replacement replacement, unsigned seed) {
    std::mt19937 random(seed);
    TagArray tags(sets, ways, {replacement, seed, IndexHash::Modulo});
    MissClassifier classifier(sets, ways);
    NaiveShadow naive{std::size_t{sets} * ways};
    Counts counts;
    const auto drop = [&](std::uint64_t line) {
        if (TagArray::Line* held = tags.find(line)) tags.drop(*held);
        classifier.drop(line);
        naive.drop(line);
    };
    std::uint64_t line = 0;
    for (int i = 0; i < 3000; ++i) {
        if (random() % 500 == 0) {
            tags.for_each([&](std::uint64_t, TagArray::Line& held) { tags.drop(held); });
            classifier.flush();
            naive.flush();
        }
        if (random() % 20 == 0) drop(random() % (3 * sets * ways));
        line = random() % 3 ? line + random() % 3 : random() % (3 * sets * ways);
        const auto [shadow_hit, touched] = naive.access(line);
        const MissKind kind = classifier.access(line);
        REQUIRE(classifier.shadow_missed() == !shadow_hit);
        if (const TagArray::Line* held = tags.find(line)) {
            tags.use(*held);
            ++counts.hits;
            continue;
        }
        TagArray::Evicted evicted;
        tags.replace(line, evicted);
        const MissKind expected = !touched                  ? MissKind::Compulsory
                                  : shadow_hit && sets != 1 ? MissKind::Conflict
                                                            : MissKind::Capacity;
        REQUIRE(kind == expected);
        ++(kind == MissKind::Compulsory ? counts.compulsory
           : kind == MissKind::Capacity ? counts.capacity
                                        : counts.conflict);
    }
    CHECK(counts.hits + counts.compulsory + counts.capacity + counts.conflict == 3000);
    return counts;
}

TEST_CASE("a fully associative cache never has a conflict miss, whatever is flushed or dropped") {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const auto replacement = static_cast<Replacement>(seed % 3);
        const Counts counts = run(1, 1 + seed % 17, replacement, seed);
        CHECK(counts.conflict == 0);
    }
}

TEST_CASE("a fully associative LRU cache hits exactly where the shadow hits") {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        std::mt19937 random(seed);
        const std::uint32_t ways = 1 + seed % 9;
        TagArray tags(1, ways);
        MissClassifier classifier(1, ways);
        for (int i = 0; i < 2000; ++i) {
            const std::uint64_t line = random() % (2 * ways);
            if (random() % 8 == 0) {
                if (TagArray::Line* held = tags.find(line)) tags.drop(*held);
                classifier.drop(line);
                continue;
            }
            classifier.access(line);
            const TagArray::Line* held = tags.find(line);
            REQUIRE((held == nullptr) == classifier.shadow_missed());
            TagArray::Evicted evicted;
            held ? tags.use(*held) : static_cast<void>(tags.replace(line, evicted));
        }
    }
}

TEST_CASE("the kinds of a set-associative cache are those of the list model") {
    unsigned conflicts = 0;
    for (unsigned seed = 1; seed <= 60; ++seed)
        conflicts +=
            run(1u << (1 + seed % 4), 1 + seed % 4, static_cast<Replacement>(seed % 3), seed)
                .conflict;
    CHECK(conflicts > 1000);
}

} // namespace
} // namespace ffgpu::work
