// BankScan: one look at all banks of a channel where they are few: whether a column could go out,
// which requests could have their rows made ready, and if nothing, when something can.

#pragma once

#include "model/timing/memory/lost_cycles.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ffgpu::timing {

// Of the first banks: when each may take a column of its row, and when what it needs next for
// another row, as far as the bank decides.
struct BankTimes {
    static constexpr std::size_t Most = 8;

    constexpr BankTimes() { closed.fill(~MemoryCycle{0}); }

    std::array<MemoryCycle, Most> column_at{}, row_at{};
    std::array<MemoryCycle, Most> closed{}; // no row is open: all bits, or none
};

struct BankScan {
    std::size_t banks = 0; // at most BankTimes::Most
    const BankTimes& times;
    // Of requests a bit each. Of a bank a word; those behind the last bank are empty.
    const std::uint64_t* of_bank;
    std::uint64_t reads = 0, writes = 0;   // whose row is open
    MemoryCycle read_at = 0, write_at = 0; // The bus takes such a column.
    MemoryCycle activate_at = 0;           // of any bank
    MemoryCycle row_slot = 0;              // for an activate or a precharge
    MemoryCycle now = 0;
};

struct BanksFound {
    bool column_is_due = false;
    MemoryCycle column_at = NoCycle; // the first cycle in which a column may go out
    MemoryCycle again_at = NoCycle;  // the first in which a column or a row may
    // All requests of the banks that can be made ready for another row: those whose open row, if
    // there is one, nobody waits for.
    std::uint64_t rows = 0;
};

// By vectors; the plain form is what it must equal. Times are below 2^63.
void scan_banks(const BankScan& scan, BanksFound& found);
BanksFound scan_banks_plainly(const BankScan& scan);

} // namespace ffgpu::timing
