// The reader's thread: order, failures, an end in the middle.

#include "model/base/input_error.h"
#include "model/work/job_pool.h"
#include "model/work/sink_thread.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

class Reader : public WorkSink {
public:
    void bin(std::shared_ptr<const WorkBin> bin) override {
        numbers.push_back(bin->draws.at(0).number);
        if (numbers.back() == fails_at) throw InputError("the disk is full");
    }
    void end_frame(std::uint32_t frame) override { numbers.push_back(1000000 + frame); }

    std::vector<std::uint32_t> numbers;
    std::uint32_t fails_at = ~0u;
};

// Of many quads, so that few fit the queue.
std::shared_ptr<const WorkBin> bin(std::uint32_t number) {
    auto work = std::make_shared<WorkBin>();
    work->draws.emplace_back().number = number;
    work->tiles.emplace_back().batches.emplace_back().quads.resize(1 << 16);
    return work;
}

void check_order(JobPool* pool) {
    Reader reader;
    std::vector<std::uint32_t> expected;
    std::size_t seen = 0;
    {
        SinkThread thread(reader, pool);
        for (std::uint32_t i = 0; i < 50; ++i) {
            thread.bin(bin(i));
            expected.push_back(i);
        }
        thread.post([&] { seen = reader.numbers.size(); });
        thread.drain();
        CHECK(seen == 50);
        CHECK(reader.numbers == expected);
        thread.bin(bin(50));
        thread.end_frame(3);
    } // It waits here.
    expected.push_back(50);
    expected.push_back(1000003);
    CHECK(reader.numbers == expected);
}

TEST_CASE("All is read once, in order, on a thread of its own and in a pool") {
    JobPool none(0), two(2);
    for (JobPool* const pool : {static_cast<JobPool*>(nullptr), &none, &two})
        check_order(pool);
}

TEST_CASE("What the reader throws comes out of drain() once, and nothing is read after it") {
    Reader reader;
    reader.fails_at = 3;
    SinkThread thread(reader);
    for (std::uint32_t i = 0; i < 40; ++i)
        thread.bin(bin(i)); // Goes on, though nobody reads.
    CHECK_THROWS_WITH(thread.drain(), "the disk is full");
    CHECK_NOTHROW(thread.drain());
    CHECK(reader.numbers == std::vector<std::uint32_t>{0, 1, 2, 3});
}

} // namespace
} // namespace ffgpu::work
