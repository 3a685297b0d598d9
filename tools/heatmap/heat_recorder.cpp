#include "tools/heatmap/heat_recorder.h"

#include <algorithm>
#include <bit>

namespace ffgpu::tools {
namespace {

double mean(std::uint32_t sum, std::uint32_t count) {
    return count == 0 ? 0 : static_cast<double>(sum) / count;
}

} // namespace

void HeatRecorder::bin(std::shared_ptr<const WorkBin> bin) {
    // In the order of the draws: a tile's would tell of the host's tiles.
    std::vector<std::uint32_t> textures;
    textures.reserve(bin->draws.size());
    for (const WorkDraw& draw : bin->draws)
        textures.push_back(texture_number(draw));
    for (const WorkTile& tile : bin->tiles) {
        for (const WorkBatch& batch : tile.batches) {
            const WorkDraw& draw = bin->draws[batch.draw];
            if (draw.kind != WorkKind::Draw && draw.kind != WorkKind::Image) continue;
            Target& target = target_of(draw);
            for (const WorkQuad& quad : batch.quads)
                add_quad(target, quad);
            add_accesses(target, batch, textures[batch.draw]);
        }
    }
}

// From 1, in the order of their first use; that of the lowest unit; 0: the draw has none.
std::uint32_t HeatRecorder::texture_number(const WorkDraw& draw) {
    if (draw.kind != WorkKind::Draw && draw.kind != WorkKind::Image) return 0;
    for (const TextureImage& image : draw.state->images)
        if (image.shape.kind != TextureKind::None)
            return textures_
                .try_emplace(image.address, static_cast<std::uint32_t>(textures_.size() + 1))
                .first->second;
    return 0;
}

HeatRecorder::Target& HeatRecorder::target_of(const WorkDraw& draw) {
    const Surface& surface = draw.state->targets.color[0];
    Target& target = targets_[surface.address];
    if (target.width != surface.width || target.height != surface.height) {
        target.width = surface.width;
        target.height = surface.height;
        target.pixels.assign(std::size_t{target.width} * target.height, {});
    }
    return target;
}

HeatRecorder::Pixel* HeatRecorder::Target::at(const WorkQuad& quad, unsigned lane) {
    const std::uint32_t x = quad.x + (lane & 1), y = quad.y + (lane >> 1);
    return x < width && y < height ? &pixels[std::size_t{y} * width + x] : nullptr;
}

void HeatRecorder::add_quad(Target& target, const WorkQuad& quad) {
    const auto has = [](unsigned mask, unsigned lane) { return mask >> lane & 1; };
    const unsigned depth_killed = static_cast<unsigned>(quad.covered & ~quad.after_early_depth) |
                                  static_cast<unsigned>(quad.after_stencil & ~quad.after_depth);
    for (unsigned lane = 0; lane < 4; ++lane) {
        Pixel* const pixel = target.at(quad, lane);
        if (!pixel) continue;
        ++pixel->quads;
        pixel->quad_lanes += static_cast<std::uint32_t>(std::popcount(quad.covered));
        pixel->covered += has(quad.covered, lane);
        pixel->written += has(quad.after_depth, lane);
        pixel->depth_killed += has(depth_killed, lane);
        pixel->alpha_killed += has(quad.after_coverage & ~quad.after_alpha, lane);
        pixel->stencil_killed += has(quad.after_alpha & ~quad.after_stencil, lane);
    }
}

void HeatRecorder::add_accesses(Target& target, const WorkBatch& batch, std::uint32_t texture) {
    for (const TexelFootprints& unit : batch.textures)
        for (std::uint32_t number = 0; number < batch.quads.size(); ++number)
            for (const TexelAccess& access : unit.of_quad(number)) {
                const WorkQuad& quad = batch.quads[number];
                if ((quad.after_early_depth >> access.lane & 1) == 0) continue; // hidden
                Pixel* const pixel = target.at(quad, access.lane);
                if (!pixel) continue;
                pixel->level_sum += access.level;
                ++pixel->level_count;
                pixel->texture = texture;
            }
}

void HeatRecorder::quad_retired(const timing::QuadRetired& quad) {
    QuadCost& cost = costs_[static_cast<std::uint32_t>(quad.y) << 16 | quad.x];
    cost.misses += quad.texture_misses;
    cost.cycles += quad.cycles;
    if (quad.cycles > 0)
        ends_.push_back({static_cast<std::uint32_t>(quad.y) << 16 | quad.x, quad.cycles, quad.end});
}

// Both are in the order of time.
void HeatRecorder::frame_waited(std::span<const timing::WaitPaths::Run> waited) {
    auto run = waited.begin();
    for (const QuadEnd& quad : ends_) {
        timing::WaitedCycles& of = costs_[quad.place].waited;
        for (std::uint64_t at = quad.end - quad.cycles; at < quad.end;) {
            while (run != waited.end() && run->end <= at)
                ++run;
            if (run == waited.end()) break;
            const std::uint64_t end = std::min(run->end, quad.end);
            of[static_cast<std::size_t>(run->resource)] += end - at;
            at = end;
        }
    }
    ends_.clear();
}

double HeatRecorder::value(HeatMap map, const Pixel& pixel) const {
    switch (map) {
    case HeatMap::Covered:
        return pixel.covered;
    case HeatMap::DepthKilled:
        return pixel.depth_killed;
    case HeatMap::StencilKilled:
        return pixel.stencil_killed;
    case HeatMap::AlphaKilled:
        return pixel.alpha_killed;
    case HeatMap::QuadLanes:
        return mean(pixel.quad_lanes, pixel.quads);
    case HeatMap::Level:
        return pixel.level_count == 0 ? 0 : 1 + mean(pixel.level_sum, pixel.level_count);
    case HeatMap::Texture:
        return pixel.texture;
    default:
        return pixel.written;
    }
}

double HeatRecorder::cost(HeatMap map, std::uint32_t x, std::uint32_t y) const {
    const auto found = costs_.find((y & ~1u) << 16 | (x & ~1u));
    if (found == costs_.end()) return 0;
    if (map == HeatMap::StallCause) return cause(found->second.waited);
    return static_cast<double>(map == HeatMap::Cycles ? found->second.cycles
                                                      : found->second.misses);
}

// From 1, in the order of their names; of two the first; 0: nothing was waited for.
double HeatRecorder::cause(const timing::WaitedCycles& waited) {
    const auto most = std::max_element(waited.begin(), waited.end());
    return *most == 0 ? 0 : static_cast<double>(most - waited.begin() + 1);
}

HeatPlane HeatRecorder::plane(HeatMap map, const Surface& shown) const {
    HeatPlane plane{shown.width, shown.height, {}};
    plane.values.resize(std::size_t{plane.width} * plane.height);
    const auto found = targets_.find(shown.address);
    if (found == targets_.end() || found->second.width != shown.width ||
        found->second.height != shown.height)
        return plane; // Nothing was drawn.
    auto to = plane.values.begin();
    for (std::uint32_t row = 0; row < plane.height; ++row) {
        const std::uint32_t y = plane.height - 1 - row;
        for (std::uint32_t x = 0; x < plane.width; ++x)
            *to++ = static_cast<float>(
                info(map).needs_timing
                    ? cost(map, x, y)
                    : value(map, found->second.pixels[std::size_t{y} * plane.width + x]));
    }
    return plane;
}

void HeatRecorder::clear() {
    targets_.clear();
    costs_.clear();
    ends_.clear();
}

} // namespace ffgpu::tools
