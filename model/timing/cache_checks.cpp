#include "model/timing/cache_checks.h"

#include "model/base/input_error.h"

#include <string>

namespace ffgpu::timing {
namespace {

void check_written(std::string_view name, const work::CachePolicy& policy) {
    if (policy.replacement == work::Replacement::Optimal)
        throw InputError(std::string(name) + ".replacement: optimal replacement is of caches that "
                                             "are only read (texel_cache, texel_l2)");
}

// The model keeps some hundred bytes for each line, so that it has to be a number that fits.
constexpr std::uint64_t MostLines = std::uint64_t{1} << 22;

void check_lines(std::string_view name, std::uint64_t sets, std::uint64_t ways) {
    if (sets * ways > MostLines)
        throw InputError(std::string(name) + ".sets x ways: expected at most " +
                         std::to_string(MostLines) + " lines, found " +
                         std::to_string(sets * ways));
}

} // namespace

void check_caches(const TimingConfig& config) {
    check_written(DepthCacheConfig::Name, config.depth_cache);
    check_written(ColorCacheConfig::Name, config.color_cache);
    check_lines(TexelCacheConfig::Name, config.texel_cache.sets, config.texel_cache.ways);
    if (config.texel_l2.enable)
        check_lines(TexelL2Config::Name, config.texel_l2.sets, config.texel_l2.ways);
    check_lines(DepthCacheConfig::Name, config.depth_cache.sets, config.depth_cache.ways);
    check_lines(ColorCacheConfig::Name, config.color_cache.sets, config.color_cache.ways);
    if (config.texel_cache.layout == work::Layout::Blocked6d &&
        config.texel_cache.superblock_width < config.texel_cache.block_width)
        throw InputError(
            "texel_cache.superblock_width: expected at least texel_cache.block_width (" +
            std::to_string(config.texel_cache.block_width) + "), found " +
            std::to_string(config.texel_cache.superblock_width));
    if (config.texel_l2.enable && config.texel_l2.line_bytes < config.texel_cache.line_bytes)
        throw InputError("texel_l2.line_bytes: expected at least texel_cache.line_bytes (" +
                         std::to_string(config.texel_cache.line_bytes) + "), found " +
                         std::to_string(config.texel_l2.line_bytes));
}

} // namespace ffgpu::timing
