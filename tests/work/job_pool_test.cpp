// A pool's orders: each in its own order, with any number of threads, bounded, and without one
// waiting for itself.

#include "model/base/input_error.h"
#include "model/work/job_pool.h"

#include <atomic>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

std::vector<int> numbers_to(int end) {
    std::vector<int> numbers(static_cast<std::size_t>(end));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

} // namespace

TEST_CASE("Jobs of three stages come in order, on any number of threads", "[job_pool]") {
    for (const unsigned threads : {0u, 1u, 2u, 5u}) {
        INFO(threads << " threads");
        std::vector<int> first, second, third;
        {
            JobPool pool(threads);
            JobPool::Order last(pool, 2, 3), middle(pool, 1, 2), front(pool, 0, 4);
            for (int i = 0; i < 2000; ++i)
                front.push(1, [&, i] {
                    first.push_back(i);
                    middle.push(1, [&, i] {
                        second.push_back(i);
                        last.push(1, [&, i] { third.push_back(i); });
                    });
                });
            front.drain();
            CHECK(first == numbers_to(2000));
            middle.drain();
            CHECK(second == numbers_to(2000));
            last.drain();
        }
        CHECK(third == numbers_to(2000));
    }
}

TEST_CASE("Two orders of one stage that feed another each do not wait for each other",
          "[job_pool]") {
    std::atomic<int> done = 0;
    JobPool pool(2);
    JobPool::Order ends[2] = {{pool, 1, 1}, {pool, 1, 1}};
    JobPool::Order begins[2] = {{pool, 0, 1}, {pool, 0, 1}};
    for (int i = 0; i < 3000; ++i)
        begins[i % 2].push(1, [&, i] { ends[(i + 1) % 2].push(1, [&] { ++done; }); });
    for (JobPool::Order& order : begins)
        order.drain();
    for (JobPool::Order& order : ends)
        order.drain();
    CHECK(done == 3000);
}

TEST_CASE("No more than fit wait, and one always fits", "[job_pool]") {
    int handed_over = 0, most_ahead = 0, done = 0;
    JobPool pool(0); // All is done by who waits.
    JobPool::Order order(pool, 0, 10);
    for (; handed_over < 100; ++handed_over) {
        order.push(3, [&] { ++done; });
        most_ahead = std::max(most_ahead, handed_over + 1 - done);
    }
    CHECK(most_ahead == 3); // of weight 3, in 10
    order.push(1000, [&] { ++done; });
    order.drain();
    CHECK(done == 101);
}

TEST_CASE("What a job throws comes out once; what follows it is dropped, in its order alone",
          "[job_pool]") {
    int done = 0, others = 0;
    JobPool pool(1);
    JobPool::Order other(pool, 0, 100), order(pool, 0, 100);
    for (int i = 0; i < 10; ++i) {
        order.push(1, [&, i] {
            if (i == 4) throw InputError("the disk is full");
            ++done;
        });
        other.push(1, [&] { ++others; });
    }
    CHECK_THROWS_WITH(order.drain(), "the disk is full");
    CHECK_NOTHROW(order.drain());
    CHECK_NOTHROW(order.check_failure());
    order.push(1, [&] { ++done; });
    order.drain();
    other.drain();
    CHECK(done == 4);
    CHECK(others == 10);
}

} // namespace ffgpu::work
