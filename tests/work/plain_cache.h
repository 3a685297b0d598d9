// A set-associative LRU cache as a textbook has it, to hold faster ones against: nothing of it is
// shared with them, and nothing in it is quick.

#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace ffgpu::test {

struct PlainCounts {
    std::uint64_t accesses = 0, misses = 0, compulsory = 0, capacity = 0, conflict = 0;
    std::uint64_t hits_beyond_lru = 0, write_backs = 0;
};

// Lines in the order of their last use, and where each is.
class PlainLru {
public:
    explicit PlainLru(std::size_t capacity)
        : capacity_(capacity) {}

    struct Line {
        std::uint64_t number = 0;
        bool dirty = false;
    };

    // Null: it is not there.
    const Line* find(std::uint64_t number) const {
        const auto found = places_.find(number);
        return found == places_.end() ? nullptr : &*found->second;
    }
    void remove(std::uint64_t number) {
        const auto found = places_.find(number);
        if (found == places_.end()) return;
        order_.erase(found->second);
        places_.erase(found);
    }
    // As the last used; it is not there. Returns the line that has to go.
    std::optional<Line> insert(const Line& line) {
        std::optional<Line> victim;
        if (order_.size() == capacity_) {
            victim = order_.back();
            remove(victim->number);
        }
        order_.push_front(line);
        places_[line.number] = order_.begin();
        return victim;
    }
    const std::list<Line>& lines() const { return order_; }
    void clear() {
        order_.clear();
        places_.clear();
    }

private:
    std::size_t capacity_;
    std::list<Line> order_;
    std::unordered_map<std::uint64_t, std::list<Line>::iterator> places_;
};

class PlainCache {
public:
    PlainCache(std::uint64_t sets, std::size_t ways)
        : content_(sets, PlainLru(ways))
        , shadow_(sets * ways) {}

    // True: a hit.
    bool access(std::uint64_t line, bool write) {
        ++counts.accesses;
        const bool full_hit = shadow_.find(line) != nullptr;
        shadow_.remove(line);
        shadow_.insert({line, false});
        PlainLru& set = content_[line % content_.size()];
        const PlainLru::Line* const found = set.find(line);
        const bool hit = found != nullptr;
        const bool dirty = write || (hit && found->dirty);
        if (hit && !full_hit) ++counts.hits_beyond_lru;
        if (!hit) count_miss(line, full_hit);
        set.remove(line);
        if (const auto victim = set.insert({line, dirty})) counts.write_backs += victim->dirty;
        seen_.insert(line);
        return hit;
    }

    void flush() {
        for (PlainLru& set : content_) {
            for (const PlainLru::Line& line : set.lines())
                counts.write_backs += line.dirty;
            set.clear();
        }
        shadow_.clear();
        seen_.clear();
    }

    void overwrite(std::uint64_t line, bool whole) {
        PlainLru& set = content_[line % content_.size()];
        const PlainLru::Line* const found = set.find(line);
        if (found && found->dirty && !whole) ++counts.write_backs;
        set.remove(line);
        shadow_.remove(line);
        seen_.erase(line);
    }

    PlainCounts counts;

private:
    void count_miss(std::uint64_t line, bool full_hit) {
        ++counts.misses;
        if (seen_.count(line) == 0)
            ++counts.compulsory;
        else if (!full_hit || content_.size() == 1)
            ++counts.capacity;
        else
            ++counts.conflict;
    }

    std::vector<PlainLru> content_;
    PlainLru shadow_; // the fully associative cache of the size
    std::unordered_set<std::uint64_t> seen_;
};

} // namespace ffgpu::test
