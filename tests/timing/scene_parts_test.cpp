// Quads that come in parts: when they are told is in no figure of the machine.

#include "model/timing/machine.h"
#include "model/timing/machine_checks.h"
#include "model/timing/series.h"
#include "model/timing/simulation_context.h"
#include "model/work/machine_order.h"
#include "tests/support/drawn_quad.h"
#include "tests/timing/random_work.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

enum class Told {
    Whole,       // each draw with its quads
    Soon,        // the quads behind the draw
    AtFramesEnd, // behind all that the frame's commands tell
    ByLot,       // some parts behind each command
};

// Between the order of the work and the machine.
class Teller final : public work::MachineSink {
public:
    Teller(Machine& machine, Told told)
        : machine_(machine)
        , told_(told) {}

    bool takes_parts() const override { return told_ != Told::Whole; }
    void scene(work::PreparedScene&& scene) override {
        quads_to_come += scene.quads_to_come;
        machine_.scene(std::move(scene));
    }
    void part(work::PreparedPart&& part) override {
        ++parts;
        machine_.part(std::move(part));
    }
    void transfer(work::PreparedTransfer&& transfer) override {
        machine_.transfer(std::move(transfer));
    }
    void host_transfer(const HostTransfer& transfer) override { machine_.host_transfer(transfer); }
    void end_commands() override { machine_.end_commands(); }
    void end_frame(std::uint32_t frame) override { machine_.end_frame(frame); }
    void texels_rewritten(std::vector<std::uint64_t>&& lines) override {
        machine_.texels_rewritten(std::move(lines));
    }
    void content(work::PreparedContent&& content) override { machine_.content(std::move(content)); }
    void host_access(std::vector<work::TransferLine>&& lines) override {
        machine_.host_access(std::move(lines));
    }

    std::size_t quads_to_come = 0, parts = 0;

private:
    Machine& machine_;
    const Told told_;
};

// All samples.
struct Samples final : SeriesSink {
    void columns(std::span<const SeriesColumn>) override {}
    void sample(const SeriesSample& sample) override {
        counts.insert(counts.end(), sample.counts.begin(), sample.counts.end());
    }
    void end_frame(std::uint32_t) override {}

    std::vector<std::uint64_t> counts;
};

struct Outcome {
    std::map<std::string, std::uint64_t> figures;
    std::vector<std::uint64_t> series;
    std::size_t quads_to_come = 0, parts = 0;

    bool is_of_machine(const Outcome& other) const {
        return figures == other.figures && series == other.series;
    }
};

// Two frames of six draws, between which the host writes their textures anew.
template <class Draw>
Outcome run_frames(TimingConfig config, Told told, Draw&& draw, std::uint64_t seed = 1) {
    config.series.interval_cycles = 1000;
    check_machine(config);
    const SimulationContext context;
    Outcome outcome;
    const SimulationContext::Scope scope(context);
    // Where parts are told by lot, by the plainest of the clock's paces and in another order.
    const auto order_of_units = static_cast<std::uint32_t>(seed);
    const Evaluation evaluation =
        told == Told::ByLot ? Evaluation(order_of_units, Pace::EveryCycle) : Evaluation();
    Machine machine(context, config, evaluation, {});
    Samples samples;
    machine.series->set_sink(&samples);
    Teller teller(machine, told);
    work::MachineOrder order(config.work(), teller);
    RandomWork work(seed);
    RandomWork lots(seed);
    for (std::uint32_t frame = 0; frame < 2; ++frame) {
        for (std::uint32_t i = 0; i < 6; ++i) {
            order.command(std::make_shared<const work::WholeCommand>(draw(work, i)));
            if (told == Told::Soon) order.tell_parts();
            for (std::uint32_t part = lots.below(4); told == Told::ByLot && part > 0; --part)
                order.tell_part();
            order.host_transfer(
                {.is_write = true, .at = DeviceAddress{3 + i % 2} << 26, .bytes = 5000});
        }
        order.end_frame(frame);
    }
    for (const StatisticsGroup* const group : machine.statistics())
        for (const Counter& counter : group->counters())
            outcome.figures[std::string(counter.name())] = counter.value();
    outcome.series = std::move(samples.counts);
    outcome.quads_to_come = teller.quads_to_come;
    outcome.parts = teller.parts;
    return outcome;
}

TEST_CASE("when a draw's quads are told is in no figure") {
    std::size_t parts = 0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        TimingConfig config = RandomWork(~seed).machine();
        config.raster.architecture = work::Architecture::Immediate;
        config.texel_cache.rewritten =
            seed % 2 == 0 ? work::RewrittenLevel::NewPlace : work::RewrittenLevel::InPlace;
        if (seed % 5 == 0) config.raster.quads_per_cycle = 16;
        const auto run = [&](Told told) {
            const auto draw = [](RandomWork& work, std::uint32_t number) {
                return work.any_draw(number, 3, 300, number % 3 == 0 ? 6000 : 400);
            };
            return run_frames(config, told, draw, seed);
        };
        const Outcome whole = run(Told::Whole);
        CAPTURE(seed);
        REQUIRE(whole.parts == 0);
        for (const Told told : {Told::Soon, Told::AtFramesEnd, Told::ByLot}) {
            const Outcome outcome = run(told);
            CHECK(outcome.is_of_machine(whole));
            CHECK(outcome.quads_to_come > 2000);
            parts += outcome.parts;
        }
    }
    CHECK(parts > 500);
}

// A square of 64 x 64 quads, as one piece.
work::WholeCommand square(RandomWork& work, std::uint32_t number) {
    work::WholeCommand command = work.draw(number, 3, 0);
    command.draw.geometry.vertices = {0, 1, 2};
    command.draw.geometry.primitives = {{.key = 0, .last_vertex = 2, .pieces = 1}};
    command.draw.geometry.pieces = {
        {.x0 = 0, .y0 = 0, .x1 = 128, .y1 = 128, .touched_blocks = 16 * 16}};
    for (std::uint16_t y = 0; y < 128; y += 2)
        for (std::uint16_t x = 0; x < 128; x += 2)
            command.quads.push_back(drawn_quad(x, y));
    return command;
}

// The empty blocks behind the last quads are told with these, when the walk has come to the block
// long since.
TEST_CASE("empty blocks behind a block that is told in parts end a draw once") {
    for (const auto granularity : {work::Granularity::Quad, work::Granularity::Fragment})
        for (const std::uint32_t empty_tile_cycles : {0u, 1u, 5u}) {
            TimingConfig config;
            config.raster.granularity = granularity;
            config.raster.tile_width = 64;
            config.raster.empty_tile_cycles = empty_tile_cycles;
            const auto run = [&](Told told) {
                return run_frames(config, told, [](RandomWork& work, std::uint32_t number) {
                    work::WholeCommand command = square(work, number);
                    command.draw.geometry.pieces[0].y1 = 256;
                    return command;
                });
            };
            CAPTURE(empty_tile_cycles);
            const Outcome whole = run(Told::Whole);
            // Twelve draws, whose box has four blocks with quads and as many without.
            CHECK(whole.figures.at("raster_blocks") == 12 * 4);
            CHECK(whole.figures.at("raster_empty_blocks") == 12 * 4);
            for (const Told told : {Told::Soon, Told::AtFramesEnd, Told::ByLot}) {
                const Outcome outcome = run(told);
                CHECK(outcome.is_of_machine(whole));
                CHECK(outcome.parts > 12);
            }
        }
}

TEST_CASE("a walk over whole tiles looks at a piece's quads when all are told") {
    TimingConfig config;
    config.raster.traversal = work::Traversal::Nested;
    config.raster.walk = Walk::Tiles;
    const auto run = [&](Told told) {
        return run_frames(config, told, [](RandomWork& work, std::uint32_t number) {
            return square(work, number);
        });
    };
    const Outcome whole = run(Told::Whole);
    // 16 outer tiles of 16 blocks of 16 quads, a cycle each.
    CHECK(whole.figures.at("raster_busy_cycles") >= 12 * 16 * (1 + 16 * (1 + 16)));
    CHECK(run(Told::AtFramesEnd).is_of_machine(whole));
    CHECK(run(Told::ByLot).is_of_machine(whole));
}

} // namespace
} // namespace ffgpu::timing
