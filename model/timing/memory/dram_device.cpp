#include "model/timing/memory/dram_device.h"

#include <algorithm>

namespace ffgpu::timing {

DramDevice::DramDevice(const MemoryConfig& config)
    : config_(config)
    , banks_(config.banks) {}

bool DramDevice::any_row_open() const {
    return std::ranges::any_of(banks_, [](const Bank& bank) { return bank.row != NoRow; });
}

MemoryCycle DramDevice::all_precharge_ready() const {
    MemoryCycle at = 0;
    for (const Bank& bank : banks_)
        at = std::max(at, bank.row != NoRow ? bank.precharge_at : bank.closed_at);
    return at;
}

MemoryCycle DramDevice::refresh_ready() const {
    MemoryCycle at = refreshed_at_;
    for (const Bank& bank : banks_)
        at = std::max(at, bank.activate_at);
    return at;
}

bool DramDevice::meets_where_activates_limit(const DramRequest& request,
                                             MemoryCycle now,
                                             MemoryCycle activate_at) const {
    const MemoryCycle spacing = config_.column_spacing();
    const MemoryCycle columns = spacing * config_.bursts(request.bytes);
    if (activate_at <= now || activate_at >= now + columns || spacing == 1) return false;
    const MemoryCycle four_activates =
        std::max(4 * config_.activate_to_activate_cycles, config_.four_activates_cycles);
    return (activate_at - now) % spacing == 0 && 4 * columns < four_activates;
}

void DramDevice::note_times(std::uint32_t bank) {
    if (bank >= BankTimes::Most) return;
    const Bank& it = banks_[bank];
    times_.column_at[bank] = it.column_at;
    times_.row_at[bank] = it.row == NoRow ? it.activate_at : it.precharge_at;
    times_.closed[bank] = it.row == NoRow ? ~MemoryCycle{0} : 0;
}

void DramDevice::activate(std::uint32_t bank, std::uint64_t row, MemoryCycle now) {
    Bank& it = banks_[bank];
    const Ready ready = activate_ready(bank);
    it.opened_after = ready.at == now ? ready.cause : LostTo::Row;
    it.row = row;
    it.column_at = all_take_columns_at_ = now + config_.row_to_column_cycles;
    it.precharge_at = now + config_.row_active_cycles;
    it.last_column = now;
    note_times(bank);
    next_activate_ = now + config_.activate_to_activate_cycles;
    activates_[oldest_activate_] = now + config_.four_activates_cycles;
    oldest_activate_ = (oldest_activate_ + 1) % activates_.size();
}

void DramDevice::precharge(std::uint32_t bank, MemoryCycle now) {
    banks_[bank].row = NoRow;
    banks_[bank].closed_at = now;
    banks_[bank].activate_at = now + config_.precharge_cycles;
    note_times(bank);
}

void DramDevice::precharge_all(MemoryCycle now) {
    for (std::uint32_t bank = 0; bank < banks_.size(); ++bank) {
        if (banks_[bank].row != NoRow) precharge(bank, now);
    }
}

void DramDevice::refresh(MemoryCycle now) {
    refreshed_at_ = now + config_.refresh_cycles;
}

DataBurst DramDevice::column(const DramRequest& request, MemoryCycle now) {
    const std::uint32_t spacing = config_.column_spacing();
    const std::uint32_t bursts = data_of(request.bytes).bursts;
    const MemoryCycle last = now + MemoryCycle{bursts - 1} * spacing;
    const MemoryCycle latency = column_latency(request.write);
    const DataBurst data{now + latency, last + latency + config_.burst_cycles};
    Bank& bank = banks_[request.bank];
    bank.last_column = last;
    bank.precharge_at = std::max(bank.precharge_at,
                                 request.write ? data.end + config_.write_recovery_cycles
                                               : last + config_.read_to_precharge_cycles);
    if (request.bank < BankTimes::Most) times_.row_at[request.bank] = bank.precharge_at;
    first_column_ = now;
    last_column_ = last;
    next_column_ = last + spacing;
    bus_free_ = data.end;
    last_was_write_ = request.write;
    // What bus_ready() says: of the same kind, whose data never come too early, and of the other.
    bus_ready_[request.write] = next_column_;
    const MemoryCycle write_data = data.end + config_.read_to_write_cycles;
    const MemoryCycle write_at = write_data - std::min(write_data, column_latency(true));
    const MemoryCycle read_at = data.end + config_.write_to_read_cycles;
    bus_ready_[!request.write] = std::max(next_column_, request.write ? read_at : write_at);
    return data;
}

} // namespace ffgpu::timing
