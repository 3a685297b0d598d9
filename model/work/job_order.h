// JobOrder: jobs that are done one after another, in the order in which they were handed over,
// behind a bounded queue.
//
// What a job throws comes out of drain() or check_failure(); jobs handed over after it are dropped.

#pragma once

#include <cstddef>
#include <functional>

namespace ffgpu::work {

class JobOrder {
public:
    virtual ~JobOrder() = default;

    // Jobs wait up to a sum of weights; one fits always, however heavy it is. Waits for room.
    virtual void push(std::size_t weight, std::function<void()> run) = 0;

    // Returns when all is done.
    virtual void drain() = 0;
    // Throws what a job threw, once.
    virtual void check_failure() = 0;
};

} // namespace ffgpu::work
