#include "model/work/line_numbers.h"

#include "model/base/check.h"

namespace ffgpu::work {

// D. E. Knuth's multiplicative hash: 2^64 over the golden ratio.
std::size_t LineNumbers::place_of(std::uint64_t page) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>((page * 0x9e3779b97f4a7c15u) >> 20) & mask;
    while (slots_[at].page != NoPage && slots_[at].page != page)
        at = (at + 1) & mask;
    return at;
}

const LineNumbers::Slot& LineNumbers::find(std::uint64_t page) {
    std::size_t at = place_of(page);
    if (slots_[at].page == page) return slots_[at];
    if (2 * (used_ + 1) > slots_.size()) {
        grow();
        at = place_of(page);
    }
    ++used_;
    check(end_ <= ~std::uint32_t{0} - 2 * PageLines, "lines that 32 bits number");
    slots_[at] = {page, end_};
    end_ += PageLines;
    return slots_[at];
}

void LineNumbers::grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
        if (slot.page != NoPage) slots_[place_of(slot.page)] = slot;
}

} // namespace ffgpu::work
