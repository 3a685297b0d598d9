#include "tools/report/heat_maps.h"

#include "model/base/input_error.h"
#include "tools/config/nearest_name.h"

#include <algorithm>
#include <sstream>

namespace ffgpu::tools {

std::set<HeatMap> parse_heat_maps(const std::string& names) {
    std::set<HeatMap> maps;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        const auto* const found = std::ranges::find(HeatMapTable, name, &HeatMapInfo::name);
        if (found == HeatMapTable.end()) {
            std::vector<std::string> known;
            known.reserve(HeatMapTable.size());
            for (const HeatMapInfo& map : HeatMapTable)
                known.emplace_back(map.name);
            throw InputError("--heatmap: unknown map " + name + "; did you mean " +
                             nearest_name(name, known) + "?");
        }
        maps.insert(static_cast<HeatMap>(found - HeatMapTable.begin()));
    }
    return maps;
}

std::array<std::uint8_t, 3> heat_color(double value) {
    using Color = std::array<double, 3>;
    static constexpr std::array<Color, 7> Ramp{{{0, 0, 0},
                                                {0, 0, 255},
                                                {0, 255, 255},
                                                {0, 255, 0},
                                                {255, 255, 0},
                                                {255, 0, 0},
                                                {255, 255, 255}}};
    const double at = std::clamp(value, 0.0, 1.0) * (Ramp.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), Ramp.size() - 2);
    const double share = at - static_cast<double>(low);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t c = 0; c < 3; ++c)
        color[c] =
            static_cast<std::uint8_t>(Ramp[low][c] * (1 - share) + Ramp[low + 1][c] * share + 0.5);
    return color;
}

void HeatMapRecorder::bin(std::shared_ptr<const WorkBin> bin) {
    for (const WorkTile& tile : bin->tiles) {
        for (const WorkBatch& batch : tile.batches) {
            const WorkDraw& draw = bin->draws[batch.draw];
            if (draw.kind == WorkKind::Draw || draw.kind == WorkKind::Image)
                add(plane_of(draw), batch);
        }
    }
}

HeatMapRecorder::Plane& HeatMapRecorder::plane_of(const WorkDraw& draw) {
    const Surface& target = draw.state->targets.color[0];
    Plane& plane = planes_[target.address];
    if (plane.width != target.width || plane.height != target.height) {
        plane.width = target.width;
        plane.height = target.height;
        plane.pixels.assign(std::size_t{plane.width} * plane.height, {});
    }
    return plane;
}

void HeatMapRecorder::add(Plane& plane, const WorkBatch& batch) {
    const auto pixel_of = [&](const WorkQuad& quad, unsigned lane) -> Pixel* {
        const std::uint32_t x = quad.x + (lane & 1), y = quad.y + (lane >> 1);
        if (x >= plane.width || y >= plane.height) return nullptr;
        return &plane.pixels[std::size_t{y} * plane.width + x];
    };
    for (const WorkQuad& quad : batch.quads)
        for (unsigned lane = 0; lane < 4; ++lane)
            if (Pixel* const pixel = pixel_of(quad, lane); pixel && quad.after_depth >> lane & 1)
                ++pixel->fragments;
    for (const TexelFootprints& unit : batch.textures) {
        for (const TexelAccess& access : unit.accesses) {
            const WorkQuad& quad = batch.quads[access.lane / 4u];
            if ((quad.after_early_depth >> access.lane % 4 & 1) == 0) continue; // hidden
            Pixel* const pixel = pixel_of(batch.quads[access.lane / 4], access.lane % 4);
            if (!pixel) continue;
            pixel->level_sum += access.level;
            ++pixel->level_count;
        }
    }
}

void HeatMapRecorder::quad_retired(const timing::QuadRetired& quad) {
    QuadCost& cost = costs_[static_cast<std::uint32_t>(quad.y) << 16 | quad.x];
    cost.misses += quad.texture_misses;
    cost.cycles += quad.cycles;
}

double
HeatMapRecorder::value(HeatMap map, const Plane& plane, std::uint32_t x, std::uint32_t y) const {
    const Pixel& pixel = plane.pixels[std::size_t{y} * plane.width + x];
    if (map == HeatMap::Overdraw) return pixel.fragments;
    if (map == HeatMap::Level)
        return pixel.level_count == 0 ? 0
                                      : 1 + static_cast<double>(pixel.level_sum) /
                                                static_cast<double>(pixel.level_count);
    const auto cost = costs_.find((y & ~1u) << 16 | (x & ~1u));
    if (cost == costs_.end()) return 0;
    return static_cast<double>(map == HeatMap::Cycles ? cost->second.cycles : cost->second.misses);
}

Image HeatMapRecorder::image(HeatMap map, const Surface& shown) const {
    Image image(shown.width, shown.height);
    const auto plane = planes_.find(shown.address);
    if (plane == planes_.end() || plane->second.width != shown.width ||
        plane->second.height != shown.height)
        return image; // Nothing was drawn.
    std::uint8_t* to = image.rgb.data();
    for (std::uint32_t row = 0; row < image.height; ++row) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const double number = value(map, plane->second, x, image.height - 1 - row);
            for (const std::uint8_t channel : heat_color(number / info(map).full_scale))
                *to++ = channel;
        }
    }
    return image;
}

void HeatMapRecorder::clear() {
    planes_.clear();
    costs_.clear();
}

} // namespace ffgpu::tools
