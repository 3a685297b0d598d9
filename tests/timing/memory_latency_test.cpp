// Latency tolerance of texture prefetching (H. Igehy, M. Eldridge, K. Proudfoot, Prefetching in a
// Texture Cache Architecture, 1998) on this memory. The machine in front of it is the test's own:
// a fragment and a miss a cycle at the tags, at most 64 lines outstanding, a fragment FIFO, exit in
// order. Expected are the figures of an independent model of the whole.

#include "tests/timing/memory_bench.h"

#include <array>
#include <cmath>
#include <deque>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// 16 KB, two ways of 64-byte lines, least recently used.
class TwoWayCache {
public:
    bool misses(std::uint64_t line) {
        std::array<std::uint64_t, 2>& set = sets_[line % sets_.size()];
        if (set[0] == line + 1) return false;
        const bool missed = set[1] != line + 1;
        set = {line + 1, set[0]};
        return missed;
    }

private:
    std::array<std::array<std::uint64_t, 2>, 128> sets_{};
};

// The perspective floor, 640x480, a 1024x1024 texture of 4-byte texels in blocks of 4x4, trilinear,
// in tiles of 8x8 pixels: the lines that each fragment misses.
class Floor {
public:
    Floor() {
        std::uint64_t base = 0;
        for (unsigned size = 1024; size > 0; size /= 2) {
            levels_.push_back({base, size});
            base += (std::uint64_t{size} * size * 4 + 127) / 128 * 128;
        }
        for (unsigned tile_y = 0; tile_y < 480; tile_y += 8)
            for (unsigned tile_x = 0; tile_x < 640; tile_x += 8)
                for (unsigned i = 0; i < 64; ++i)
                    add_fragment(tile_x + i % 8 + 0.5, tile_y + i / 8 + 0.5);
    }

    std::vector<std::vector<std::uint64_t>> missed; // of each fragment
    std::size_t reads = 0, misses = 0;

private:
    struct Level {
        std::uint64_t base;
        unsigned size;
    };
    struct Texel {
        double u, v;
    };

    static Texel place(double x, double y) {
        const double distance = 0.9 * 480 / (y - 0.3 * 480);
        const double across = (x - 320) / (0.9 * 480) * distance;
        return {(std::cos(0.4) * across - std::sin(0.4) * distance) * 256,
                (std::sin(0.4) * across + std::cos(0.4) * distance) * 256};
    }

    void add_fragment(double x, double y) {
        if (y - 0.3 * 480 <= 0.5) return;
        const Texel at = place(x, y), right = place(x + 1, y), below = place(x, y + 1);
        const double lambda = std::log2(std::max(std::hypot(right.u - at.u, right.v - at.v),
                                                 std::hypot(below.u - at.u, below.v - at.v)));
        missed.emplace_back();
        const unsigned last = static_cast<unsigned>(levels_.size()) - 1;
        const unsigned level = lambda <= 0 ? 0 : std::min(static_cast<unsigned>(lambda), last);
        read(at, level);
        if (lambda > 0 && level < last) read(at, level + 1);
    }

    void read(const Texel& at, unsigned number) {
        const double scale = std::exp2(-static_cast<double>(number));
        const auto i = static_cast<std::int64_t>(std::floor(at.u * scale - 0.5));
        const auto j = static_cast<std::int64_t>(std::floor(at.v * scale - 0.5));
        for (int k = 0; k < 4; ++k) {
            const std::uint64_t line = line_of(levels_[number], i + k % 2, j + k / 2);
            ++reads;
            if (!cache_.misses(line)) continue;
            ++misses;
            missed.back().push_back(line);
        }
    }

    static std::uint64_t line_of(const Level& level, std::int64_t i, std::int64_t j) {
        const std::uint64_t x = static_cast<std::uint64_t>(i) & (level.size - 1);
        const std::uint64_t y = static_cast<std::uint64_t>(j) & (level.size - 1);
        const std::uint64_t texel =
            level.size < 4 ? y * level.size + x
                           : (y / 4 * (level.size / 4) + x / 4) * 16 + y % 4 * 4 + x % 4;
        return (level.base + texel * 4) / 64;
    }

    std::vector<Level> levels_;
    TwoWayCache cache_;
};

// The same machine as a recurrence, memory included: when each fragment leaves the tags, when each
// line comes, when each fragment leaves the FIFO.
double recurrence_cycles(const Floor& floor, std::uint32_t latency, std::size_t fifo) {
    std::vector<std::uint64_t> leaves, comes;
    std::uint64_t tag = 0, memory = 0, last = 0;
    for (const std::vector<std::uint64_t>& missed : floor.missed) {
        if (leaves.size() >= fifo) tag = std::max(tag, leaves[leaves.size() - fifo]);
        std::uint64_t data = 0;
        for (std::size_t i = 0; i < missed.size(); ++i, ++tag) {
            if (comes.size() >= 64) tag = std::max(tag, comes[comes.size() - 64]);
            memory = std::max(tag, memory) + 4;
            data = memory - 4 + latency;
            comes.push_back(data);
        }
        tag += missed.empty();
        last = std::max({last + 1, tag, data});
        leaves.push_back(last);
    }
    return static_cast<double>(last);
}

class PrefetchingUnit final : public Unit {
public:
    PrefetchingUnit(const Clock& clock,
                    RequestPort& requests,
                    Channel<std::uint64_t>& responses,
                    const Floor& floor,
                    std::size_t fifo)
        : Unit("unit", clock)
        , requests_(requests)
        , responses_(responses)
        , floor_(floor)
        , fifo_(fifo) {}

    bool is_done() const { return left_ == floor_.missed.size(); }

private:
    Activity step() override {
        while (responses_.can_pop()) {
            arrived_[responses_.pop()] = true;
            while (!arrived_.empty() && complete_ < arrived_.size() && arrived_[complete_])
                ++complete_;
        }
        if (!parked_.empty() && parked_.front() <= complete_) {
            parked_.pop_front();
            ++left_;
        }
        look_up();
        return Activity::Busy;
    }

    void look_up() {
        if (fragment_ == floor_.missed.size() || parked_.size() >= fifo_) return;
        const std::vector<std::uint64_t>& lines = floor_.missed[fragment_];
        if (next_line_ < lines.size()) {
            if (arrived_.size() - complete_ >= 64 || !requests_.can_push()) return;
            requests_.push({.address = lines[next_line_++] * 64,
                            .bytes = 64,
                            .client = Client::Texture,
                            .ticket = arrived_.size()});
            arrived_.push_back(false);
        }
        if (next_line_ < lines.size()) return;
        parked_.push_back(arrived_.size());
        next_line_ = 0;
        ++fragment_;
    }
    bool may_sleep() const override { return false; }

    RequestPort& requests_;
    Channel<std::uint64_t>& responses_;
    const Floor& floor_;
    const std::size_t fifo_;
    std::size_t fragment_ = 0, next_line_ = 0, left_ = 0, complete_ = 0;
    std::deque<std::size_t> parked_; // fills that each fragment waits for
    std::vector<bool> arrived_;
};

Cycle cycles(const Floor& floor, std::uint32_t latency, std::size_t fifo) {
    MemoryConfig config;
    config.profile = MemoryProfile::Ideal;
    config.apply_profile();
    config.channels = 1;
    config.bytes_per_cycle = 16;
    config.queue = config.client_queue = 64;
    config.scheduler = SchedulerKind::InOrder; // as the model's memory
    config.latency = latency;
    SimulationContext context;
    const SimulationContext::Scope scope(context);
    const PrefetchingUnit* running = nullptr;
    Clock clock("clock", [&] { return running->is_done(); });
    InFlight in_flight(clock);
    RequestPort port(clock, config.client_queue, in_flight);
    Channel<std::uint64_t> responses(clock, 256);
    std::vector<Channel<MemoryRequest>> silent(Clients, Channel<MemoryRequest>(clock, 1));
    MemoryArbiter::Ports ports;
    for (std::size_t i = 0; i < Clients; ++i)
        ports.requests_in[i] = i == 0 ? &port.channel() : &silent[i];
    ports.responses_out.fill(&responses);
    MemoryArbiter arbiter("arbiter", clock, config, ports, in_flight);
    MemoryController memory("memory", clock, config);
    PrefetchingUnit unit(clock, port, responses, floor, fifo);
    running = &unit;
    port.channel().connect(unit, arbiter);
    memory.connect(arbiter);
    arbiter.socket.bind(memory.target());
    for (Unit* each : {static_cast<Unit*>(&unit), static_cast<Unit*>(&arbiter), memory.unit()})
        each->attach();
    sc_core::sc_start();
    return clock.now();
}

TEST_CASE("a FIFO as deep as the latency reaches 97 percent of a memory without latency") {
    const Floor floor;
    // The published rate of this scene and cache.
    CHECK(100.0 * static_cast<double>(floor.misses) / static_cast<double>(floor.reads) ==
          Approx(1.75).margin(0.05));
    const double best = static_cast<double>(cycles(floor, 0, 1 << 20));
    struct Row {
        std::uint32_t latency;
        std::size_t fifo;
        double percent; // of the independent model
    };
    // From the client's request to its data without `latency`: to the arbiter, to the controller,
    // four cycles on the bus, back to the client.
    constexpr std::uint32_t Links = 6;
    for (const Row& row : {Row{10, 16, 93.8},
                           {25, 32, 95.6},
                           {50, 64, 97.3},
                           {50, 16, 47.2},
                           {100, 128, 97.5},
                           {250, 256, 96.9}}) {
        INFO("latency " << row.latency << ", FIFO " << row.fifo);
        CHECK(100 * best / static_cast<double>(cycles(floor, row.latency - Links, row.fifo)) ==
              Approx(row.percent).margin(1));
    }
    // The shallow ones too, where a fragment more or less in the FIFO decides.
    for (const std::uint32_t latency : {10u, 50u, 250u}) {
        for (const std::size_t fifo : {8u, 32u, 64u, 128u, 256u}) {
            INFO("latency " << latency << ", FIFO " << fifo);
            CHECK(static_cast<double>(cycles(floor, latency - Links, fifo)) ==
                  Approx(recurrence_cycles(floor, latency, fifo)).epsilon(0.005));
        }
    }
}

} // namespace
} // namespace ffgpu::timing
