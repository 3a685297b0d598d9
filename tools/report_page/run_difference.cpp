#include "tools/report_page/run_difference.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Totals = std::map<std::string, std::uint64_t>;

Totals totals_of(const RunFigures& figures) {
    Totals totals;
    for (const auto& [name, column] : figures.timing)
        totals[name] = total(column);
    return totals;
}

std::uint64_t value_of(const Totals& totals, const std::string& name) {
    const auto found = totals.find(name);
    return found == totals.end() ? 0 : found->second;
}

bool is_traffic(const std::string& name) {
    return name.starts_with("memory_") &&
           (name.ends_with("_read_bytes") || name.ends_with("_written_bytes"));
}

// "texel_cache" of "texel_cache_capacity_misses".
std::optional<std::string> cache_of(const std::string& name) {
    for (const char* const ending : {"_cache", "_l2"}) {
        const std::size_t at = name.find(std::string(ending) + '_');
        if (at == std::string::npos || name.starts_with("queue_") || !name.ends_with("_misses"))
            continue;
        return name.substr(0, at + std::string(ending).size());
    }
    return std::nullopt;
}

bool is_account(const std::string& name) {
    return name.ends_with("_busy_cycles") || name.ends_with("_idle_cycles") ||
           (name.find("_stalled_") != std::string::npos && name.ends_with("_cycles"));
}

bool tells_bottlenecks(const RunFigures& figures) {
    const std::pair<std::string, nlohmann::json> off{"bottlenecks.enable", false};
    return std::find(figures.configuration.begin(), figures.configuration.end(), off) ==
           figures.configuration.end();
}

std::uint64_t bytes_of(const Totals& totals) {
    std::uint64_t sum = 0;
    for (const auto& [name, value] : totals)
        if (is_traffic(name)) sum += value;
    return sum;
}

// Nothing: the figure is no part of a whole.
std::optional<FigureChange> change_of(const std::string& name, const Totals& before) {
    const std::uint64_t cycles = value_of(before, "total_cycles");
    if (name == "total_cycles" || name.starts_with("bottleneck_"))
        return FigureChange{.kind = EffectKind::Time, .name = name, .whole = cycles};
    if (is_traffic(name))
        return FigureChange{.kind = EffectKind::Traffic, .name = name, .whole = bytes_of(before)};
    if (const auto cache = cache_of(name))
        return FigureChange{.kind = EffectKind::Cache,
                            .name = name,
                            .whole = value_of(before, *cache + "_accesses")};
    if (is_account(name))
        return FigureChange{.kind = EffectKind::Account, .name = name, .whole = cycles};
    return std::nullopt;
}

std::vector<ParameterChange> changed_parameters(const RunFigures& before, const RunFigures& after) {
    std::map<std::string, nlohmann::json> known;
    for (const auto& [name, value] : before.configuration)
        known[name] = value;
    std::vector<ParameterChange> changes;
    for (const auto& [name, value] : after.configuration) {
        const auto found = known.find(name);
        const nlohmann::json former = found == known.end() ? nlohmann::json() : found->second;
        if (former != value) changes.push_back({name, former, value});
        if (found != known.end()) known.erase(found);
    }
    for (const auto& [name, value] : known)
        changes.push_back({name, value, nlohmann::json()});
    return changes;
}

std::string frames_of(const RunFigures& figures) {
    const auto& frames = figures.frames;
    return fmt::format(
        "{} frames from {} to {}", frames.size(), frames.front().number, frames.back().number);
}

} // namespace

double FigureChange::effect() const {
    if (whole == 0) return 0;
    const double change = static_cast<double>(after) - static_cast<double>(before);
    return change / static_cast<double>(whole);
}

void check_same_work(const RunFigures& before,
                     const RunFigures& after,
                     const std::pair<std::string, std::string>& names) {
    const auto numbers = [](const RunFigures& figures) {
        std::vector<std::uint64_t> list;
        for (const RunFrame& frame : figures.frames)
            list.push_back(frame.number);
        return list;
    };
    if (numbers(before) != numbers(after))
        throw InputError(fmt::format("{} has {}, {} {}: expected the same (--frames chooses some)",
                                     names.first,
                                     frames_of(before),
                                     names.second,
                                     frames_of(after)));
    for (const auto& [name, column] : before.functional) {
        const FigureColumn* const other = find_figure(after.functional, name);
        for (std::size_t i = 0; i < column.size(); ++i) {
            const std::uint64_t value = other ? (*other)[i] : 0;
            if (value == column[i]) continue;
            throw InputError(fmt::format("{} and {} are no runs of the same trace: in frame {} {} "
                                         "is {} and {}",
                                         names.first,
                                         names.second,
                                         before.frames[i].number,
                                         name,
                                         column[i],
                                         value));
        }
    }
    for (const auto& [figures, name] : {std::pair(&before, &names.first), {&after, &names.second}})
        if (!figures->has_timing())
            throw InputError(*name + ": has no timing to compare (--timing)");
}

RunDifference difference(const RunFigures& before, const RunFigures& after) {
    const Totals first = totals_of(before), second = totals_of(after);
    Totals both = first;
    both.insert(second.begin(), second.end());
    const bool both_tell_bottlenecks = tells_bottlenecks(before) && tells_bottlenecks(after);
    RunDifference result;
    result.configuration = changed_parameters(before, after);
    for (const auto& [name, ignored] : both) {
        if (name.starts_with("bottleneck_") && !both_tell_bottlenecks) continue;
        std::optional<FigureChange> change = change_of(name, first);
        if (!change) continue;
        change->before = value_of(first, name);
        change->after = value_of(second, name);
        if (change->before != change->after) result.figures.push_back(*change);
    }
    std::stable_sort(result.figures.begin(),
                     result.figures.end(),
                     [](const FigureChange& a, const FigureChange& b) {
                         return std::abs(a.effect()) > std::abs(b.effect());
                     });
    return result;
}

} // namespace ffgpu::tools
