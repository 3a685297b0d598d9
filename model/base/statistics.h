// Statistics: a counter is declared where it is counted, with its unit and meaning; the report
// loops over the groups and prints them in the order of declaration.

#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>

namespace ffgpu {

class Counter {
public:
    Counter(std::string_view name, std::string_view unit, std::string_view meaning)
        : name_(name)
        , unit_(unit)
        , meaning_(meaning) {}

    Counter& operator++() { return ++value_, *this; }
    Counter& operator+=(std::uint64_t n) { return value_ += n, *this; }
    void reset() { value_ = 0; }

    std::uint64_t value() const { return value_; }
    std::string_view name() const { return name_; }
    std::string_view unit() const { return unit_; }
    std::string_view meaning() const { return meaning_; }

private:
    std::string_view name_, unit_, meaning_; // String literals.
    std::uint64_t value_ = 0;
};

// A unit's counters. Derive, and declare each counter as a reference member:
//     Counter& fragments_in = count("fragments_in", "fragments", "fragments that entered");
class StatisticsGroup {
public:
    StatisticsGroup() = default;
    StatisticsGroup(const StatisticsGroup&) = delete;
    StatisticsGroup& operator=(const StatisticsGroup&) = delete;

    const std::deque<Counter>& counters() const { return counters_; }
    // Groups of the same counters, in the same order.
    void set_to_sum_of(std::span<const StatisticsGroup* const> parts) {
        for (std::size_t i = 0; i < counters_.size(); ++i) {
            counters_[i].reset();
            for (const StatisticsGroup* part : parts)
                counters_[i] += part->counters_[i].value();
        }
    }
    // A group of the same counters gives up what it has counted.
    void take_over(StatisticsGroup& other) {
        for (std::size_t i = 0; i < counters_.size(); ++i)
            counters_[i] += other.counters_[i].value();
        other.reset();
    }
    void reset() {
        for (Counter& counter : counters_)
            counter.reset();
    }

protected:
    Counter& count(std::string_view name, std::string_view unit, std::string_view meaning) {
        return counters_.emplace_back(name, unit, meaning);
    }

private:
    std::deque<Counter> counters_; // A deque, so that the references handed out stay valid.
};

} // namespace ffgpu
