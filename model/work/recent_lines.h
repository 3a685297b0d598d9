// RecentLines: the top of the LRU stacks of one line size: the lines looked up last, newest first.
// Of all sets and ways at once these few tell where a line was that is found among them: in 2^l
// sets its position is the number of newer lines whose numbers share the lowest l bits. Most
// look-ups end here and touch no other stack.

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace ffgpu::work {

class RecentLines {
public:
    static constexpr unsigned Most = 16;

    struct Use {
        std::uint64_t place = 0; // of its last look-up
        std::uint32_t left = 0;  // which one it was to leave the top when it did last; 0: none
        std::uint32_t id = 0;
    };

    unsigned size() const { return size_; }
    bool full() const { return size_ == Most; }

    // Its position; size() if it is not there.
    unsigned find(std::uint64_t line) const {
        unsigned at = 0;
        while (at < size_ && lines_[at] != line)
            ++at;
        return at;
    }

    std::uint64_t line(unsigned at) const { return lines_[at]; }
    Use& use(unsigned at) { return uses_[at]; }
    const Use& use(unsigned at) const { return uses_[at]; }

    void to_front(unsigned at) {
        if (at == 0) return;
        const std::uint64_t line = lines_[at];
        const Use use = uses_[at];
        push(line, use, at);
    }
    // Not where it is full: drop_oldest() first.
    void add(std::uint64_t line, const Use& use) { push(line, use, size_++); }
    void drop_oldest() { --size_; }
    void clear() { size_ = 0; }

    // Sets up to which line `at` and `line` share one, as a power of two.
    unsigned shared(unsigned at, std::uint64_t line) const {
        return static_cast<unsigned>(std::countr_zero(lines_[at] ^ line));
    }

private:
    // The lines before `to` go down by one.
    void push(std::uint64_t line, const Use& use, unsigned to) {
        for (unsigned at = to; at > 0; --at) {
            lines_[at] = lines_[at - 1];
            uses_[at] = uses_[at - 1];
        }
        lines_[0] = line;
        uses_[0] = use;
    }

    std::array<std::uint64_t, Most> lines_{};
    std::array<Use, Most> uses_{};
    unsigned size_ = 0;
};

} // namespace ffgpu::work
