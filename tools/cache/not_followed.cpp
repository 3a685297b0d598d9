#include "tools/cache/not_followed.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using work::LookupClient;

bool has(std::span<const LookupClient> clients, LookupClient client) {
    return std::find(clients.begin(), clients.end(), client) != clients.end();
}

std::string cache_of(LookupClient client) {
    return fmt::format("{}_cache", work::LookupClientNames[static_cast<std::size_t>(client)]);
}

} // namespace

std::vector<std::string> not_followed_by_lookups(const timing::TimingConfig& timing,
                                                 std::span<const LookupClient> clients) {
    std::vector<std::string> lines;
    const bool texel = has(clients, LookupClient::Texel);
    if (texel && timing.texel_cache.per_pipe && timing.raster.quads_per_cycle > 1)
        lines.emplace_back("texel_cache.per_pipe: not followed: look-ups are of one cache that all "
                           "pipes share");
    else if (texel && timing.raster.quads_per_cycle > 1)
        lines.emplace_back("raster.quads_per_cycle: not followed: look-ups come in the order of "
                           "one pipe");
    if (texel && timing.texel_cache.forgets)
        lines.emplace_back("texel_cache.forgets: not followed: the cache keeps its lines from draw "
                           "to draw");
    if (timing.hierarchical_depth.is_on() && (texel || has(clients, LookupClient::Depth)))
        lines.emplace_back("hierarchical_depth.keeps: not followed: quads that the coarse depths "
                           "decide are looked up like others");
    if (has(clients, LookupClient::Vertex) && timing.vertex.index_cache_lines == 0)
        lines.emplace_back("vertex.index_cache_lines=0: not followed: look-ups are of vertices "
                           "alone, as if indices had a cache of their own");
    const auto warn_if_off = [&](LookupClient client, const timing::CacheConfig& cache) {
        if (has(clients, client) && !cache.enable)
            lines.push_back(cache_of(client) + ".enable=false: not followed: look-ups are of a "
                                               "machine that has the cache");
    };
    if (timing.raster.architecture == work::Architecture::Immediate) {
        warn_if_off(LookupClient::Depth, timing.depth_cache);
        warn_if_off(LookupClient::Color, timing.color_cache);
    } else {
        for (const LookupClient client : {LookupClient::Depth, LookupClient::Color})
            if (has(clients, client))
                lines.push_back(cache_of(client) +
                                ": raster.architecture=tile_based has none: what it would hold "
                                "lies on chip, and nobody looks it up");
    }
    return lines;
}

std::vector<std::string> not_followed_by_curves(const timing::TimingConfig& timing,
                                                std::span<const LookupClient> clients) {
    std::vector<std::string> lines;
    const auto warn_of = [&](LookupClient client, const work::CachePolicy& policy) {
        if (!has(clients, client)) return;
        if (policy.index_hash != work::IndexHash::Modulo)
            lines.push_back(cache_of(client) + ".index_hash: not followed: in all curves a line's "
                                               "set is the lowest bits of its number");
        if (policy.replacement != work::Replacement::Lru)
            lines.push_back(cache_of(client) + ".replacement: not followed: in all curves the line "
                                               "that was used least recently gives way");
    };
    warn_of(LookupClient::Texel, timing.texel_cache);
    warn_of(LookupClient::Depth, timing.depth_cache);
    warn_of(LookupClient::Color, timing.color_cache);
    for (std::string& line : not_followed_by_lookups(timing, clients))
        lines.push_back(std::move(line));
    return lines;
}

} // namespace ffgpu::tools
