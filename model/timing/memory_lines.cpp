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

} // namespace

void check_memory_lines(const TimingConfig& config) {
    const auto check_cache = [&](std::string_view name, std::uint32_t bytes) {
        check_line(config.memory, std::string(name) + ".line_bytes", bytes);
    };
    check_cache(VertexConfig::Name, config.vertex.line_bytes);
    check_line(config.memory, "host.burst_bytes", config.host.burst_bytes);
    check_line(config.memory, "scan_out.line_bytes", config.scan_out.line_bytes);
    check_cache(TexelCacheConfig::Name, config.texel_cache.line_bytes);
    if (config.texel_l2.enable) check_cache(TexelL2Config::Name, config.texel_l2.line_bytes);
    check_cache(DepthCacheConfig::Name, config.depth_cache.line_bytes);
    check_cache(ColorCacheConfig::Name, config.color_cache.line_bytes);
}

void check_refresh(const MemoryConfig& config) {
    const std::uint32_t interval = config.refresh_interval_cycles;
    const std::uint32_t read = config.read_to_precharge_cycles;
    const std::uint32_t write =
        config.write_column_cycles + config.burst_cycles + config.write_recovery_cycles;
    const std::uint32_t row =
        std::max(config.row_active_cycles, config.row_to_column_cycles + std::max(read, write));
    const std::uint32_t commands = 4; // refresh, activate, column, precharge: a cycle each
    const std::uint32_t least = config.refresh_cycles + row + config.precharge_cycles + commands;
    if (interval == 0 || interval >= least) return;
    throw InputError("memory.refresh_interval_cycles: expected 0 or at least " +
                     std::to_string(least) + ", what a refresh and a row take, found " +
                     std::to_string(interval));
}

} // namespace ffgpu::timing
