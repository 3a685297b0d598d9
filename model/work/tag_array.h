// TagArray: a set-associative cache's tags. A pure data structure: no time, no memory. Which line
// gives way, and which set a line belongs to, are the policy's.

#pragma once

#include "model/work/replacement.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

class TagArray {
public:
    static constexpr std::uint64_t Empty = ~std::uint64_t{0};

    // What the owner keeps with a line.
    struct Line {
        std::uint64_t fill = 0;  // ticket of the fill that brings or brought it
        std::uint64_t valid = 0; // LineMask: bytes that are here or on their way
        std::uint64_t dirty = 0; // LineMask: bytes that memory does not have yet
    };
    struct Evicted {
        std::uint64_t number = Empty;
        Line line;
    };

    // `sets` a power of two; sets = 1 is fully associative.
    TagArray(std::uint32_t sets, std::uint32_t ways, const CachePolicy& policy = {})
        : set_of_(sets, policy.index_hash)
        , policy_(policy)
        , ways_(ways)
        , numbers_(std::size_t{sets} * ways, Empty)
        , stamps_(numbers_.size(), 0)
        , lines_(numbers_.size()) {}

    // The line where it is present, else null. Does not count as a use.
    Line* find(std::uint64_t number) {
        std::uint32_t& guess = guess_of(number);
        if (numbers_[guess] == number) return &lines_[guess];
        const std::size_t at = place_of(number);
        if (at == numbers_.size()) return nullptr;
        guess = static_cast<std::uint32_t>(at);
        return &lines_[at];
    }

    // A look-up used a line that find() gave.
    void use(const Line& line, std::uint64_t next_use = NeverUsedAgain) {
        policy_.used(stamps_[place(line)], {++now_, next_use});
    }

    // Gives `number`, which is absent, a place: an empty one of its set or the victim's, whose line
    // goes to `evicted`.
    Line& replace(std::uint64_t number, Evicted& evicted, std::uint64_t next_use = NeverUsedAgain) {
        const std::size_t set = set_of_(number) * ways_;
        std::size_t way = 0;
        while (way < ways_ && numbers_[set + way] != Empty)
            ++way;
        if (way == ways_) way = policy_.victim(std::span(stamps_).subspan(set, ways_));
        const std::size_t at = set + way;
        guess_of(number) = static_cast<std::uint32_t>(at);
        evicted = {numbers_[at], lines_[at]};
        numbers_[at] = number;
        lines_[at] = {};
        policy_.filled(stamps_[at], {++now_, next_use});
        return lines_[at];
    }

    // Empties the place of a line that find() gave.
    void drop(Line& line) {
        numbers_[place(line)] = Empty;
        line = {};
    }

    // Calls each(number, line) for every line present, all sets of a way before the next way's:
    // lines that came one behind the other follow each other. The call may drop it.
    template <class Each>
    void for_each(Each&& each) {
        for (std::size_t way = 0; way < ways_; ++way)
            for (std::size_t i = way; i < numbers_.size(); i += ways_)
                if (numbers_[i] != Empty) each(numbers_[i], lines_[i]);
    }

    std::size_t size() const { return numbers_.size(); }

    // Where a line that find() or replace() gave stands, below size(): set times ways and its way.
    // The empty places of a set are taken from its first way on.
    std::size_t place(const Line& line) const {
        return static_cast<std::size_t>(&line - lines_.data());
    }

private:
    std::uint32_t& guess_of(std::uint64_t number) { return guesses_[number % Guesses]; }
    std::size_t place_of(std::uint64_t number) const {
        const std::size_t begin = set_of_(number) * ways_;
        if (ways_ > MostAtOnce) {
            const auto first = numbers_.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto end = first + static_cast<std::ptrdiff_t>(ways_);
            const auto found = std::find(first, end, number);
            return static_cast<std::size_t>(found == end ? numbers_.end() - numbers_.begin()
                                                         : found - numbers_.begin());
        }
        // Which way it is cannot be foretold: all are compared.
        unsigned found = 0;
        for (std::size_t way = 0; way < ways_; ++way)
            found |= unsigned{numbers_[begin + way] == number} << way;
        return found == 0 ? numbers_.size()
                          : begin + static_cast<std::size_t>(std::countr_zero(found));
    }

    static constexpr std::size_t MostAtOnce = 16;

    SetIndex set_of_;
    ReplacementPolicy policy_;
    std::size_t ways_;
    std::uint64_t now_ = 0;
    // Where the last line of a number with the same end was found: the next is often the same.
    static constexpr std::size_t Guesses = 64;
    std::array<std::uint32_t, Guesses> guesses_{};
    // Apart, so that the search reads nothing else.
    std::vector<std::uint64_t> numbers_;
    std::vector<std::uint64_t> stamps_;
    std::vector<Line> lines_;
};

} // namespace ffgpu::work
