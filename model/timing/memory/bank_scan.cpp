#include "model/timing/memory/bank_scan.h"

#include <algorithm>

namespace ffgpu::timing {

BanksFound scan_banks_plainly(const BankScan& scan) {
    BanksFound found;
    for (std::size_t bank = 0; bank < scan.banks; ++bank) {
        const std::uint64_t waiting = scan.of_bank[bank];
        const auto look_at_column = [&](std::uint64_t hits, MemoryCycle bus_at) {
            if ((waiting & hits) == 0) return;
            const MemoryCycle at = std::max(scan.times.column_at[bank], bus_at);
            found.column_is_due |= at <= scan.now;
            found.column_at = std::min(found.column_at, at);
        };
        look_at_column(scan.reads, scan.read_at);
        look_at_column(scan.writes, scan.write_at);
        if (waiting == 0 || (waiting & (scan.reads | scan.writes)) != 0) continue;
        const MemoryCycle activate_at = scan.activate_at & scan.times.closed[bank];
        const MemoryCycle at = std::max({scan.times.row_at[bank], activate_at, scan.row_slot});
        if (at <= scan.now) found.rows |= waiting;
        found.again_at = std::min(found.again_at, at);
    }
    found.again_at = std::min(found.again_at, found.column_at);
    return found;
}

} // namespace ffgpu::timing
