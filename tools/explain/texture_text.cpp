// A texture unit's part of fragment_text.h.

#include "tools/explain/fragment_text.h"
#include "tools/explain/history_facts.h"
#include "tools/explain/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ffgpu::tools {
namespace {

std::string cache_text(const TexelLookup* lookup) {
    if (!lookup || !lookup->cycle) return "";
    return fmt::format(", {} in cycle {}", lookup->missed ? "miss" : "hit", *lookup->cycle);
}

std::string texel_text(const FragmentNote& fragment,
                       unsigned unit,
                       unsigned level,
                       const probed::Texel& texel) {
    if (texel.bytes == 0) return fmt::format("         border {}\n", color_text(texel.color));
    std::string bytes;
    for (unsigned i = 0; i < texel.bytes; ++i)
        bytes += fmt::format("{:02x}", std::to_integer<unsigned>(texel.stored[i]));
    return fmt::format("         level {} texel ({}, {}) of layer {}: stored {}, {}{}\n",
                       level,
                       texel.x,
                       texel.y,
                       texel.layer,
                       bytes,
                       color_text(texel.color),
                       cache_text(lookup_of(fragment, unit, level, texel)));
}

std::string
filter_text(const FragmentNote& fragment, unsigned unit, const probed::LevelFilter& filter) {
    std::string text = fmt::format("       level {}", filter.access.level);
    text += filter.along_x_count > 0
                ? fmt::format(", weights {}/256\n", fmt::join(filter.weight, "/256, "))
            : filter.texel_weights ? fmt::format(", weights of the texels {}\n",
                                                 fmt::join(*filter.texel_weights, ", "))
                                   : "\n";
    for (unsigned i = 0; i < filter.texel_count; ++i)
        text += texel_text(fragment, unit, filter.access.level, filter.texels[i]);
    if (filter.along_x_count == 0) return text;
    const auto lerps = [&](const char* axis, const auto& colors, unsigned count) {
        text += fmt::format("         along {}:", axis);
        for (unsigned i = 0; i < count; ++i)
            text += ' ' + color_text(colors[i]);
        text += '\n';
    };
    if (filter.access.linear & 1) lerps("x", filter.along_x, filter.texel_count / 2u);
    if (filter.access.linear & 2) lerps("y", filter.along_y, filter.access.linear & 4 ? 2u : 1u);
    return text + fmt::format("         -> {}\n", color_text(filter.color));
}

// Where the probes do not count alike, and where their levels are their own.
std::string weight_text(const TextureNote& texture, const probed::Probe& probe) {
    std::string text;
    for (const ProbeNote& other : texture.probes)
        if (other.probe.weight != probe.weight) text = fmt::format(", weight {}", probe.weight);
    if (texture.quad && texture.quad->weight != probe.next_level)
        text += fmt::format(", next level with weight {}/256", probe.next_level);
    return text;
}

std::string levels_text(const probed::QuadLevels& quad) {
    return fmt::format("     derivatives in x ({}), in y ({}), of s t r\n"
                       "     footprint: squared sides {} and {} texels; lambda {}; {} {}\n"
                       "     level {}, next {} with weight {}/256; {}\n",
                       fmt::join(quad.step_x, ", "),
                       fmt::join(quad.step_y, ", "),
                       quad.footprint_x,
                       quad.footprint_y,
                       quad.lambda / 256.0,
                       quad.probes,
                       quad.probes == 1 ? "probe" : "probes",
                       quad.level,
                       quad.next_level,
                       quad.weight,
                       quad.linear ? "linear" : "nearest");
}

} // namespace

std::string texture_text(const FragmentNote& fragment, const TextureNote& texture) {
    std::string text = fmt::format("   texture {}: ", texture.unit);
    if (texture.carried > 0)
        text += fmt::format(
            "over w {} -> ",
            fmt::join(texture.over_w.begin(), texture.over_w.begin() + texture.carried, ", "));
    text += fmt::format("s t r {}\n", fmt::join(texture.coordinates, ", "));
    if (texture.quad) text += levels_text(*texture.quad);
    const TextureFilter kind = fragment.registers().samplers[texture.unit].filter;
    if (kind != TextureFilter::Standard) text += fmt::format("     filter {}\n", name_of(kind));
    for (const ProbeNote& probe : texture.probes) {
        text += fmt::format("     probe {} at {}, face {}{}\n",
                            probe.probe.probe,
                            fmt::join(probe.probe.coordinates, ", "),
                            probe.probe.face,
                            weight_text(texture, probe.probe));
        for (const probed::LevelFilter& filter : probe.levels)
            text += filter_text(fragment, texture.unit, filter);
        if (probe.levels.size() > 1)
            text += fmt::format("       of {} {}\n",
                                probe.levels[0].along_x_count > 0 ? "both levels" : "all of it",
                                color_text(probe.probe.color));
    }
    return text + fmt::format("     sample {}\n", color_text(texture.color));
}

} // namespace ffgpu::tools
