// Optimal replacement on recorded traces, through the machine: no other policy misses less often in
// any of the texel caches.

#include "tests/system/trace_run.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

Counters timed(const std::string& trace, const timing::TimingConfig& config) {
    RunOptions options;
    options.timing = config;
    options.last_frame = 1;
    return run_trace(trace, options).timed;
}

TEST_CASE("Optimal replacement misses no more than others in any texel cache of a real trace") {
    for (const char* const name : {"corridor", "light_maps", "chrome"}) {
        timing::TimingConfig config;
        config.raster.quads_per_cycle = 4;
        config.texel_cache.per_pipe = true;
        config.texel_cache.sets = 4;
        config.texel_cache.replacement = work::Replacement::Optimal;
        const Counters best = timed(own_trace(name), config);
        for (const work::Replacement other :
             {work::Replacement::Lru, work::Replacement::Fifo, work::Replacement::Random}) {
            config.texel_cache.replacement = other;
            const Counters figures = timed(own_trace(name), config);
            INFO(name);
            CHECK(best.at("texel_cache_accesses") == figures.at("texel_cache_accesses"));
            CHECK(best.at("texel_cache_misses") < figures.at("texel_cache_misses"));
            for (const std::string cache :
                 {"texel_cache_0", "texel_cache_1", "texel_cache_2", "texel_cache_3"})
                CHECK(best.at(cache + "_misses") <= figures.at(cache + "_misses"));
        }
    }
}

} // namespace
} // namespace ffgpu::tools
