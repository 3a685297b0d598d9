#include "model/timing/memory_lines.h"

#include "model/base/input_error.h"

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

} // namespace ffgpu::timing
