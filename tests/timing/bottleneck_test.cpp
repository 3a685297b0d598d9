// The resource that is named as a bottleneck is one: of all that a configuration can have without
// limit, the machine gains most from it.

#include "model/timing/without_limit.h"
#include "tests/timing/machine_figures.h"
#include "tests/timing/random_work.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

struct Outcome {
    std::uint64_t cycles = 0;
    std::array<std::int64_t, Resources> gains{};
    WaitedCycles waited{};

    void add(const CommandCycles& command, std::size_t i) {
        waited[i] += command.waited[i];
        sums[i] += static_cast<double>(command.saved[static_cast<Resource>(i)]);
        gains[i] = std::llround(sums[i]);
    }
    std::array<double, Resources> sums{};
};

// What a seed draws: a frame of six draws; of a few draws with clears, copies, images and uploads
// between them; or of many vertices and few quads, on a machine whose back end is no limit.
enum class Case { Draws, Commands, FrontEnd };

// Frames of draws alone, or all cases in turn.
enum class Population { Draws, All };

constexpr Case case_of(Population population, std::uint64_t seed) {
    return population == Population::Draws ? Case::Draws : static_cast<Case>(seed % 3);
}

// A memory and caches that hold up nobody, and a front end slow in all its parts, or in one.
void bind_to_front_end(TimingConfig& config, RandomWork& random) {
    config = without_limit(config, Resource::MemoryBandwidth);
    config.memory.latency = random.below(20);
    config.vertex.outstanding_lines = 64;
    config.vertex.cache_sets = 64;
    config.host.bytes_per_cycle = 1 + random.below(16);
    config.command_processor.draw_cycles = 1 + random.below(2000);
    config.vertex.fetch_bytes_per_cycle = 1 + random.below(24);
    config.vertex.transform_cycles = 1 + random.below(40);
    config.clip.plane_cycles = random.below(80);
    config.setup.triangle_cycles = 1 + random.below(60);
    config.raster.architecture = work::Architecture::Immediate;
}

TimingConfig machine_of(Case kind, std::uint64_t seed) {
    RandomWork random(~seed);
    TimingConfig config = random.machine();
    if (kind == Case::FrontEnd) bind_to_front_end(config, random);
    return config;
}

void tell_frame(Case kind, std::uint64_t seed, GpuTiming& timing) {
    RandomWork work(seed);
    for (std::uint32_t number = 0; number < 6; ++number) {
        switch (kind) {
        case Case::Draws:
            timing.command(
                std::make_shared<work::WholeCommand>(work.any_draw(number, 1, 400, 1000)));
            break;
        case Case::Commands:
            if (work.below(3) == 0)
                timing.host_transfer({.before_draw = 0,
                                      .is_write = true,
                                      .at = std::uint64_t{11} << 26,
                                      .bytes = 64 * (1 + work.below(500))});
            timing.command(work.any_command(number));
            break;
        case Case::FrontEnd:
            timing.command(
                std::make_shared<work::WholeCommand>(work.any_draw(number, 100, 900, 60)));
            break;
        }
    }
}

Outcome run_commands(GpuTiming& timing, const std::function<void()>& tell) {
    Outcome outcome;
    timing.set_on_frame([&](const FrameTiming& frame) {
        outcome.cycles = frame.cycles;
        for (const CommandCycles& command : frame.commands)
            for (std::size_t i = 0; i < Resources; ++i)
                outcome.add(command, i);
    });
    tell();
    timing.end_frame(0);
    return outcome;
}

Outcome run_frame(const TimingConfig& config,
                  Case kind,
                  std::uint64_t seed,
                  const MakeMemory& memory = {}) {
    GpuTiming timing(config, {}, memory);
    return run_commands(timing, [&] { tell_frame(kind, seed, timing); });
}

// Of all cycles of the frame: what each resource without limit gains.
struct Measured {
    Outcome base;
    std::map<Resource, std::int64_t> of;

    Resource named() const {
        return static_cast<Resource>(std::max_element(base.gains.begin(), base.gains.end()) -
                                     base.gains.begin());
    }
    Resource best() const {
        return std::max_element(of.begin(),
                                of.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }
    // What the best gains more than the named one.
    std::int64_t missed() const {
        const auto named_gain = of.find(named());
        return of.at(best()) - (named_gain == of.end() ? 0 : named_gain->second);
    }
    // Of the gains that are, or were reckoned, a fiftieth of the frame or more: by how much the
    // reckoned ones are wrong, in hundredths of the frame.
    void add_errors(std::vector<double>& errors) const {
        const auto cycles = static_cast<double>(base.cycles);
        for (const auto& [resource, gain] : of) {
            const std::int64_t reckoned = base.gains[static_cast<std::size_t>(resource)];
            if (50 * std::max(reckoned, gain) < static_cast<std::int64_t>(base.cycles)) continue;
            errors.push_back(100 * static_cast<double>(std::abs(reckoned - gain)) / cycles);
        }
    }
    // As good as the best: within a hundredth of the frame.
    bool holds() const { return missed() * 100 <= static_cast<std::int64_t>(base.cycles); }
};

Measured measure(Case kind, std::uint64_t seed) {
    const TimingConfig config = machine_of(kind, seed);
    Measured gains{run_frame(config, kind, seed), {}};
    for (std::size_t i = 0; i < Resources; ++i) {
        const auto resource = static_cast<Resource>(i);
        if (!has_limit(config, resource)) continue;
        const TimingConfig faster = without_limit(config, resource);
        const std::uint64_t cycles =
            run_frame(faster, kind, seed, memory_as_deep_as(config)).cycles;
        gains.of[resource] =
            static_cast<std::int64_t>(gains.base.cycles) - static_cast<std::int64_t>(cycles);
    }
    return gains;
}

// For each resource that is not without effect, the cycles waited for it and its gain.
std::string described(const Measured& gains) {
    std::string text = std::to_string(gains.base.cycles) + " cycles:";
    for (std::size_t i = 0; i < Resources; ++i) {
        const auto gain = gains.of.find(static_cast<Resource>(i));
        const std::int64_t gained = gain == gains.of.end() ? 0 : gain->second;
        const auto waited = static_cast<std::int64_t>(gains.base.waited[i]);
        const std::int64_t reckoned = gains.base.gains[i];
        if (std::max({reckoned, waited, gained}) * 50 <
            static_cast<std::int64_t>(gains.base.cycles))
            continue;
        text += ' ' + std::string(ResourceNames[i]) + " waited " + std::to_string(waited) +
                " reckoned " + std::to_string(reckoned) + " gains " + std::to_string(gained) + ';';
    }
    return text;
}

double mean(const std::vector<double>& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return sum / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

// Random machines and frames; FFGPU_BOTTLENECK_CASES and _SEED ask for others.
TEST_CASE("no resource without limit gains more than the named one, within 1 % of the frame") {
    const auto number = [](const char* name, std::uint64_t otherwise) {
        const char* const wanted = std::getenv(name);
        return wanted ? std::strtoull(wanted, nullptr, 10) : otherwise;
    };
    const Population population = GENERATE(Population::Draws, Population::All);
    const std::uint64_t cases = number("FFGPU_BOTTLENECK_CASES", 100);
    const std::uint64_t first = number("FFGPU_BOTTLENECK_SEED", 1000);
    std::uint64_t right = 0, ties = 0;
    std::vector<double> errors;
    for (std::uint64_t seed = first; seed < first + cases; ++seed) {
        const Measured gains = measure(case_of(population, seed), seed);
        right += gains.holds();
        ties += gains.holds() && gains.missed() > 0;
        gains.add_errors(errors);
        if (!gains.holds()) WARN(seed << ": " << described(gains));
    }
    WARN(right << " of " << cases << " bottlenecks are the largest gain, " << ties
               << " of them within 1 % of the frame, "
               << (population == Population::Draws ? "draws alone" : "all cases")
               << "; gains are reckoned wrong by " << mean(errors)
               << " % of the frame in the mean");
    CHECK(right * 100 >= cases * 95);
}

using Slow = std::function<void(TimingConfig&)>;

// A frame of one draw that keeps `unit` alone busy: so many items of so many cycles each.
TEST_CASE("a unit that is far slower than all others is the bottleneck") {
    const auto [slow, resource] = GENERATE(table<Slow, Resource>(
        {{[](TimingConfig& config) { config.vertex.transform_cycles = 900; }, Resource::Geometry},
         {[](TimingConfig& config) { config.setup.triangle_cycles = 900; }, Resource::Setup},
         {[](TimingConfig& config) { config.raster.tile_cycles = 64; }, Resource::Raster},
         {[](TimingConfig& config) { config.fragment.quad_cycles = 64; }, Resource::Fragment},
         {[](TimingConfig& config) { config.command_processor.draw_cycles = 60000; },
          Resource::CommandProcessor},
         {[](TimingConfig& config) { config.memory.latency = 4000; }, Resource::MemoryLatency}}));
    TimingConfig config;
    config.depth_cache.outstanding_lines = 1;
    config = without_limit(config, Resource::MemoryBandwidth);
    slow(config);
    GpuTiming timing(config);
    const Outcome outcome = run_commands(timing, [&] {
        RandomWork work(7);
        for (std::uint32_t number = 0; number < 6; ++number)
            timing.command(std::make_shared<work::WholeCommand>(work.draw(number, 120, 300)));
    });
    const std::uint64_t waited = outcome.waited[static_cast<std::size_t>(resource)];
    CAPTURE(ResourceNames[static_cast<std::size_t>(resource)], waited, outcome.cycles);
    CHECK(waited * 10 >= outcome.cycles * 8);
}

} // namespace
} // namespace ffgpu::timing
