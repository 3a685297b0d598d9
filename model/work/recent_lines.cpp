#include "model/work/recent_lines.h"

#include "model/base/check.h"

namespace ffgpu::work {
namespace {

unsigned slot_of(const RecentLineSlots& all, std::uint64_t line) {
    for (unsigned slot = 0; slot < RecentLineSlots::Count; ++slot)
        if ((all.used >> slot & 1) != 0 && all.low[slot] == static_cast<std::uint32_t>(line) &&
            all.high[slot] == line >> 32)
            return slot;
    return RecentLineSlots::Count;
}

void make_newest(RecentLineSlots& all, unsigned slot) {
    for (LineSlots& newer : all.newer)
        newer |= static_cast<LineSlots>(1u << slot);
    all.newer[slot] = 0;
}

} // namespace

std::size_t sharers_plainly(const RecentLineSlots& all,
                            LineSlots slots,
                            std::uint64_t line,
                            std::span<std::uint32_t> counts) {
    for (std::size_t level = 0; level < counts.size(); ++level) {
        const std::uint64_t set_bits = (std::uint64_t{2} << level) - 1;
        std::uint32_t count = 0;
        for (unsigned slot = 0; slot < RecentLineSlots::Count; ++slot)
            count += (slots >> slot & 1) != 0 && ((all.low[slot] ^ line) & set_bits) == 0;
        if (count == 0) return level;
        counts[level] = count;
    }
    return counts.size();
}

RecentUse
use_recent_plainly(RecentLineSlots& all, std::uint64_t line, std::span<std::uint32_t> counts) {
    const unsigned slot = slot_of(all, line);
    if (slot == RecentLineSlots::Count) return {};
    const auto newer = static_cast<LineSlots>(all.newer[slot] & all.used);
    make_newest(all, slot);
    return {slot,
            static_cast<std::uint32_t>(std::popcount(newer)),
            sharers_plainly(all, newer, line, counts)};
}

LineSlots left_by_plainly(const RecentLineSlots& all, std::uint32_t left) {
    LineSlots slots = 0;
    for (unsigned slot = 0; slot < RecentLineSlots::Count; ++slot)
        if ((all.used >> slot & 1) != 0 && all.left[slot] <= left)
            slots |= static_cast<LineSlots>(1u << slot);
    return slots;
}

unsigned oldest_slot_plainly(const RecentLineSlots& all) {
    unsigned slot = 0;
    while ((all.used >> slot & 1) == 0 || ((all.newer[slot] | 1u << slot) & all.used) != all.used)
        ++slot;
    return slot;
}

unsigned RecentLines::slot_of(std::uint64_t line) const {
    return work::slot_of(slots_, line);
}

void RecentLines::add(std::uint64_t line, const Use& use) {
    check(!full(), "a slot for a line");
    newest_ = static_cast<unsigned>(std::countr_one(slots_.used));
    newest_line_ = line;
    slots_.low[newest_] = static_cast<std::uint32_t>(line);
    slots_.high[newest_] = static_cast<std::uint32_t>(line >> 32);
    slots_.left[newest_] = use.left;
    slots_.used |= static_cast<LineSlots>(1u << newest_);
    places_[newest_] = use.place;
    ids_[newest_] = use.id;
    make_newest(slots_, newest_);
}

} // namespace ffgpu::work
