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

} // namespace

void check_caches(const TimingConfig& config) {
    check_written(DepthCacheConfig::Name, config.depth_cache);
    check_written(ColorCacheConfig::Name, config.color_cache);
    if (config.texel_l2.enable && config.texel_l2.line_bytes < config.texel_cache.line_bytes)
        throw InputError("texel_l2.line_bytes: expected at least texel_cache.line_bytes (" +
                         std::to_string(config.texel_cache.line_bytes) + "), found " +
                         std::to_string(config.texel_l2.line_bytes));
}

} // namespace ffgpu::timing
