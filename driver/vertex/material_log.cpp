#include "driver/vertex/material_log.h"

#include <algorithm>
#include <utility>

namespace ffgpu::gl {

namespace {

// From the end: that is where it is asked for.
const Materials& materials_of(std::span<const MaterialChange> changes, std::uint32_t vertex) {
    std::size_t i = changes.size() - 1;
    while (changes[i].vertex > vertex)
        --i;
    return changes[i].materials;
}

} // namespace

void MaterialLog::change(std::uint32_t vertex, const Materials& before, const Materials& after) {
    if (changes_.empty()) changes_.push_back({0, before});
    if (changes_.back().vertex == vertex) {
        changes_.back().materials = after;
    } else {
        changes_.push_back({vertex, after});
    }
}

void MaterialLog::repeat(std::uint32_t original, std::uint32_t vertex) {
    if (changes_.empty()) return;
    const Materials latest = changes_.back().materials;
    const Materials repeated = materials_of(changes_, original);
    change(vertex, latest, repeated);
    change(vertex + 1, latest, latest);
}

void MaterialLog::keep_vertices(std::uint32_t count) {
    if (changes_.empty() || changes_.back().vertex <= count) return;
    MaterialChange latest = changes_.back();
    latest.vertex = count;
    const auto is_gone = [count](const MaterialChange& change) { return change.vertex >= count; };
    changes_.erase(std::find_if(changes_.begin(), changes_.end(), is_gone), changes_.end());
    if (count != 0) changes_.push_back(latest);
}

void MaterialLog::select(std::span<const std::uint32_t> kept) {
    if (changes_.empty()) return;
    const std::vector<MaterialChange> old = std::exchange(changes_, {});
    const bool is_uniform = std::all_of(
        kept.begin(), kept.end(), [&old](std::uint32_t i) { return i >= old.back().vertex; });
    if (is_uniform) return;
    for (std::uint32_t i = 0; i < kept.size(); ++i)
        changes_.push_back({i, materials_of(old, kept[i])});
    changes_.push_back({static_cast<std::uint32_t>(kept.size()), old.back().materials});
}

} // namespace ffgpu::gl
