// A bench for memories: one client that asks for a list of requests as fast as it may, the arbiter,
// and a memory behind its socket.

#pragma once

#include "model/timing/memory_arbiter.h"
#include "model/timing/memory_controller.h"
#include "model/timing/request_port.h"
#include "model/timing/simulation_context.h"

#include <map>
#include <string>
#include <vector>

namespace ffgpu::timing {

using Figures = std::map<std::string, std::uint64_t>;

// Asks for `a_cycle` requests a cycle, with at most `outstanding` reads under way.
class BenchClient final : public Unit {
public:
    BenchClient(const Clock& clock,
                RequestPort& requests,
                Channel<std::uint64_t>& responses,
                std::vector<MemoryRequest> list,
                std::size_t outstanding,
                std::uint32_t a_cycle)
        : Unit("client", clock)
        , requests_(requests)
        , responses_(responses)
        , list_(std::move(list))
        , outstanding_(outstanding)
        , a_cycle_(a_cycle)
        , asked_at_(list_.size()) {}

    bool has_asked_all() const { return next_ == list_.size(); }
    // In the order of arrival: the index of each read, and when its data came.
    std::vector<std::pair<std::size_t, Cycle>> done;
    Cycle waited = 0; // summed over the reads

private:
    Activity step() override {
        while (responses_.can_pop()) {
            const std::size_t index = responses_.pop();
            done.emplace_back(index, now());
            waited += now() - asked_at_[index];
            --under_way_;
        }
        Activity activity = Activity::Idle;
        for (std::uint32_t i = 0; i < a_cycle_ && can_ask(); ++i) {
            list_[next_].ticket = next_;
            under_way_ += !list_[next_].write;
            asked_at_[next_] = now();
            requests_.push(list_[next_++]);
            activity = Activity::Busy;
        }
        return activity;
    }
    bool can_ask() const {
        return !has_asked_all() && under_way_ < outstanding_ && requests_.can_push();
    }
    Cycle next_work(Activity) const override { return now() + 1; }

    RequestPort& requests_;
    Channel<std::uint64_t>& responses_;
    std::vector<MemoryRequest> list_;
    const std::size_t outstanding_;
    const std::uint32_t a_cycle_;
    std::vector<Cycle> asked_at_;
    std::size_t next_ = 0, under_way_ = 0;
};

struct BenchResult {
    Cycle cycles = 0; // until the last answer
    std::vector<std::pair<std::size_t, Cycle>> done;
    Cycle waited = 0;
    Figures figures;

    // Between the first and the last data: without the time until the pipe is filled.
    Cycle steady_cycles() const { return done.back().second - done.front().second; }
};

inline constexpr std::size_t Unlimited = ~std::size_t{0};

inline BenchResult run_memory(const MemoryConfig& config,
                              const std::vector<MemoryRequest>& list,
                              std::size_t outstanding = Unlimited,
                              const MakeMemory& make_memory = {}) {
    SimulationContext context;
    const SimulationContext::Scope scope(context);
    BenchResult result;
    {
        const InFlight* pending = nullptr;
        const BenchClient* asking = nullptr;
        Clock clock("clock", [&] { return asking->has_asked_all() && pending->was_empty(); });
        InFlight in_flight(clock);
        pending = &in_flight;
        RequestPort port(clock, config.client_queue, in_flight);
        std::vector<Channel<MemoryRequest>> silent(Clients, Channel<MemoryRequest>(clock, 1));
        Channel<std::uint64_t> responses(clock, 1 << 16);
        MemoryArbiter::Ports ports;
        for (std::size_t i = 0; i < Clients; ++i)
            ports.requests_in.push_back(&silent[i]);
        ports.requests_in[static_cast<std::size_t>(Client::Texture)] = &port.channel();
        ports.responses_out.assign(Clients, &responses);
        MemoryArbiter arbiter("arbiter", clock, config, ports, in_flight);
        const std::unique_ptr<MemoryModule> memory =
            make_memory ? make_memory(clock, config)
                        : std::make_unique<MemoryController>("memory", clock, config);
        BenchClient client(clock, port, responses, list, outstanding, config.channels);
        asking = &client;
        port.channel().connect("client_requests", client, arbiter);
        memory->connect(arbiter);
        arbiter.socket.bind(memory->target());
        arbiter.go_directly(*memory);
        client.attach();
        arbiter.attach();
        if (Unit* unit = memory->unit()) unit->attach();
        sc_core::sc_start();
        memory->settle();
        result = {clock.now(), client.done, client.waited, {}};
        std::vector<const StatisticsGroup*> groups = memory->statistics();
        groups.push_back(&arbiter.statistics());
        for (const StatisticsGroup* group : groups) {
            for (const Counter& counter : group->counters())
                result.figures[std::string(counter.name())] = counter.value();
        }
    }
    return result;
}

// Lines of 64 bytes, one after the other.
inline std::vector<MemoryRequest> line_stream(std::size_t count, bool write = false) {
    std::vector<MemoryRequest> list;
    for (std::size_t i = 0; i < count; ++i)
        list.push_back({.address = 64 * i, .bytes = 64, .write = write, .client = Client::Texture});
    return list;
}

// The data, and all cycles without, over all causes.
inline std::uint64_t accounted_cycles(const Figures& figures) {
    std::uint64_t sum = figures.at("memory_data_cycles");
    for (const std::string_view cause : LostToNames)
        sum += figures.at("memory_lost_" + std::string(cause) + "_cycles");
    return sum;
}

// A multiplicative generator of its own, so that no test depends on a library's.
class Dice {
public:
    explicit Dice(std::uint64_t seed)
        : state_(2 * seed + 1) {}
    std::uint64_t below(std::uint64_t limit) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return (state_ >> 33) % limit;
    }

private:
    std::uint64_t state_;
};

} // namespace ffgpu::timing
