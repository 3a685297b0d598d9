#include "model/timing/memory_lines.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <string>

namespace ffgpu::timing {
namespace {

void check_line(const MemoryConfig& memory, const std::string& parameter, std::uint32_t bytes) {
    const auto refuse = [&](const std::string& limit, std::uint32_t most) {
        throw InputError(parameter + ": expected at most " + limit + " (" + std::to_string(most) +
                         "), found " + std::to_string(bytes));
    };
    if (memory.channels > 1 && bytes > memory.interleave_bytes)
        refuse("memory.interleave_bytes", memory.interleave_bytes);
    if (bytes > memory.row_bytes) refuse("memory.row_bytes", memory.row_bytes);
}

// Calls line(parameter, bytes) for each that is one request.
template <class Line>
void for_lines(const TimingConfig& config, Line&& line) {
    const auto cache = [&](std::string_view name, std::uint32_t bytes) {
        line(std::string(name) + ".line_bytes", bytes);
    };
    cache(VertexConfig::Name, config.vertex.line_bytes);
    line("host.burst_bytes", config.host.burst_bytes);
    line("scan_out.line_bytes", config.scan_out.line_bytes);
    cache(TexelCacheConfig::Name, config.texel_cache.line_bytes);
    if (config.texel_l2.enable) cache(TexelL2Config::Name, config.texel_l2.line_bytes);
    cache(DepthCacheConfig::Name, config.depth_cache.line_bytes);
    cache(ColorCacheConfig::Name, config.color_cache.line_bytes);
}

} // namespace

void check_memory_lines(const TimingConfig& config) {
    for_lines(config, [&](const std::string& parameter, std::uint32_t bytes) {
        check_line(config.memory, parameter, bytes);
    });
}

// A refresh may be due in the cycle after a row was opened. That row has to be closed, then comes
// the refresh, and before the next one is due a row must be opened and a request served from it.
void check_refresh(const TimingConfig& config) {
    const MemoryConfig& memory = config.memory;
    const std::uint32_t interval = memory.refresh_interval_cycles;
    if (interval == 0) return;
    std::uint32_t bytes = 0;
    for_lines(config,
              [&](const std::string&, std::uint32_t line) { bytes = std::max(bytes, line); });
    const std::uint32_t columns = memory.column_spacing() * memory.bursts(bytes);
    const std::uint32_t latency = std::max(memory.column_cycles, memory.write_column_cycles);
    const std::uint32_t data = columns + latency + memory.burst_cycles;
    const std::uint32_t row =
        std::max(memory.row_active_cycles,
                 memory.row_to_column_cycles + std::max(columns + memory.read_to_precharge_cycles,
                                                        data + memory.write_recovery_cycles));
    const std::uint32_t turn = std::max(memory.write_to_read_cycles, memory.read_to_write_cycles);
    const std::uint32_t open =
        std::max(memory.activate_to_activate_cycles, memory.four_activates_cycles) +
        memory.row_to_column_cycles + turn + data;
    const std::uint32_t commands = 4; // precharge, refresh, activate, column: a cycle each
    const std::uint32_t least =
        row + memory.precharge_cycles + memory.refresh_cycles + open + commands;
    if (interval >= least) return;
    throw InputError(
        "memory.refresh_interval_cycles: expected 0 or at least " + std::to_string(least) +
        ", what a row, a refresh and another row take, found " + std::to_string(interval));
}

} // namespace ffgpu::timing
