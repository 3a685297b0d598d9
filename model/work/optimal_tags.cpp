#include "model/work/optimal_tags.h"

namespace ffgpu::work {

OptimalTags::OptimalTags(std::uint32_t sets, std::uint32_t ways, IndexHash hash)
    : set_of_(sets, hash)
    , sets_(sets, Set{0, std::vector<std::uint64_t>(ways - 1, 0)}) {}

// Of the places that no other line was kept in between the line's look-ups, the one that became
// free last. An interval ends with a look-up that has a place of its own: the next may begin one
// look-up before.
std::size_t OptimalTags::place_since(const Set& set, std::uint64_t last_use) const {
    std::size_t best = set.kept_until.size();
    for (std::size_t i = 0; i < set.kept_until.size(); ++i) {
        if (set.kept_until[i] > last_use + 1) continue;
        if (best == set.kept_until.size() || set.kept_until[i] > set.kept_until[best]) best = i;
    }
    return best;
}

const std::uint64_t* OptimalTags::find(std::uint64_t line) const {
    const auto entry = lines_.find(line);
    if (entry == lines_.end()) return nullptr;
    const Set& set = sets_[set_of_(line)];
    const std::uint64_t last_use = entry->second.last_use;
    const bool again = last_use == set.lookups; // No look-up of the set came between.
    return again || place_since(set, last_use) < set.kept_until.size() ? &entry->second.fill
                                                                       : nullptr;
}

void OptimalTags::use(std::uint64_t line) {
    Line& entry = lines_[line];
    Set& set = sets_[set_of_(line)];
    if (entry.last_use != set.lookups)
        set.kept_until[place_since(set, entry.last_use)] = set.lookups + 1;
    count(line, entry);
}

void OptimalTags::replace(std::uint64_t line, std::uint64_t fill) {
    Line& entry = lines_[line];
    entry.fill = fill;
    count(line, entry);
}

void OptimalTags::count(std::uint64_t line, Line& entry) {
    entry.last_use = ++sets_[set_of_(line)].lookups;
}

void OptimalTags::clear() {
    lines_.clear();
    for (Set& set : sets_) {
        set.lookups = 0;
        set.kept_until.assign(set.kept_until.size(), 0);
    }
}

} // namespace ffgpu::work
