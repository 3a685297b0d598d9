// PositionTree: positions in an LRU stack in O(log n). Each line has a bit at the time of its last
// use; its position is the number of bits after it (B. T. Bennett, V. J. Kruskal, LRU Stack
// Processing, IBM J. Res. Dev. 19, 1975; with bits instead of counts at the leaves and no part for
// what is over: G. Almasi, C. Cascaval, D. A. Padua, Calculating Stack Distances Efficiently, MSP
// 2002). Here a node sums 64 below it, and what lies close to the newest bit is counted first: near
// uses cost a few words.

#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

class PositionTree {
public:
    PositionTree() { reset(FirstTimes); }

    // No time is left: renumber() first.
    bool is_full() const { return next_ == times_; }

    // Sets the bit of the next time, which is returned.
    std::uint32_t add() {
        const std::uint32_t time = next_++;
        words_[time / 64] |= std::uint64_t{1} << time % 64;
        ++word_bits_[time / 64];
        for (std::vector<std::uint32_t>& sums : sums_)
            ++sums[time >> shift_of(sums)];
        ++bits_;
        return time;
    }

    void clear(std::uint32_t time) {
        words_[time / 64] &= ~(std::uint64_t{1} << time % 64);
        --word_bits_[time / 64];
        for (std::vector<std::uint32_t>& sums : sums_)
            --sums[time >> shift_of(sums)];
        --bits_;
    }

    // Bits after `time`.
    std::uint32_t after(std::uint32_t time) const;
    std::uint32_t bits() const { return bits_; }

    // Calls each(time) for every bit, the newest first.
    template <class Each>
    void for_each_newest_first(Each&& each) const {
        for (std::size_t word = words_.size(); word-- > 0;)
            for (std::uint64_t rest = words_[word]; rest != 0;) {
                const auto bit = static_cast<std::uint32_t>(63 - std::countl_zero(rest));
                rest &= ~(std::uint64_t{1} << bit);
                each(static_cast<std::uint32_t>(64 * word) + bit);
            }
    }

    // Gives the bits the first times, in their order; calls moved(old, new) for each.
    template <class Moved>
    void renumber(Moved&& moved) {
        const std::vector<std::uint64_t> old = words_;
        reset(times_for(bits_));
        for (std::size_t word = 0; word < old.size(); ++word)
            for (std::uint64_t rest = old[word]; rest != 0; rest &= rest - 1)
                moved(static_cast<std::uint32_t>(64 * word) +
                          static_cast<std::uint32_t>(std::countr_zero(rest)),
                      add());
    }

    void reset() { reset(FirstTimes); }

private:
    static constexpr std::uint32_t FirstTimes = 1 << 14;

    // So many that renumbering is rare.
    static std::uint32_t times_for(std::uint32_t bits) {
        std::uint32_t times = FirstTimes;
        while (times / 4 < bits)
            times *= 2;
        return times;
    }
    // Times that an entry of these sums covers, as a power of two.
    unsigned shift_of(const std::vector<std::uint32_t>& sums) const {
        return 12 + 6 * static_cast<unsigned>(&sums - sums_.data());
    }
    void reset(std::uint32_t times);

    std::uint32_t times_ = 0, next_ = 0, bits_ = 0;
    std::vector<std::uint64_t> words_;
    std::vector<std::uint8_t> word_bits_;          // how many
    std::vector<std::vector<std::uint32_t>> sums_; // of 64 words, of 64 such sums ...
};

} // namespace ffgpu::work
