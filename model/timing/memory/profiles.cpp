// The kinds of DRAM. docs/units/memory.md names the source of each number.

#include "model/timing/memory/config.h"

namespace ffgpu::timing {
namespace {

// A bus and nothing else: no latency, no refresh, and so many rows open that opening them takes
// next to no commands.
void make_ideal(MemoryConfig& config) {
    config.banks = 64;
    config.row_bytes = 65536;
    config.burst_cycles = config.column_to_column_cycles = 1;
    config.row_to_column_cycles = config.column_cycles = config.write_column_cycles = 0;
    config.precharge_cycles = config.row_active_cycles = 0;
    config.activate_to_activate_cycles = config.four_activates_cycles = 0;
    config.read_to_precharge_cycles = config.write_recovery_cycles = 0;
    config.write_to_read_cycles = config.read_to_write_cycles = 0;
    config.refresh_interval_cycles = config.refresh_cycles = 0;
}

// Single data rate at 133 MHz, bursts of four.
void make_sdr(MemoryConfig& config) {
    config.banks = 4;
    config.row_bytes = 2048;
    config.burst_cycles = config.column_to_column_cycles = 4;
    config.row_to_column_cycles = 3;
    config.column_cycles = 3;
    config.write_column_cycles = 0;
    config.precharge_cycles = 3;
    config.row_active_cycles = 6;
    config.activate_to_activate_cycles = 2;
    config.four_activates_cycles = 0;
    config.read_to_precharge_cycles = 4;
    config.write_recovery_cycles = 2;
    config.write_to_read_cycles = 0;
    config.read_to_write_cycles = 1;
    config.refresh_interval_cycles = 2083;
    config.refresh_cycles = 9;
}

// Graphics memory of 2004 and after, at 500 MHz, bursts of four.
void make_gddr3(MemoryConfig& config) {
    config.banks = 8;
    config.row_bytes = 2048;
    config.burst_cycles = config.column_to_column_cycles = 2;
    config.row_to_column_cycles = 8;
    config.column_cycles = 7;
    config.write_column_cycles = 4;
    config.precharge_cycles = 9;
    config.row_active_cycles = 14;
    config.activate_to_activate_cycles = 5;
    config.four_activates_cycles = 0;
    config.read_to_precharge_cycles = 2;
    config.write_recovery_cycles = 6;
    config.write_to_read_cycles = 4;
    config.read_to_write_cycles = 2;
    config.refresh_interval_cycles = 1950;
    config.refresh_cycles = 27;
}

// The defaults: graphics memory at 200 MHz with data on both edges, bursts of four.
void make_ddr(MemoryConfig& config) {
    const MemoryConfig ddr;
    config.banks = ddr.banks;
    config.row_bytes = ddr.row_bytes;
    config.burst_cycles = ddr.burst_cycles;
    config.column_to_column_cycles = ddr.column_to_column_cycles;
    config.row_to_column_cycles = ddr.row_to_column_cycles;
    config.column_cycles = ddr.column_cycles;
    config.write_column_cycles = ddr.write_column_cycles;
    config.precharge_cycles = ddr.precharge_cycles;
    config.row_active_cycles = ddr.row_active_cycles;
    config.activate_to_activate_cycles = ddr.activate_to_activate_cycles;
    config.four_activates_cycles = ddr.four_activates_cycles;
    config.read_to_precharge_cycles = ddr.read_to_precharge_cycles;
    config.write_recovery_cycles = ddr.write_recovery_cycles;
    config.write_to_read_cycles = ddr.write_to_read_cycles;
    config.read_to_write_cycles = ddr.read_to_write_cycles;
    config.refresh_interval_cycles = ddr.refresh_interval_cycles;
    config.refresh_cycles = ddr.refresh_cycles;
}

} // namespace

void MemoryConfig::apply_profile() {
    switch (profile) {
    case MemoryProfile::Ideal:
        return make_ideal(*this);
    case MemoryProfile::Sdr:
        return make_sdr(*this);
    case MemoryProfile::Ddr:
        return make_ddr(*this);
    case MemoryProfile::Gddr3:
        return make_gddr3(*this);
    }
}

} // namespace ffgpu::timing
