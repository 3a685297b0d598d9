// RecentLines: the top of the LRU stacks of one line size: the lines looked up last. Of all sets
// and ways at once these few tell where a line was that is found among them: in 2^l sets its
// position is the number of newer lines whose numbers share the lowest l bits. Most look-ups end
// here and touch no other stack.
//
// A look-up walks from the newest line down to its own and moves each a place further; what the
// lines that it meets add to the positions in all sets is one addition, of a word.

#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ffgpu::work {

// How many lines share a set with a line, four bits a number of sets: of 2 the lowest. Where there
// are none in so many sets, there are none in more.
using Sharers = std::uint64_t;

class RecentLines {
public:
    static constexpr unsigned Most = 16;
    static constexpr std::size_t MostLevels = 16; // of numbers of sets above 1

    // Lines that leave the top are counted: 1, 2, 3 ...
    using Time = std::uint64_t;
    static constexpr Time Unused = ~Time{0};

    struct Use {
        std::uint64_t line = 0;
        std::uint64_t place = 0; // of its last look-up
        Time left = Unused;      // when it left the top last; 0: never
        std::uint32_t id = 0;
    };

    // `levels`: numbers of sets that are told.
    explicit RecentLines(std::size_t levels) {
        for (std::size_t bits = 1; bits < shared_.size(); ++bits)
            shared_[bits] =
                shared_[bits - 1] | (bits <= levels ? Sharers{1} << (4 * (bits - 1)) : 0);
    }

    unsigned size() const { return size_; }
    bool full() const { return size_ == Most; }

    struct Found {
        unsigned depth = Most; // lines that were newer; `Most`, if it was not here
        Sharers sharers = 0;   // among these
    };
    // Makes the line the newest. One that was not here takes the slot of the oldest, if all are
    // taken: newest() is that one's then, until it is set.
    Found use(std::uint64_t line) {
        Sharers sharers = 0;
        std::uint64_t moved = line;
        for (unsigned depth = 0; depth < size_; ++depth) {
            const std::uint64_t other = std::exchange(lines_[depth], moved);
            if (other == line) {
                to_front(depth);
                return {depth, sharers};
            }
            sharers += shared_[static_cast<unsigned>(std::countr_zero(other ^ line))];
            moved = other;
        }
        if (!full()) lines_[size_++] = moved;
        to_front(size_ - 1);
        return {};
    }

    Use& newest() { return uses_[order_ % Most]; }
    bool has(std::uint64_t line) const {
        unsigned depth = 0;
        while (depth < size_ && lines_[depth] != line)
            ++depth;
        return depth < size_;
    }
    // In no order; those without a line have `left` Unused.
    std::array<Use, Most>& uses() { return uses_; }
    const std::array<Use, Most>& uses() const { return uses_; }

    // Calls each(use), the oldest first, and forgets them.
    template <class Each>
    void all_leave(Each&& each) {
        for (; size_ > 0; --size_) {
            Use& oldest = uses_[order_ >> (4 * (size_ - 1)) & (Most - 1)];
            each(oldest);
            oldest = {};
        }
    }

private:
    void to_front(unsigned depth) {
        const std::uint64_t slot = order_ >> (4 * depth) & (Most - 1);
        const std::uint64_t newer = order_ & ((std::uint64_t{1} << (4 * depth)) - 1);
        const std::uint64_t older = order_ & (~std::uint64_t{0} << (4 * depth) << 4);
        order_ = older | newer << 4 | slot;
    }

    // By the number of lowest bits that two lines share: one for each number of sets in which they
    // share a set. All 15 newer lines fit into four bits.
    std::array<Sharers, 64> shared_{};
    std::array<std::uint64_t, Most> lines_{}; // the newest first
    unsigned size_ = 0;
    std::uint64_t order_ = 0xfedcba9876543210; // of slots, four bits each, the newest first
    std::array<Use, Most> uses_{};             // by slot
};

} // namespace ffgpu::work
