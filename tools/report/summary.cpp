#include "tools/report/summary.h"

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
    for (const std::string cache : {"vertex_cache", "texel_cache", "depth_cache", "color_cache"}) {
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

std::string describe_memory(const Figures& timing, std::size_t frames) {
    std::string text = "  memory traffic a frame, KB read + written:";
    for (const std::string client : {"command", "vertex", "texture", "depth", "color"}) {
        const auto kilobytes = [&](const char* what) {
            return ratio(timing["memory_" + client + what], frames) / 1024;
        };
        text += fmt::format(
            " {} {:.0f} + {:.0f}", client, kilobytes("_read_bytes"), kilobytes("_written_bytes"));
        text += client == "color" ? "\n" : ",";
    }
    return text;
}

} // namespace

std::string summarize(const Json& totals, std::size_t frames) {
    if (frames == 0) return "no frames\n";
    static const Json None = Json::object();
    const auto group = [&](const char* name) -> const Json& {
        return totals.contains(name) ? totals[name] : None;
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
    return text + describe_units(timing) + describe_caches(timing) +
           describe_memory(timing, frames);
}

} // namespace ffgpu::tools
