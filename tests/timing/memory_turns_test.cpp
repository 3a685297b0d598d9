// Requests of several clients at one channel, which without a resource would come in another order.

#include "model/timing/memory_turns.h"

#include <array>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// The channel takes so many cycles for a request behind another, and for one alone.
constexpr std::uint32_t Service = 10, Alone = 20;

// Answered `Service` behind the answer before it, or `Alone` after it was asked.
class Channel {
public:
    // Sooner by so many cycles without the raster unit.
    Saved serve(Cycle asked, float sooner) {
        Moment request{.at = asked};
        request.saved[Resource::Raster] = sooner;
        const Cycle now = std::max(asked + Alone, last_.at + Service);
        const Dependence own{&request, Alone, {Resource::MemoryBandwidth, Alone - 1}};
        const auto takes = static_cast<float>(std::min<Cycle>(now - last_.at, Service));
        const Saved saved =
            turns_.answer(own, {&last_, takes, {Resource::MemoryBandwidth, takes}}, now);
        last_ = {now, 0, saved};
        return saved;
    }
    Cycle answered() const { return last_.at; }

private:
    MemoryTurns turns_;
    Moment last_;
};

float of_raster(const Saved& saved) {
    return saved[Resource::Raster];
}

} // namespace

TEST_CASE("a request that would come before another's does not stand behind it") {
    Channel channel;
    CHECK(of_raster(channel.serve(1000, 0)) == 0);
    REQUIRE(channel.answered() == 1020);
    const float sooner = GENERATE(0.0F, 4.0F, 5.0F, 6.0F, 30.0F, 100.0F);
    // It comes 5 cycles behind the other, and is answered 5 later than it would be alone.
    const Saved second = channel.serve(1005, sooner);
    REQUIRE(channel.answered() == 1030);
    // Behind the other it gains nothing; before it the cycles that it comes sooner and the 5.
    CHECK(of_raster(second) == (sooner > 5 ? sooner + 5 : 0));
}

TEST_CASE("a stream at a channel that stands half its time keeps its pace beside another's") {
    // One client's requests come each 40 cycles, the other's 5 cycles later; without the raster
    // unit these would come each 38 cycles, and their answers, too.
    Channel channel;
    for (std::uint32_t i = 0; i < 100; ++i) {
        CAPTURE(i);
        const Cycle now = 1000 + 40 * i;
        CHECK(of_raster(channel.serve(now, 0)) == 0);
        const auto sooner = static_cast<float>(2 * i);
        const float gained = of_raster(channel.serve(now + 5, sooner));
        // Where they come just behind one of the other's they wait for it, 10 cycles at the most.
        CHECK(gained >= sooner - Service);
        CHECK(gained <= sooner + 5);
    }
}

TEST_CASE("turns by vectors are those one after the other") {
    std::mt19937_64 random(7);
    const auto cycles = [&](std::uint32_t most) {
        return static_cast<float>(random() % (16 * most)) / 16;
    };
    const auto fill = [&](Saved& saved, std::uint32_t most) {
        for (float& each : saved.cycles)
            each = cycles(most);
    };
    for (int i = 0; i < 500; ++i) {
        std::vector<AnsweredRequest> one(random() % 17);
        for (AnsweredRequest& each : one) {
            fill(each.asked_saved, 40);
            fill(each.answer_saved, 40);
            fill(each.idle, 10);
        }
        std::vector<AnsweredRequest> two = one;
        std::vector<RequestInTurn::Before> before;
        for (AnsweredRequest& each : one)
            before.push_back({&each, cycles(30), cycles(20), before.size() > one.size() / 2});
        Saved asked, alone;
        fill(asked, 40);
        fill(alone, 60);
        RequestInTurn request{asked, alone, cycles(12), before};
        const SavedInTurn plain = saved_in_turn_plainly(request);
        for (std::size_t k = 0; k < two.size(); ++k)
            before[k].answered = &two[k];
        request.has_rare = i % 4 != 0;
        const SavedInTurn vectors = saved_in_turn(request);
        if (!request.has_rare) {
            const auto first = [](const Saved& saved) {
                return std::vector(saved.cycles.begin(), saved.cycles.begin() + Saved::FirstLanes);
            };
            CHECK(first(plain.answer) == first(vectors.answer));
            CHECK(first(plain.idle) == first(vectors.idle));
            continue;
        }
        CHECK(plain.answer.cycles == vectors.answer.cycles);
        CHECK(plain.idle.cycles == vectors.idle.cycles);
        for (std::size_t k = 0; k < two.size(); ++k) {
            CHECK(one[k].idle.cycles == two[k].idle.cycles);
            CHECK(one[k].answer_saved.cycles == two[k].answer_saved.cycles);
        }
    }
}

} // namespace ffgpu::timing
