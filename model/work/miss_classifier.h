// MissClassifier: Hill's three kinds of miss. Compulsory: the line was never touched before.
// Capacity: a fully associative cache of the same size with LRU replacement would miss, too.
// Conflict: the rest. (M. D. Hill, Aspects of Cache Memory and Instruction Buffer Performance,
// 1987)

#pragma once

#include <cstdint>
#include <list>
#include <unordered_map>
#include <unordered_set>

namespace ffgpu::work {

enum class MissKind : std::uint8_t { Compulsory, Capacity, Conflict };

class MissClassifier {
public:
    explicit MissClassifier(std::size_t lines)
        : capacity_(lines) {}

    // Every access goes through here, hit or miss; the result says what it is if it was a miss.
    MissKind access(std::uint64_t line) {
        const bool fully_associative_hit = touch(line);
        if (seen_.insert(line).second) return MissKind::Compulsory;
        return fully_associative_hit ? MissKind::Conflict : MissKind::Capacity;
    }

private:
    bool touch(std::uint64_t line) {
        if (!order_.empty() && order_.front() == line) return true;
        const auto found = where_.find(line);
        if (found != where_.end()) {
            order_.splice(order_.begin(), order_, found->second);
            return true;
        }
        if (order_.size() == capacity_) {
            where_.erase(order_.back());
            order_.pop_back();
        }
        order_.push_front(line);
        where_.emplace(line, order_.begin());
        return false;
    }

    std::size_t capacity_;
    std::list<std::uint64_t> order_; // Most recently used first.
    std::unordered_map<std::uint64_t, std::list<std::uint64_t>::iterator> where_;
    std::unordered_set<std::uint64_t> seen_;
};

} // namespace ffgpu::work
