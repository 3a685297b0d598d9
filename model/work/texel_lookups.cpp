#include "model/work/texel_lookups.h"

#include <algorithm>
#include <array>

namespace ffgpu::work {

TexelLookups::TexelLookups(const WholeCommand& command, const WorkConfig& config)
    : command_(command)
    , lines_(config.texel_cache.line_bytes,
             config.raster.granularity == Granularity::Quad && config.merges_texel_reads) {}

void TexelLookups::add(std::uint32_t number,
                       std::uint8_t lanes,
                       PreparedQuad& quad,
                       PreparedQuads& out) {
    quad.texel_lines_begin = static_cast<std::uint32_t>(out.texel_lines.size());
    quad.texture_parts_begin = static_cast<std::uint32_t>(out.texture_parts.size());
    quad.texture_count = static_cast<std::uint8_t>(command_.units.size());
    lines_.begin_quad();
    for (std::size_t i = 0; i < command_.units.size(); ++i) {
        const TextureLines* const texture = textures_[command_.units[i]].get();
        const std::size_t first_line = lines_.lines().size();
        std::array<unsigned, 4> samples{}; // a lane
        command_.accesses_of(number, i).for_each(lanes, [&](const auto& access) {
            samples[access[0] & 3] += (access[0] >> 24 & 4) ? 2 : 1; // by TexelAccess::linear
            if (texture) lines_.add(*texture, access);
        });
        const unsigned steps = *std::max_element(samples.begin(), samples.end());
        out.texture_parts.push_back(
            {.lines = static_cast<std::uint16_t>(lines_.lines().size() - first_line),
             .filter_steps = static_cast<std::uint16_t>(steps)});
        quad.filter_steps = static_cast<std::uint16_t>(quad.filter_steps + steps);
    }
    for (const std::uint64_t line : lines_.lines()) // so few that no copy pays
        out.texel_lines.push_back(line);
    quad.texel_line_count = static_cast<std::uint16_t>(lines_.lines().size());
    quad.texel_reads = static_cast<std::uint16_t>(lines_.reads());
    quad.border_texels = static_cast<std::uint16_t>(lines_.border_reads());
    quad.expands_blocks = lines_.expands_blocks();
}

} // namespace ffgpu::work
