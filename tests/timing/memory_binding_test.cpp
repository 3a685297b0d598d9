// Memories from outside behind the TLM-2.0 socket: the examples of docs/examples, at work.

#include "docs/examples/dram_memory.h"
#include "docs/examples/latency_memory.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/memory_kinds.h"
#include "model/work/command_assembler.h"
#include "tests/timing/analytic_scenes.h"
#include "tests/timing/memory_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// All figures but the account of our controller's unit, which another memory has not.
Figures machine_figures(const TimingConfig& config, const MakeMemory& make_memory) {
    GpuTiming timing(config, 0, make_memory);
    work::CommandAssembler assembler(timing);
    assembler.bin(std::make_shared<const WorkBin>(make_bin(floor_scene(256))));
    assembler.end_frame(0);
    Figures figures;
    for (const StatisticsGroup* group : timing.statistics()) {
        for (const Counter& counter : group->counters())
            figures[std::string(counter.name())] = counter.value();
    }
    for (const std::string_view activity : ActivityNames)
        figures.erase("memory_" + std::string(activity) + "_cycles");
    for (const char* const channel : {"0", "1"}) // its queues
        figures.erase("queue_memory_channel" + std::string(channel) + "_arrivals_item_cycles");
    // It cannot tell what of a wait is its queues' and what its latency.
    std::erase_if(figures, [](const auto& figure) {
        return figure.first.starts_with("bottleneck_") || figure.first.starts_with("gain_");
    });
    return figures;
}

TEST_CASE("a DRAM bound from outside has every figure of ours") {
    TimingConfig narrow;
    narrow.memory.queue = 2;
    narrow.memory.core_clocks = 3;
    narrow.memory.memory_clocks = 2;
    narrow.memory.channels = 1;
    const MakeMemory outside = [](const Clock& clock, const MemoryConfig& config) {
        return std::make_unique<examples::DramMemory>("outside", clock, config);
    };
    for (const TimingConfig& config : {TimingConfig{}, narrow}) {
        const Figures ours = machine_figures(config, {});
        CHECK(ours.at("memory_data_cycles") > 0);
        CHECK(machine_figures(config, outside) == ours);
    }
}

// One of ours, of which nobody knows the way past the socket.
class SocketAlone final : public MemoryModule {
public:
    explicit SocketAlone(std::unique_ptr<MemoryModule> memory)
        : memory_(std::move(memory)) {}

    tlm::tlm_target_socket<>& target() override { return memory_->target(); }
    Unit* unit() override { return memory_->unit(); }
    void connect(Unit& arbiter) override { memory_->connect(arbiter); }
    void settle() override { memory_->settle(); }
    std::vector<const StatisticsGroup*> statistics() const override {
        return memory_->statistics();
    }

private:
    const std::unique_ptr<MemoryModule> memory_;
};

TEST_CASE("requests that go past the socket are answered as those that go through it") {
    const MakeMemory by_socket = [](const Clock& clock, const MemoryConfig& config) {
        return std::make_unique<SocketAlone>(configured_memory(clock, config));
    };
    Dice dice(11);
    for (std::uint64_t i = 0; i < 40; ++i) {
        MemoryConfig config;
        config.kind = i % 8 == 0 ? MemoryKind::Fixed : MemoryKind::Dram;
        config.channels = 1u << dice.below(3);
        config.queue = 1 + static_cast<std::uint32_t>(dice.below(20)); // few: arrivals are refused
        config.latency = static_cast<std::uint32_t>(dice.below(40));
        config.core_clocks = 1 + static_cast<std::uint32_t>(dice.below(3));
        std::vector<MemoryRequest> list = line_stream(600);
        for (MemoryRequest& request : list) {
            request.address = 64 * dice.below(1 << 12);
            request.write = dice.below(3) == 0;
        }
        const BenchResult direct = run_memory(config, list, 64, configured_memory);
        const BenchResult expected = run_memory(config, list, 64, by_socket);
        CAPTURE(i);
        CHECK(direct.done.size() > 300);
        CHECK(direct.done == expected.done);
        CHECK(direct.cycles == expected.cycles);
        CHECK(direct.figures == expected.figures);
    }
}

MakeMemory latency_memory(const examples::LatencyMemory::Latency& latency) {
    return [=](const Clock& clock, const MemoryConfig&) {
        return std::make_unique<examples::LatencyMemory>("latency", clock, latency);
    };
}

TEST_CASE("a memory that is a function of the request answers after that many cycles") {
    constexpr std::size_t Reads = 500;
    const auto by_place = [](const MemoryRequest& request) -> Cycle {
        return request.address % 128 == 0 ? 10 : 70;
    };
    const BenchResult result = run_memory({}, line_stream(Reads), 1, latency_memory(by_place));
    // One at a time: to the arbiter, the latency, and back to the client.
    CHECK(result.done.back().second - result.done.front().second ==
          Reads / 2 * (70 + 2) + (Reads / 2 - 1) * (10 + 2));
    const BenchResult together =
        run_memory({}, line_stream(Reads), Unlimited, latency_memory(by_place));
    CHECK(together.cycles < Reads + 100); // nothing but latency
}

TEST_CASE("the machine runs on a memory of latency alone, and waits for it") {
    const auto cycles = [](Cycle latency) {
        TimingConfig config;
        config.texel_cache.fragment_fifo = 4;
        return machine_figures(config, latency_memory([=](const auto&) { return latency; }))
            .at("total_cycles");
    };
    const auto near = cycles(5), far = cycles(200);
    CHECK(far > 2 * near);
}

} // namespace
} // namespace ffgpu::timing
