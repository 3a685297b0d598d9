// The pool: each job once, the caller free in between, failures told where they are waited for.

#include "model/gpu/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;

TEST_CASE("a pool runs each job once, whatever the number of threads") {
    for (const unsigned threads : {1u, 2u, 4u}) {
        ThreadPool pool(threads);
        CHECK(pool.threads() == threads);
        for (std::size_t count = 0; count < 200; ++count) {
            std::vector<std::atomic<int>> runs(count);
            pool.start(count, [&](unsigned worker, std::size_t i) {
                if (worker < threads) ++runs[i];
            });
            pool.wait();
            REQUIRE(std::all_of(runs.begin(), runs.end(), [](const auto& n) { return n == 1; }));
        }
        pool.wait(); // Nothing is under way.
    }
}

TEST_CASE("a pool's other threads work while the caller goes on") {
    ThreadPool pool(2);
    std::atomic<bool> begun = false, let_go = false;
    pool.start(1, [&](unsigned, std::size_t) {
        begun = true;
        while (!let_go)
            std::this_thread::yield();
    });
    while (!begun) // Would never end, did the caller have to wait.
        std::this_thread::yield();
    let_go = true;
    pool.wait();
}

TEST_CASE("a pool that may not share now lets the caller do all") {
    bool may_share = false;
    ThreadPool pool(3, [&] { return may_share; });
    CHECK_FALSE(pool.shares());
    unsigned by_caller = 0;
    pool.run(50, [&](unsigned worker, std::size_t) { by_caller += worker == 0; });
    CHECK(by_caller == 50);
    may_share = true;
    CHECK(pool.shares());
}

TEST_CASE("a job that fails is told of by wait, and the pool goes on") {
    for (const unsigned threads : {1u, 3u}) {
        ThreadPool pool(threads);
        for (int n = 0; n < 50; ++n) {
            std::atomic<unsigned> runs = 0;
            pool.start(100, [&](unsigned, std::size_t i) {
                ++runs;
                if (i == 10) throw std::runtime_error("job " + std::to_string(i));
            });
            CHECK_THROWS_WITH(pool.wait(), "job 10");
            CHECK(runs >= 11);
            runs = 0;
            pool.run(7, [&](unsigned, std::size_t) { ++runs; });
            CHECK(runs == 7);
        }
    }
}

TEST_CASE("threads that keep the caller waiting are left out for a while") {
    using std::chrono::milliseconds;
    ThreadPool pool(2);
    std::atomic<bool> other_sleeps = false;
    pool.run(2, [&](unsigned worker, std::size_t) {
        if (worker != 0) {
            other_sleeps = true;
            std::this_thread::sleep_for(milliseconds(100)); // as one that has no processor
        }
        while (!other_sleeps)
            std::this_thread::yield();
    });
    // Five seconds of rest, about; jobs take their time, so that others would come for them.
    std::atomic<unsigned> of_others = 0;
    pool.run(50, [&](unsigned worker, std::size_t) {
        if (worker != 0) ++of_others;
        std::this_thread::sleep_for(milliseconds(1));
    });
    CHECK(of_others == 0);
}

TEST_CASE("a caller that sleeps while others work has lost nothing") {
    using std::chrono::milliseconds;
    ThreadPool pool(2);
    for (int i = 0; i < 3; ++i) {
        pool.start(2, [](unsigned, std::size_t) {});
        std::this_thread::sleep_for(milliseconds(20)); // as a program between two frames
        pool.wait();
        CHECK(pool.shares());
    }
}

TEST_CASE("sharing pays until waiting has cost more than others have helped") {
    using namespace std::chrono_literals;
    ThreadBenefit benefit;
    const ThreadBenefit::Clock::time_point begin{100s};
    CHECK(benefit.pays(begin));
    benefit.add(3ms, 1ms, begin); // 2 ms won,
    benefit.add(0ms, 3ms, begin); // and 1 ms lost in all: as much as is borne
    CHECK(benefit.pays(begin));
    benefit.add(1ms, 3ms, begin); // 3 ms lost: 150 ms of rest
    CHECK_FALSE(benefit.pays(begin + 149ms));
    CHECK(benefit.pays(begin + 150ms));

    // What was lost is paid for; of what was won long ago 4 ms count.
    benefit.add(1000ms, 0ms, begin + 200ms);
    benefit.add(0ms, 5ms, begin + 200ms);
    CHECK(benefit.pays(begin + 200ms));
    benefit.add(0ms, 1ms, begin + 200ms);
    CHECK_FALSE(benefit.pays(begin + 299ms));
    CHECK(benefit.pays(begin + 300ms));
}

TEST_CASE("who loses again and again rests longer each time, until sharing has paid") {
    using namespace std::chrono_literals;
    ThreadBenefit benefit;
    ThreadBenefit::Clock::time_point now{100s};
    for (const auto rest : {100ms, 200ms, 400ms, 800ms, 800ms}) {
        benefit.add(1ms, 3ms, now); // 2 ms lost
        CHECK_FALSE(benefit.pays(now + rest - 1ms));
        CHECK(benefit.pays(now + rest));
        now += rest;
    }
    benefit.add(3ms, 0ms, now);
    benefit.add(0ms, 5ms, now);
    CHECK_FALSE(benefit.pays(now + 799ms));
    now += 800ms;
    benefit.add(4ms, 0ms, now);
    benefit.add(0ms, 6ms, now);
    CHECK_FALSE(benefit.pays(now + 99ms));
    CHECK(benefit.pays(now + 100ms));
}
