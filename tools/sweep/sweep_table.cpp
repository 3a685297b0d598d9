#include "tools/sweep/sweep_table.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::json;

bool is_memory_traffic(const std::string& counter) {
    return counter.starts_with("memory_") &&
           (counter.ends_with("_read_bytes") || counter.ends_with("_written_bytes"));
}

SweepRow read_result(const std::filesystem::path& path, const DesignPoint& point) {
    std::ifstream file(path);
    const Json json = Json::parse(file, nullptr, false);
    if (json.is_discarded() || !json.contains("totals"))
        throw InputError(path.string() + ": is no result of a sweep; remove it and sweep again");
    SweepRow row{.point = &point};
    row.is_stuck = json.value("stuck", false);
    row.frames = json.value("frame_count", std::uint64_t{0});
    if (json["totals"].contains("timing"))
        for (const auto& [name, value] : json["totals"]["timing"].items())
            row.counters[name] = value.get<std::uint64_t>();
    row.cycles = row.counters.contains("total_cycles") ? row.counters["total_cycles"] : 0;
    for (const auto& [name, value] : row.counters)
        if (is_memory_traffic(name)) row.memory_bytes += value;
    row.milliseconds = point.configuration.timing.clock.milliseconds(row.cycles);
    return row;
}

// Sets `flag` of the rows that are on the front of cycles against `price`.
template <class Price>
void mark_best(std::span<SweepRow> rows, const Price& price, bool SweepRow::*flag) {
    std::vector<SweepRow*> order;
    for (SweepRow& row : rows)
        if (!row.is_stuck) order.push_back(&row);
    std::sort(order.begin(), order.end(), [&](const SweepRow* a, const SweepRow* b) {
        return std::pair(price(*a), a->cycles) < std::pair(price(*b), b->cycles);
    });
    std::uint64_t fewest = ~std::uint64_t{0}; // at a lower price
    for (std::size_t i = 0; i < order.size();) {
        const std::uint64_t least = order[i]->cycles, own_price = price(*order[i]);
        for (; i < order.size() && price(*order[i]) == own_price; ++i)
            order[i]->*flag = order[i]->cycles == least && least < fewest;
        fewest = std::min(fewest, least);
    }
}

} // namespace

std::vector<SweepRow> read_results(const SweepPlan& plan, const UnitCosts& units) {
    std::vector<SweepRow> rows;
    for (const SweepTrace& trace : plan.traces) {
        const std::size_t begin = rows.size();
        for (const DesignPoint& point : plan.space.points) {
            const std::filesystem::path path = plan.result(trace, point);
            if (!std::filesystem::exists(path)) continue;
            rows.push_back(read_result(path, point));
            rows.back().trace = &trace;
            if (!units.empty()) rows.back().cost = machine_cost(point.configuration.timing, units);
        }
        const std::span<SweepRow> own = std::span(rows).subspan(begin);
        mark_best(
            own, [](const SweepRow& r) { return r.memory_bytes; }, &SweepRow::is_best_by_bytes);
        if (!units.empty())
            mark_best(
                own, [](const SweepRow& r) { return r.cost; }, &SweepRow::is_best_by_cost);
    }
    return rows;
}

std::string table_text(const SweepPlan& plan, const std::vector<SweepRow>& rows) {
    std::set<std::string> counters;
    for (const SweepRow& row : rows)
        for (const auto& [name, value] : row.counters)
            if (name != "total_cycles") counters.insert(name);
    std::string text = "trace,point";
    for (const std::string& parameter : plan.space.parameters)
        text += ',' + parameter;
    text += ",stuck,frames,cycles,milliseconds,memory_bytes,cost,best_by_bytes,best_by_cost";
    for (const std::string& name : counters)
        text += ',' + name;
    text += '\n';
    for (const SweepRow& row : rows) {
        text += row.trace->name + ',' + row.point->id;
        for (const std::string& value : row.point->values)
            text += ',' + (value[0] == '"' ? value.substr(1, value.size() - 2) : value);
        text += fmt::format(",{},{},{},{:.6f},{},{},{},{}",
                            int{row.is_stuck},
                            row.frames,
                            row.cycles,
                            row.milliseconds,
                            row.memory_bytes,
                            row.cost > 0 ? std::to_string(row.cost) : "",
                            int{row.is_best_by_bytes},
                            int{row.is_best_by_cost});
        for (const std::string& name : counters) {
            text += ',';
            const auto found = row.counters.find(name);
            if (found != row.counters.end()) text += std::to_string(found->second);
        }
        text += '\n';
    }
    return text;
}

} // namespace ffgpu::tools
