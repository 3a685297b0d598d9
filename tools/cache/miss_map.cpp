#include "tools/cache/miss_map.h"

#include <algorithm>
#include <array>

namespace ffgpu::tools {
namespace {

work::WorkConfig with_lines(work::WorkConfig config, std::uint32_t line_bytes) {
    config.texel_cache.line_bytes = line_bytes;
    return config;
}

constexpr std::array<std::array<std::uint8_t, 3>, 4> Colors{
    {{0, 0, 0}, {40, 80, 255}, {0, 200, 80}, {255, 40, 40}}};

} // namespace

MissMap::MissMap(const work::WorkConfig& config, const CacheGeometry& shape)
    : tags_(shape.sets, shape.ways)
    , walk_(config, {}, *this)
    , order_(with_lines(config, shape.line_bytes), walk_) {}

void MissMap::lookups(work::LookupClient client,
                      const work::LookupPlace& place,
                      std::span<const work::LineLookup> lines,
                      std::uint32_t) {
    if (client != work::LookupClient::Texel) return;
    const std::size_t at = place.y / 2 * Columns + place.x / 2;
    if (at >= misses_.size()) misses_.resize((place.y / 2 + 1) * Columns, 0);
    for (const work::LineLookup& lookup : lines) {
        if (const work::TagArray::Line* const line = tags_.find(lookup.line)) {
            tags_.use(*line);
            continue;
        }
        work::TagArray::Evicted evicted;
        tags_.replace(lookup.line, evicted);
        ++misses_[at];
    }
}

void MissMap::flush(work::LookupClient client) {
    if (client != work::LookupClient::Texel) return;
    tags_.for_each([&](std::uint64_t, work::TagArray::Line& line) { tags_.drop(line); });
}

void MissMap::overwritten(work::LookupClient client, std::span<const work::OverwrittenLine> lines) {
    if (client != work::LookupClient::Texel) return;
    for (const work::OverwrittenLine& overwritten : lines)
        if (work::TagArray::Line* const line = tags_.find(overwritten.line)) tags_.drop(*line);
}

void MissMap::end_frame(std::uint32_t) {
    shown_.swap(misses_);
    misses_.assign(shown_.size(), 0);
}

Image MissMap::picture(unsigned width, unsigned height) const {
    Image image(width, height);
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x) {
            const std::size_t at = (height - 1 - y) / 2 * Columns + x / 2;
            const std::uint32_t misses = at < shown_.size() ? shown_[at] : 0;
            const auto& color = Colors[std::min<std::size_t>(misses, Colors.size() - 1)];
            std::copy(color.begin(), color.end(), &image.rgb[3 * (std::size_t{y} * width + x)]);
        }
    return image;
}

} // namespace ffgpu::tools
