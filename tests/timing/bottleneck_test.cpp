// The resource that is named as a bottleneck is one: of all that a configuration can have without
// limit, the machine gains most from it.

#include "model/timing/memory_controller.h"
#include "tests/timing/machine_figures.h"
#include "tests/timing/random_work.h"

#include <cmath>
#include <cstdlib>
#include <functional>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// A machine in which the resource is as fast as the configuration has it.
using Unlimited = std::function<void(TimingConfig&)>;

const std::map<Resource, Unlimited>& unlimited() {
    static const std::map<Resource, Unlimited> all{
        {Resource::Host, [](TimingConfig& config) { config.host.bytes_per_cycle = 0; }},
        {Resource::CommandProcessor,
         [](TimingConfig& config) {
             config.command_processor.draw_cycles = 1;
             config.command_processor.lines_per_cycle = 64;
         }},
        {Resource::VertexFetch,
         [](TimingConfig& config) {
             config.vertex.vertices_per_cycle = 16;
             config.vertex.fetch_bytes_per_cycle = 0;
         }},
        {Resource::Geometry,
         [](TimingConfig& config) {
             config.vertex.units = 16;
             config.vertex.order_entries = 4096;
             config.vertex.transform_cycles = 1;
             config.vertex.light_cycles = 0;
         }},
        {Resource::Clip, [](TimingConfig& config) { config.clip.plane_cycles = 0; }},
        {Resource::Setup,
         [](TimingConfig& config) {
             config.setup.units = 16;
             config.setup.triangle_cycles = config.setup.reject_cycles = 1;
             config.setup.attribute_cycles = 0;
         }},
        {Resource::Raster,
         [](TimingConfig& config) {
             config.raster.tile_cycles = config.raster.empty_tile_cycles = 0;
         }},
        {Resource::Depth, [](TimingConfig& config) { config.depth_cache.lookups_per_cycle = 64; }},
        {Resource::Texture,
         [](TimingConfig& config) {
             config.texel_cache.lookups_per_cycle = 64;
             config.texel_cache.bilinear_quads_per_cycle = 16;
             config.texel_cache.ports = 0;
             config.texel_cache.decompress_cycles = 0;
             config.texture.miss_cycles = 0;
         }},
        {Resource::TexelL2,
         [](TimingConfig& config) {
             config.texel_l2.lookups_per_cycle = 64;
             config.texel_l2.latency = 1;
             config.texel_l2.bytes_per_cycle = 512;
             config.texel_l2.ports = 0;
         }},
        {Resource::Fragment,
         [](TimingConfig& config) {
             config.fragment.quad_cycles = 1;
             config.fragment.combiner_cycles = 1;
             config.fragment.combiners = 8;
         }},
        {Resource::Color, [](TimingConfig& config) { config.color_cache.lookups_per_cycle = 64; }},
        {Resource::MemoryBandwidth,
         [](TimingConfig& config) {
             const std::uint32_t latency = config.memory.latency;
             config.memory.profile = MemoryProfile::Ideal;
             config.memory.apply_profile();
             config.memory.latency = latency;
             config.memory.channels = 16;
             config.memory.bytes_per_cycle = 256;
             config.memory.memory_clocks = config.memory.core_clocks = 1;
         }},
        {Resource::MemoryLatency, [](TimingConfig& config) { config.memory.latency = 0; }},
        {Resource::Links, [](TimingConfig& config) {
             const std::uint32_t width =
                 std::max(config.vertex.vertices_per_cycle, config.setup.units);
             config.clip.queue += (config.vertex.latency - 1) * width;
             config.vertex.latency = config.fragment.latency = 1;
         }}};
    return all;
}

struct Outcome {
    std::uint64_t cycles = 0;
    std::array<std::int64_t, Resources> gains{};
    WaitedCycles waited{};

    void add(const CommandCycles& command, std::size_t i) {
        waited[i] += command.waited[i];
        sums[i] += static_cast<double>(command.saved.cycles[i]);
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
    unlimited().at(Resource::MemoryBandwidth)(config);
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

// A memory that holds as many requests as one of this latency does.
MakeMemory as_deep_as(std::uint32_t latency) {
    return [latency](const Clock& clock, const MemoryConfig& config) {
        const std::size_t there = 1 + latency / 2, nearer = 1 + config.latency / 2;
        return std::make_unique<MemoryController>("memory", clock, config, 2 * there - nearer);
    };
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
    // As good as the best: within a hundredth of the frame.
    bool holds() const { return missed() * 100 <= static_cast<std::int64_t>(base.cycles); }
};

Measured measure(Case kind, std::uint64_t seed) {
    const TimingConfig config = machine_of(kind, seed);
    Measured gains{run_frame(config, kind, seed), {}};
    for (const auto& [resource, remove_limit] : unlimited()) {
        TimingConfig faster = config;
        remove_limit(faster);
        const MakeMemory as_deep = as_deep_as(config.memory.latency);
        const std::uint64_t cycles = run_frame(faster, kind, seed, as_deep).cycles;
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
    for (std::uint64_t seed = first; seed < first + cases; ++seed) {
        const Measured gains = measure(case_of(population, seed), seed);
        right += gains.holds();
        ties += gains.holds() && gains.missed() > 0;
        if (!gains.holds()) WARN(seed << ": " << described(gains));
    }
    WARN(right << " of " << cases << " bottlenecks are the largest gain, " << ties
               << " of them within 1 % of the frame, "
               << (population == Population::Draws ? "draws alone" : "all cases"));
    CHECK(right * 100 >= cases * 95);
}

// A frame of one draw that keeps `unit` alone busy: so many items of so many cycles each.
TEST_CASE("a unit that is far slower than all others is the bottleneck") {
    const auto [slow, resource] = GENERATE(table<Unlimited, Resource>(
        {{[](TimingConfig& config) { config.vertex.transform_cycles = 900; }, Resource::Geometry},
         {[](TimingConfig& config) { config.setup.triangle_cycles = 900; }, Resource::Setup},
         {[](TimingConfig& config) { config.raster.tile_cycles = 64; }, Resource::Raster},
         {[](TimingConfig& config) { config.fragment.quad_cycles = 64; }, Resource::Fragment},
         {[](TimingConfig& config) { config.command_processor.draw_cycles = 60000; },
          Resource::CommandProcessor},
         {[](TimingConfig& config) { config.memory.latency = 4000; }, Resource::MemoryLatency}}));
    TimingConfig config;
    config.depth_cache.outstanding_lines = 1;
    unlimited().at(Resource::MemoryBandwidth)(config);
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
