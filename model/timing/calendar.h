// Calendar: which units are due in which cycle. The next 64 cycles have a page each, with a bit a
// unit, the very next, which is named most, one of its own; what is further ahead is kept as one
// cycle a unit, its soonest.

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ffgpu::timing {

using Cycle = std::uint64_t;
inline constexpr Cycle Never = ~Cycle{0};

class Calendar {
public:
    static constexpr std::size_t MostUnits = 63;
    static constexpr Cycle Pages = 64;

    // The unit is due at cycle `at`, which is after `now`; Never: not at all. Mostly at the next:
    // that is inlined wherever somebody is woken, the rest is not.
    [[gnu::always_inline]] void add(std::size_t unit, Cycle at, Cycle now) {
        if (at == now + 1)
            next_page_ |= std::uint64_t{1} << unit;
        else if (at != Never)
            add_later(unit, at, now);
    }
    [[gnu::noinline]] void add_later(std::size_t unit, Cycle at, Cycle now) {
        if (at - now < Pages) {
            pages_[at % Pages] |= std::uint64_t{1} << unit;
            used_ |= std::uint64_t{1} << at % Pages;
        } else {
            later_[unit] = std::min(later_[unit], at);
            soonest_later_ = std::min(soonest_later_, at);
        }
    }

    // The first cycle after `now` in which a unit is due; Never: there is none.
    Cycle next(Cycle now) const {
        if (next_page_ != 0) return now + 1;
        if (used_ == 0) return soonest_later_;
        const auto first = static_cast<int>((now + 1) % Pages);
        const auto pages = static_cast<Cycle>(std::countr_zero(std::rotr(used_, first)));
        return std::min(now + 1 + pages, soonest_later_);
    }

    // The units that are due at `now`, a bit each; they are due no more. All cycles before have
    // been taken, or had none.
    std::uint64_t take(Cycle now) {
        std::uint64_t due = std::exchange(next_page_, 0);
        if (soonest_later_ <= now) due |= take_later(now);
        const std::uint64_t page = std::uint64_t{1} << now % Pages;
        if ((used_ & page) == 0) return due;
        used_ &= ~page;
        return due | std::exchange(pages_[now % Pages], 0);
    }

private:
    std::uint64_t take_later(Cycle now) {
        std::uint64_t due = 0;
        soonest_later_ = Never;
        for (std::size_t unit = 0; unit < later_.size(); ++unit) {
            if (later_[unit] <= now) {
                due |= std::uint64_t{1} << unit;
                later_[unit] = Never;
            }
            soonest_later_ = std::min(soonest_later_, later_[unit]);
        }
        return due;
    }

    std::uint64_t next_page_ = 0; // units due in the cycle after the one that was taken last
    std::array<std::uint64_t, Pages> pages_{};
    std::uint64_t used_ = 0; // pages with a unit, a bit each
    std::array<Cycle, MostUnits> later_ = filled_with_never();
    Cycle soonest_later_ = Never;

    static constexpr std::array<Cycle, MostUnits> filled_with_never() {
        std::array<Cycle, MostUnits> cycles{};
        cycles.fill(Never);
        return cycles;
    }
};

} // namespace ffgpu::timing
