// Histogram: how often each value came, declared where it is counted, as counters are
// (model/base/statistics.h). The reports loop over Machine::histograms().

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class Histogram {
public:
    // `unit` and `meaning`: of what is counted; string literals.
    Histogram(std::string name, std::string_view unit, std::string_view meaning)
        : name_(std::move(name))
        , unit_(unit)
        , meaning_(meaning) {}

    const std::string& name() const { return name_; }
    std::string_view unit() const { return unit_; }
    std::string_view meaning() const { return meaning_; }
    // Since the start; what is beyond the last has not come yet.
    const std::vector<std::uint64_t>& counts() const { return counts_; }

    // 0, 1, 2 to 3, 4 to 7 ...: the ranges of values that are not counted one by one.
    static std::size_t doubling(std::uint64_t value) {
        return static_cast<std::size_t>(std::bit_width(value));
    }
    void add(std::size_t place, std::uint64_t times = 1) {
        if (place >= counts_.size()) counts_.resize(place + 1);
        counts_[place] += times;
    }
    void set(std::vector<std::uint64_t> counts) { counts_ = std::move(counts); }

private:
    std::string name_;
    std::string_view unit_, meaning_;
    std::vector<std::uint64_t> counts_;
};

} // namespace ffgpu::timing
