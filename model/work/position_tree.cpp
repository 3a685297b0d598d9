#include "model/work/position_tree.h"

#include <algorithm>

namespace ffgpu::work {

void PositionTree::reset(std::uint32_t times) {
    times_ = times;
    next_ = bits_ = 0;
    words_.assign(times / 64, 0);
    word_bits_.assign(times / 64, 0);
    sums_.clear();
    std::uint32_t nodes = times / 64;
    do {
        nodes = (nodes + 63) / 64;
        sums_.emplace_back(nodes, 0);
    } while (nodes > 64);
}

std::uint32_t PositionTree::after(std::uint32_t time) const {
    std::uint32_t at = time / 64, last = (next_ - 1) / 64; // of the level
    auto count =
        static_cast<std::uint32_t>(std::popcount(words_[at] & (~std::uint64_t{1} << time % 64)));
    for (std::uint32_t end = std::min(at | 63, last); at < end;)
        count += word_bits_[++at];
    for (const std::vector<std::uint32_t>& sums : sums_) {
        at /= 64;
        last /= 64;
        const bool top = &sums == &sums_.back();
        for (std::uint32_t end = top ? last : std::min(at | 63, last); at < end;)
            count += sums[++at];
    }
    return count;
}

} // namespace ffgpu::work
