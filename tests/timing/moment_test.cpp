// Moments against a plain simulation of the same chains without the resource: what a moment says
// that it saves is what the other run takes less.

#include "model/timing/memory_waits.h"
#include "model/timing/moment.h"
#include "tests/timing/random_work.h"

#include <algorithm>
#include <array>
#include <deque>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr std::array<Resource, 3> Stages{Resource::Setup, Resource::Raster, Resource::Color};

// Items go through three stages, with so many places in the queue before each but the first. A
// stage begins an item when it is done with the one before, the item is there, and there is a place
// behind it for that one.
struct Chain {
    std::vector<std::array<std::uint32_t, 3>> takes; // of each item in each stage
    std::array<std::size_t, 3> places{};
};

Chain random_chain(RandomWork& random) {
    Chain chain;
    for (std::size_t& places : chain.places)
        places = 1 + random.below(4);
    const std::array<std::uint32_t, 3> most{
        1 + random.below(9), 1 + random.below(9), 1 + random.below(9)};
    for (std::size_t item = 0; item < 60; ++item) {
        chain.takes.emplace_back();
        for (std::size_t stage = 0; stage < 3; ++stage)
            chain.takes.back()[stage] = 1 + random.below(most[stage]);
    }
    return chain;
}

// When each stage begins each item, if stage `free` took a cycle for each; 3: none of them.
std::vector<std::array<Cycle, 3>> begins(const Chain& chain, std::size_t free) {
    std::vector<std::array<Cycle, 3>> begin(chain.takes.size());
    const auto takes = [&](std::size_t item, std::size_t stage) {
        return stage == free ? 1 : chain.takes[item][stage];
    };
    for (std::size_t item = 0; item < begin.size(); ++item) {
        for (std::size_t stage = 0; stage < 3; ++stage) {
            Cycle at = 0;
            if (item > 0) at = std::max(at, begin[item - 1][stage] + takes(item - 1, stage));
            if (stage > 0) at = std::max(at, begin[item][stage - 1] + takes(item, stage - 1));
            const std::size_t places = stage < 2 ? chain.places[stage + 1] : 0;
            if (stage < 2 && item > places) at = std::max(at, begin[item - places - 1][stage + 1]);
            begin[item][stage] = at;
        }
    }
    return begin;
}

Saved saved_after(const Dependences& all) {
    Saved saved;
    all.save(saved);
    return saved;
}

Moment moment_of(const Chain& chain,
                 const std::vector<std::array<Cycle, 3>>& begin,
                 const std::vector<std::array<Moment, 3>>& moments,
                 std::size_t item,
                 std::size_t stage) {
    const auto work = [&](std::size_t of, std::size_t in) {
        const auto takes = static_cast<float>(chain.takes[of][in]);
        return Dependence{&moments[of][in], takes, {Stages[in], takes - 1}};
    };
    const Moment start;
    const Cycle at = begin[item][stage];
    Dependences all;
    all.begin(at);
    all.add({&start});
    if (item > 0) all.add(work(item - 1, stage));
    if (stage > 0) all.add(work(item, stage - 1));
    const std::size_t places = stage < 2 ? chain.places[stage + 1] : 0;
    if (stage < 2 && item > places) all.add({&moments[item - places - 1][stage + 1]});
    return {at, 0, saved_after(all)};
}

TEST_CASE("what moments save without a stage's limits is what a run without them takes less") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        RandomWork random(seed);
        const Chain chain = random_chain(random);
        const auto begin = begins(chain, 3);
        std::vector<std::array<Moment, 3>> moments(begin.size());
        for (std::size_t item = 0; item < begin.size(); ++item)
            for (std::size_t stage = 0; stage < 3; ++stage)
                moments[item][stage] = moment_of(chain, begin, moments, item, stage);
        for (std::size_t free = 0; free < 3; ++free) {
            const auto sooner = begins(chain, free);
            for (std::size_t item = 0; item < begin.size(); ++item)
                for (std::size_t stage = 0; stage < 3; ++stage) {
                    CAPTURE(seed, free, item, stage);
                    CHECK(static_cast<double>(moments[item][stage].saved[Stages[free]]) ==
                          static_cast<double>(begin[item][stage] - sooner[item][stage]));
                }
        }
    }
}

TEST_CASE("a wait beyond all that a moment depends on is waited without any resource") {
    Moment first{.at = 10, .path = 0, .saved = {}}, second{.at = 30, .path = 0, .saved = {}};
    first.saved[Resource::Host] = 4;
    second.saved[Resource::Host] = 20;
    // 10 + 5 and 30 + 2 were over in cycle 32; without the host 11 and 12.
    Dependences all;
    const auto depend = [&](Cycle at) {
        all.begin(at);
        all.add({&first, 5});
        all.add({&second, 2});
    };
    for (const Cycle at : {32u, 33u, 500u}) {
        depend(at);
        CHECK(all.last() == 1);
        CHECK(all.least() == static_cast<float>(at - 32));
        CHECK(saved_after(all)[Resource::Host] == 20);
    }
    second.saved[Resource::Host] = 25; // Then the first would be over last.
    depend(32);
    CHECK(saved_after(all)[Resource::Host] == 21);
    CHECK(saved_after(all)[Resource::Clip] == 0);
}

TEST_CASE("vectors save what the plain form does, resource by resource") {
    RandomWork random(1);
    for (int round = 0; round < 2000; ++round) {
        std::vector<Moment> moments(1 + random.below(12));
        Dependences all;
        all.begin(100 + random.below(50));
        const auto part = [&] {
            return Dependence::Part{static_cast<Resource>(random.below(Resources)),
                                    static_cast<float>(random.below(160)) / 16};
        };
        for (Moment& moment : moments) {
            moment.at = random.below(100);
            for (std::size_t i = 0; i < Resources; ++i)
                moment.saved[static_cast<Resource>(i)] =
                    static_cast<float>(random.below(1600)) / 16;
            all.add({&moment, static_cast<float>(random.below(30)), part(), part()});
        }
        if (round % 2 == 0) all.lengthen(all.last(), all.least());
        const Saved plainly = saved_after_plainly(all);
        CHECK(saved_after(all).cycles == plainly.cycles);
        all.save(moments.back().saved); // of one of them
        CHECK(moments.back().saved.cycles == plainly.cycles);
    }
}

TEST_CASE("rare lanes, in which nothing is saved, are left as they are") {
    RandomWork random(2);
    for (int round = 0; round < 500; ++round) {
        std::vector<Moment> moments(1 + random.below(12));
        Dependences all;
        all.leave_out_rare();
        all.begin(100 + random.below(50));
        const auto common = [&] {
            const auto resource = static_cast<Resource>(random.below(Resources));
            return is_rare(resource) ? Resource::Links : resource;
        };
        for (Moment& moment : moments) {
            moment.at = random.below(100);
            for (int i = 0; i < 20; ++i)
                moment.saved[common()] = static_cast<float>(random.below(1600)) / 16;
            all.add({&moment, static_cast<float>(random.below(30)), {common(), 3}, {common(), 2}});
        }
        CHECK(saved_after(all).cycles == saved_after_plainly(all).cycles);
    }
}

// --- The memory ---------------------------------------------------------------------------------

// A read each `pace` cycles, answered `way` + 30 cycles later or `served` after the one before.
struct Reads {
    Cycle pace, served;
    bool waits_for_answer = false; // before the next is asked
};

Moment run(const MemoryConfig& config, const Reads& reads, std::size_t count) {
    MemoryWaits memory(config, true);
    WaitPaths paths;
    paths.restart(0);
    Moment asked{.at = 1, .path = 0, .saved = {}};
    Cycle answered = 0;
    Moment answer;
    const MemoryRequest request{.address = 0, .bytes = 64};
    for (std::size_t i = 0; i < count; ++i) {
        answered = std::max(asked.at + config.latency + 2 + 30, answered + reads.served);
        answer = memory.answer(paths, request, &asked, answered);
        const Dependence on{reads.waits_for_answer ? &answer : &asked, 1};
        const Cycle next = reads.waits_for_answer ? answered + 1 : asked.at + reads.pace;
        Dependences known;
        known.begin(next);
        known.add(on);
        asked = {next, 0, saved_after(known)};
    }
    return answer;
}

MemoryConfig one_channel(std::uint32_t latency) {
    MemoryConfig config;
    config.channels = 1;
    config.latency = latency;
    return config;
}

TEST_CASE("reads that wait for one another gain the way for each, those in a stream one way") {
    const std::uint32_t latency = GENERATE(10u, 100u);
    const MemoryConfig config = one_channel(latency);
    const Moment chain = run(config, {0, 0, true}, 50);
    CHECK(static_cast<double>(chain.saved[Resource::MemoryLatency]) == 50.0 * latency);
    // Asked each cycle and served in 20: the memory is at work all the time.
    const Moment stream = run(config, {1, 20}, 50);
    CHECK(static_cast<double>(stream.saved[Resource::MemoryLatency]) <= latency);
    CHECK(static_cast<double>(stream.saved[Resource::MemoryBandwidth]) >= 49.0 * 19);
    // Asked each 100, served at once: nothing of the memory is gained but the last answer's.
    const Moment seldom = run(config, {100, 0}, 50);
    CHECK(static_cast<double>(seldom.saved[Resource::MemoryLatency]) == latency);
    CHECK(static_cast<double>(seldom.saved[Resource::MemoryBandwidth]) <= 30);
}

} // namespace
} // namespace ffgpu::timing
