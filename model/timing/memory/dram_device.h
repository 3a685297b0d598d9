// DramDevice: the DRAM of one channel, as what it forbids. It knows when each command is allowed
// and why not earlier; which command goes out is the scheduler's business.

#pragma once

#include "model/timing/memory/bank_scan.h"
#include "model/timing/memory/config.h"
#include "model/timing/memory/dram_request.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ffgpu::timing {

// The first cycle in which a command may go out, and what its wait is charged to.
struct Ready {
    MemoryCycle at = 0;
    LostTo cause = LostTo::NoRequest;

    void not_before(MemoryCycle other, LostTo why) {
        if (other > at) *this = {other, why};
    }
};

struct DataBurst {
    MemoryCycle begin = 0, end = 0;
};

class DramDevice {
public:
    static constexpr std::uint64_t NoRow = ~std::uint64_t{0};

    explicit DramDevice(const MemoryConfig& config);

    std::uint64_t open_row(std::uint32_t bank) const { return banks_[bank].row; }
    bool any_row_open() const;

    Ready activate_ready(std::uint32_t bank) const;
    Ready precharge_ready(std::uint32_t bank) const;
    Ready column_ready(const DramRequest& request) const;
    // The same without the cause.
    MemoryCycle activate_ready_at(std::uint32_t bank) const {
        return std::max({banks_[bank].activate_at,
                         next_activate_,
                         activates_[oldest_activate_],
                         refreshed_at_});
    }
    // The bank, which has no row, could be activated sooner, were it not for others' activates.
    bool is_activate_held(std::uint32_t bank) const {
        return banks_[bank].activate_at < any_activate_at();
    }
    // An activate of another bank at `later` is nearer to one at `now` than tRRD.
    bool is_too_near(MemoryCycle now, MemoryCycle later) const {
        return later < now + config_.activate_to_activate_cycles;
    }
    // Of the request's columns from `now` on one behind the first takes the slot of an activate,
    // which a column later would leave, and rows of such requests go by the distance of activates,
    // not by the bus.
    bool meets_where_activates_limit(const DramRequest& request,
                                     MemoryCycle now,
                                     MemoryCycle activate_at) const;
    // What the bank needs next for another row: an activate where none is open, else a precharge.
    MemoryCycle row_ready_at(std::uint32_t bank) const {
        const Bank& it = banks_[bank];
        const MemoryCycle opened = it.precharge_at;
        const MemoryCycle closed = std::max(it.activate_at, any_activate_at());
        const MemoryCycle is_closed = ~(MemoryCycle{it.row == NoRow} - 1); // all bits, or none
        return (closed & is_closed) | (opened & ~is_closed);
    }
    // Of the first banks what a scan over them asks.
    const BankTimes& bank_times() const { return times_; }
    MemoryCycle any_activate_at() const {
        return std::max({next_activate_, activates_[oldest_activate_], refreshed_at_});
    }
    MemoryCycle bus_ready_at(bool write) const { return bus_ready_[write]; }
    MemoryCycle column_ready_at(std::uint32_t bank, bool write) const {
        return std::max(banks_[bank].column_at, bus_ready_[write]);
    }
    // tRCD of its open row is over.
    bool takes_columns(std::uint32_t bank, MemoryCycle now) const {
        return banks_[bank].column_at <= now;
    }
    // That of all rows is, from then on.
    MemoryCycle all_take_columns_at() const { return all_take_columns_at_; }
    // The bus could have taken a column of that kind before.
    bool bus_stood(bool write, MemoryCycle now) const { return bus_ready_[write] < now; }
    // An activate finds its row's bank closed by `closed_at`, and goes out behind `others`: no
    // sooner than these allow.
    bool activate_waits_for(std::uint32_t others, MemoryCycle closed_at) const {
        const std::uint32_t spacing = std::max(config_.activate_to_activate_cycles, 1u);
        return closed_at <= next_activate_ + MemoryCycle{others} * spacing;
    }
    MemoryCycle precharge_cycles() const { return config_.precharge_cycles; }
    // The first cycle from `at` on in which none of the last request's columns goes out: one
    // command a cycle.
    MemoryCycle free_slot(MemoryCycle at) const;
    // All banks may be precharged, all may be refreshed.
    MemoryCycle all_precharge_ready() const;
    MemoryCycle refresh_ready() const;

    void activate(std::uint32_t bank, std::uint64_t row, MemoryCycle now);
    void precharge(std::uint32_t bank, MemoryCycle now);
    void precharge_all(MemoryCycle now);
    void refresh(MemoryCycle now);
    // All bursts of the request; their data lie side by side.
    DataBurst column(const DramRequest& request, MemoryCycle now);
    // The row closes by itself as soon as it may (the column command said so).
    void auto_precharge(std::uint32_t bank) { precharge(bank, banks_[bank].precharge_at); }

    // A request's data.
    struct DataOf {
        std::uint32_t bytes = 0, bursts = 0;
        MemoryCycle asked = 0, on_bus = 0; // cycles of what was asked for, and of whole bursts
    };
    // Kept of the last number of bytes: most requests are of one, and these are divisions.
    const DataOf& data_of(std::uint32_t bytes) {
        if (bytes != data_of_.bytes) {
            const std::uint32_t bursts = config_.bursts(bytes);
            data_of_ = {bytes,
                        bursts,
                        (bytes + config_.bytes_per_cycle - 1) / config_.bytes_per_cycle,
                        MemoryCycle{bursts} * config_.burst_cycles};
        }
        return data_of_;
    }

    MemoryCycle column_latency(bool write) const {
        return write ? config_.write_column_cycles : config_.column_cycles;
    }
    // The last column turned the bus: by how much tCCD held it longer than the turn itself.
    MemoryCycle spacing_beyond_turn() const {
        const MemoryCycle spacing = config_.column_spacing() - config_.burst_cycles;
        const MemoryCycle to_read = config_.write_column_cycles + config_.write_to_read_cycles;
        const MemoryCycle to_write = config_.column_cycles + config_.read_to_write_cycles -
                                     std::min(config_.write_column_cycles,
                                              config_.column_cycles + config_.read_to_write_cycles);
        return spacing - std::min(spacing, last_was_write_ ? to_write : to_read);
    }
    bool has_carried_data() const { return bus_free_ > 0; }
    bool last_was_write() const { return last_was_write_; }
    MemoryCycle last_column(std::uint32_t bank) const { return banks_[bank].last_column; }

private:
    struct Bank {
        std::uint64_t row = NoRow;
        MemoryCycle activate_at = 0, column_at = 0, precharge_at = 0; // not before
        MemoryCycle closed_at = 0; // where no row is open; not yet where it closes by itself
        MemoryCycle last_column = 0;
        LostTo opened_after = LostTo::Row; // what the activate waited for, and tRCD with it
    };

    // The bank has changed.
    void note_times(std::uint32_t bank);
    // `ready`, but not before the bus takes the column.
    Ready bus_ready(Ready ready, bool write) const;

    const MemoryConfig& config_;
    std::vector<Bank> banks_;
    DataOf data_of_;
    BankTimes times_;
    MemoryCycle refreshed_at_ = 0;           // end of the last refresh
    MemoryCycle next_activate_ = 0;          // tRRD
    MemoryCycle all_take_columns_at_ = 0;    // tRCD of the last activate
    std::array<MemoryCycle, 4> activates_{}; // the last four, + tFAW
    std::size_t oldest_activate_ = 0;
    MemoryCycle first_column_ = 1, last_column_ = 0; // of the last request
    MemoryCycle next_column_ = 0;                    // tCCD
    MemoryCycle bus_free_ = 0;
    bool last_was_write_ = false;
    std::array<MemoryCycle, 2> bus_ready_{}; // for the column of a read, of a write: of any bank
};

// The scheduler asks these of each request in each cycle.

inline Ready DramDevice::activate_ready(std::uint32_t bank) const {
    Ready ready{banks_[bank].activate_at, LostTo::Row};
    ready.not_before(next_activate_, LostTo::Activates);
    ready.not_before(activates_[oldest_activate_], LostTo::Activates);
    if (refreshed_at_ >= ready.at) ready = {refreshed_at_, LostTo::Refresh};
    return ready;
}

inline Ready DramDevice::precharge_ready(std::uint32_t bank) const {
    return {banks_[bank].precharge_at, LostTo::Row};
}

inline Ready DramDevice::column_ready(const DramRequest& request) const {
    const Bank& bank = banks_[request.bank];
    return bus_ready({bank.column_at, bank.opened_after}, request.write);
}

inline MemoryCycle DramDevice::free_slot(MemoryCycle at) const {
    if (at > last_column_ || at < first_column_) return at;
    const std::uint32_t spacing = config_.column_spacing();
    if (spacing == 1) return last_column_ + 1;
    return at + ((at - first_column_) % spacing == 0);
}

// Data follow the command by the column latency, so the bus is not held while they are on their
// way.
inline Ready DramDevice::bus_ready(Ready ready, bool write) const {
    ready.not_before(next_column_, LostTo::Column);
    const bool turns = write != last_was_write_;
    const LostTo waiting = turns ? LostTo::Turnaround : LostTo::Column;
    const MemoryCycle latency = column_latency(write);
    const MemoryCycle idle = turns && write ? config_.read_to_write_cycles : 0;
    if (bus_free_ > 0 && bus_free_ + idle > latency)
        ready.not_before(bus_free_ + idle - latency, waiting);
    if (turns && !write)
        ready.not_before(bus_free_ + (bus_free_ > 0 ? config_.write_to_read_cycles : 0), waiting);
    return ready;
}

} // namespace ffgpu::timing
