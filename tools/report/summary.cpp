#include "tools/report/summary.h"

#include "model/timing/memory_request.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

double ratio(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

// The counters of one group of stats.json, 0 where there is none of the name.
class Figures {
public:
    explicit Figures(const Json& group)
        : group_(group) {}

    std::uint64_t operator[](const std::string& name) const {
        return group_.value(name, std::uint64_t{0});
    }

    // X of all counters named X_busy_cycles, in their order.
    std::vector<std::string> units() const {
        constexpr std::string_view Ending = "_busy_cycles";
        std::vector<std::string> names;
        for (const auto& item : group_.items()) {
            if (item.key().ends_with(Ending))
                names.push_back(item.key().substr(0, item.key().size() - Ending.size()));
        }
        return names;
    }

private:
    const Json& group_;
};

std::string describe_units(const Figures& timing) {
    static constexpr std::array Reasons{std::pair{"stalled_output", "the next unit"},
                                        std::pair{"stalled_memory", "memory data"},
                                        std::pair{"stalled_requests", "a place for requests"}};
    std::string text = "  unit                 busy    idle   stalled, mostly on\n";
    const std::uint64_t cycles = timing["total_cycles"];
    for (const std::string& unit : timing.units()) {
        // Any bus of the memory makes it busy; its line below says how much they carry.
        if (unit == "memory" && timing["memory_bus_cycles"] > 0) continue;
        std::uint64_t stalled = 0, most = 0;
        const char* reason = "";
        for (const auto& [name, meaning] : Reasons) {
            const std::uint64_t value = timing[unit + '_' + name + "_cycles"];
            stalled += value;
            if (value > most) {
                most = value;
                reason = meaning;
            }
        }
        text += fmt::format("  {:18s} {:5.1f} % {:5.1f} %  {:5.1f} %  {}\n",
                            unit,
                            percent(timing[unit + "_busy_cycles"], cycles),
                            percent(timing[unit + "_idle_cycles"], cycles),
                            percent(stalled, cycles),
                            reason);
    }
    return text;
}

std::string describe_caches(const Figures& timing) {
    std::string text;
    for (const std::string cache :
         {"vertex_cache", "texel_cache", "texel_l2", "depth_cache", "color_cache"}) {
        const std::uint64_t accesses = timing[cache + "_accesses"],
                            misses = timing[cache + "_misses"];
        if (accesses == 0) continue;
        text += fmt::format(
            "  {:18s} {:5.1f} % of {} lookups hit; misses: {:.0f} % compulsory, {:.0f} % capacity, "
            "{:.0f} % conflict\n",
            cache,
            percent(timing[cache + "_hits"], accesses),
            accesses,
            percent(timing[cache + "_compulsory_misses"], misses),
            percent(timing[cache + "_capacity_misses"], misses),
            percent(timing[cache + "_conflict_misses"], misses));
    }
    return text;
}

// The buses of all channels, and what their cycles without data were lost to.
std::string describe_buses(const Figures& timing) {
    static constexpr std::array Causes{std::pair{"no_request", "no request"},
                                       std::pair{"row", "rows"},
                                       std::pair{"activates", "spacing of activates"},
                                       std::pair{"turnaround", "turnarounds"},
                                       std::pair{"refresh", "refresh"},
                                       std::pair{"column", "spacing of columns"},
                                       std::pair{"order", "order of requests"},
                                       std::pair{"burst", "rest of bursts"}};
    const std::uint64_t cycles = timing["memory_bus_cycles"];
    if (cycles == 0) return ""; // A memory of the user's.
    std::string text = fmt::format("  memory buses       {:5.1f} % carry data; lost:",
                                   percent(timing["memory_data_cycles"], cycles));
    const char* separator = " ";
    for (const auto& [name, meaning] : Causes) {
        const std::uint64_t lost = timing["memory_lost_" + std::string(name) + "_cycles"];
        if (lost == 0) continue;
        text += fmt::format("{}{} {:.1f} %", separator, meaning, percent(lost, cycles));
        separator = ", ";
    }
    const std::uint64_t hits = timing["memory_row_hits"], misses = timing["memory_row_misses"],
                        conflicts = timing["memory_row_conflicts"];
    const std::uint64_t requests = hits + misses + conflicts;
    return text + fmt::format("\n  memory rows        {:5.1f} % of {} requests hit, {:.1f} % found "
                              "none open, {:.1f} % another\n",
                              percent(hits, requests),
                              requests,
                              percent(misses, requests),
                              percent(conflicts, requests));
}

std::string describe_latency(const Figures& timing) {
    std::string text = "  read latency, cycles on average:";
    const char* separator = " ";
    for (const std::string_view name : timing::ClientNames) {
        const std::string client(name);
        std::uint64_t reads = 0;
        for (const char* range : {"below_32",
                                  "below_64",
                                  "below_128",
                                  "below_256",
                                  "below_512",
                                  "below_1024",
                                  "1024_or_more"})
            reads += timing["memory_" + client + "_read_latency_" + range];
        if (reads == 0) continue;
        text += fmt::format("{}{} {:.0f}",
                            separator,
                            client,
                            ratio(timing["memory_" + client + "_read_latency_cycles"], reads));
        separator = ", ";
    }
    return text + '\n';
}

std::string describe_memory(const Figures& timing, std::size_t frames) {
    std::string text = "  memory traffic a frame, KB read + written:";
    const char* separator = " ";
    for (const std::string_view name : timing::ClientNames) {
        const std::string client = "memory_" + std::string(name);
        const std::uint64_t read = timing[client + "_read_bytes"];
        const std::uint64_t written = timing[client + "_written_bytes"];
        if (read + written == 0) continue;
        text += fmt::format("{}{} {:.0f} + {:.0f}",
                            separator,
                            name,
                            ratio(read, frames) / 1024,
                            ratio(written, frames) / 1024);
        separator = ", ";
    }
    return text + '\n';
}

} // namespace

std::string summarize(const Json& totals, std::size_t frames, const timing::ClockConfig& clock) {
    if (frames == 0) return "no frames\n";
    static const Json none = Json::object();
    const auto group = [&](const char* name) -> const Json& {
        return totals.contains(name) ? totals[name] : none;
    };
    const Figures functional(group("functional")), timing(group("timing"));
    const std::uint64_t fragments = functional["fragments_written"];
    std::string text =
        fmt::format("{} frames, {} draws, {} primitives, {} fragments written, overdraw {:.2f}\n",
                    frames,
                    functional["draws"],
                    functional["primitives_in"],
                    fragments,
                    ratio(fragments, totals.value("pixels", std::uint64_t{0})));
    const std::uint64_t cycles = timing["total_cycles"];
    if (cycles == 0) return text;
    text += fmt::format("{} cycles: {:.0f} a frame, {:.2f} a fragment written\n",
                        cycles,
                        ratio(cycles, frames),
                        ratio(cycles, fragments));
    const double milliseconds = clock.milliseconds(cycles) / static_cast<double>(frames);
    text += fmt::format("at {} MHz: {:.3f} ms a frame, {:.1f} frames/s\n",
                        clock.core_mhz,
                        milliseconds,
                        1000.0 / milliseconds);
    return text + describe_units(timing) + describe_caches(timing) + describe_buses(timing) +
           describe_latency(timing) + describe_memory(timing, frames);
}

} // namespace ffgpu::tools
