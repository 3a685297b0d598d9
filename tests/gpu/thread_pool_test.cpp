// The pool: each job once, the caller free in between, failures told where they are waited for.

#include "model/gpu/thread_pool.h"

#include <algorithm>
#include <atomic>
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
