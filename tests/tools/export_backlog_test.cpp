// What waits for a slow writer of an export is bounded: the machine waits for it.

#include "tools/export/memory_trace.h"

#include <atomic>
#include <chrono>
#include <latch>
#include <memory>
#include <thread>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

// Writes nothing before it may.
class SlowFormat final : public MemoryFormat {
public:
    explicit SlowFormat(std::latch& may_write)
        : may_write_(may_write) {}

    void write(const TracedRequest&, const std::optional<TexelPlace>&, TextWriter&) override {
        may_write_.wait();
    }

private:
    std::latch& may_write_;
};

TEST_CASE("the machine waits for an export's writer") {
    constexpr std::size_t Requests = std::size_t{1} << 18; // 64 chunks; eight may wait
    ExportOutput output("/dev/null", false);
    TextWriter text(output);
    const TexturePlaces places;
    std::latch may_write(1);
    MemoryTrace trace(std::make_unique<SlowFormat>(may_write), 64, places, text);
    std::atomic<std::size_t> sent = 0;
    std::thread machine([&] {
        for (; sent < Requests; ++sent)
            trace.sent({.address = 64 * sent, .bytes = 64}, sent);
    });
    std::size_t before = 0;
    do { // until it stands
        before = sent;
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    } while (sent != before);
    CHECK(sent < Requests / 4);
    may_write.count_down();
    machine.join();
    trace.finish();
    CHECK(trace.traffic()[static_cast<std::size_t>(timing::Client::Command)].requests == Requests);
}

} // namespace
} // namespace ffgpu::tools
