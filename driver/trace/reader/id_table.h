// IdTable: what a trace defines at its first use and names by a small number from then on.

#pragma once

#include "driver/trace/reader/damage.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::trace {

template <class Entry>
class IdTable {
public:
    // Null where nothing was defined under that number yet.
    Entry* find(std::uint64_t id) const {
        return id < entries_.size() ? entries_[id].get() : nullptr;
    }

    // Entries stay where they are. A number that no tracer gives out is damage: it would make the
    // table large.
    Entry& define(std::uint64_t id, std::unique_ptr<Entry> entry) {
        if (id > MaxId)
            throw Damage{"expected a signature's number below " + std::to_string(MaxId) +
                         ", found " + std::to_string(id)};
        if (id >= entries_.size()) entries_.resize(id + 1);
        entries_[id] = std::move(entry);
        return *entries_[id];
    }

private:
    static constexpr std::uint64_t MaxId = 1 << 18;

    std::vector<std::unique_ptr<Entry>> entries_;
};

} // namespace ffgpu::trace
