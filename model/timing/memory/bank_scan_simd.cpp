// scan_banks() by vectors: four banks at a time, or as many as the processor has lanes for.

#include "model/base/simd_targets.h"
#include "model/timing/memory/bank_scan.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/timing/memory/bank_scan_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::timing::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Signed: most processors compare these alone.
using D = hn::CappedTag<std::int64_t, 4>;
using Lanes = hn::Vec<D>;
constexpr std::int64_t Never = std::numeric_limits<std::int64_t>::max();

HWY_INLINE Lanes load(const std::uint64_t* words) {
    return hn::LoadU(D(), reinterpret_cast<const std::int64_t*>(words));
}
HWY_INLINE Lanes all(std::uint64_t word) {
    return hn::Set(D(), static_cast<std::int64_t>(word));
}

// All lanes as one; in registers, since words that were stored one by one are waited for.
template <class Two>
HWY_INLINE std::int64_t folded(Lanes lanes, const Two& two) {
    constexpr std::size_t Step = hn::MaxLanes(D());
    static_assert(Step == 2 || Step == 4);
    if constexpr (Step == 4) {
        const hn::Half<D> half;
        const auto pair = two(hn::LowerHalf(half, lanes), hn::UpperHalf(half, lanes));
        return hn::GetLane(two(pair, hn::Shuffle01(pair)));
    } else {
        return hn::GetLane(two(lanes, hn::Shuffle01(lanes)));
    }
}

void scan_lanes(const BankScan& scan, BanksFound& found) {
    const D d;
    constexpr std::size_t Step = hn::MaxLanes(d);
    static_assert(BankTimes::Most % Step == 0);
    const Lanes nothing = hn::Zero(d), never = hn::Set(d, Never), now = all(scan.now);
    Lanes columns = never, rows_at = never, rows = nothing;
    for (std::size_t bank = 0; bank < scan.banks; bank += Step) {
        const Lanes waiting = load(scan.of_bank + bank);
        const Lanes reads = hn::And(waiting, all(scan.reads));
        const Lanes writes = hn::And(waiting, all(scan.writes));
        const Lanes column_at = load(scan.times.column_at.data() + bank);
        const Lanes read_at = hn::Max(column_at, all(scan.read_at));
        const Lanes write_at = hn::Max(column_at, all(scan.write_at));
        columns = hn::Min(columns, hn::IfThenElse(hn::Eq(reads, nothing), never, read_at));
        columns = hn::Min(columns, hn::IfThenElse(hn::Eq(writes, nothing), never, write_at));
        const Lanes closed = load(scan.times.closed.data() + bank);
        const Lanes own_at = hn::Max(load(scan.times.row_at.data() + bank), all(scan.row_slot));
        const Lanes row_at = hn::Max(own_at, hn::And(all(scan.activate_at), closed));
        const auto has_hits = hn::Ne(hn::Or(reads, writes), nothing);
        const auto wants_none = hn::Or(has_hits, hn::Eq(waiting, nothing));
        const Lanes wanted_at = hn::IfThenElse(wants_none, never, row_at);
        rows_at = hn::Min(rows_at, wanted_at);
        rows = hn::Or(rows, hn::IfThenZeroElse(hn::Gt(wanted_at, now), waiting));
    }
    const auto least = [](auto one, auto other) { return hn::Min(one, other); };
    const std::int64_t column = folded(columns, least);
    const std::int64_t first = std::min(column, folded(rows_at, least));
    const std::int64_t any_rows =
        folded(rows, [](auto one, auto other) { return hn::Or(one, other); });
    found.column_is_due = column <= static_cast<std::int64_t>(scan.now);
    found.column_at = column == Never ? NoCycle : static_cast<MemoryCycle>(column);
    found.again_at = first == Never ? NoCycle : static_cast<MemoryCycle>(first);
    found.rows = static_cast<std::uint64_t>(any_rows);
}

} // namespace
} // namespace ffgpu::timing::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::timing {

HWY_EXPORT(scan_lanes);

void scan_banks(const BankScan& scan, BanksFound& found) {
    HWY_DYNAMIC_DISPATCH(scan_lanes)(scan, found);
}

} // namespace ffgpu::timing
#endif
