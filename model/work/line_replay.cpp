#include "model/work/line_replay.h"

#include "model/work/tag_array.h"

#include <unordered_map>

namespace ffgpu::work {

std::vector<std::uint64_t> next_uses(std::span<const std::uint64_t> lines) {
    std::vector<std::uint64_t> next(lines.size(), NeverUsedAgain);
    std::unordered_map<std::uint64_t, std::size_t> last;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto [entry, is_new] = last.try_emplace(lines[i], i);
        if (is_new) continue;
        next[entry->second] = i;
        entry->second = i;
    }
    return next;
}

std::uint64_t count_misses(std::span<const std::uint64_t> lines,
                           std::uint32_t sets,
                           std::uint32_t ways,
                           const CachePolicy& policy) {
    std::vector<std::uint64_t> future;
    if (policy.replacement == Replacement::Optimal) future = next_uses(lines);
    TagArray tags(sets, ways, policy);
    std::uint64_t misses = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::uint64_t next = future.empty() ? NeverUsedAgain : future[i];
        if (const TagArray::Line* line = tags.find(lines[i])) {
            tags.use(*line, next);
            continue;
        }
        TagArray::Evicted evicted;
        tags.replace(lines[i], evicted, next);
        ++misses;
    }
    return misses;
}

} // namespace ffgpu::work
