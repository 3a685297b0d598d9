#include "model/work/texel_lookups.h"

#include <algorithm>
#include <array>

namespace ffgpu::work {
namespace {

// 2x2 texels of one layer, none of them the border colour's, as they lie in memory.
bool is_plain_square(const PlacedLevel& level, const TexelAccess& access) {
    constexpr std::uint16_t Border = TexelAccess::BorderTexel;
    return access.linear == 3 && level.expansion_log2 == 0 && access.x0 != Border &&
           access.x1 != Border && access.y0 != Border && access.y1 != Border &&
           access.layer0 != Border;
}

} // namespace

TexelLookups::TexelLookups(const WholeCommand& command,
                           const WorkConfig& config,
                           PreparedScene& out)
    : command_(command)
    , line_bytes_(config.texel_cache.line_bytes)
    , merges_(config.raster.granularity == Granularity::Quad && config.merges_texel_reads)
    , out_(out) {}

void TexelLookups::place(unsigned unit, const std::vector<PlacedLevel>& levels) {
    Place& place = places_[unit];
    place.levels = &levels;
    place.lines.clear();
    for (const PlacedLevel& level : levels)
        place.lines.emplace_back(level, line_bytes_);
}

void TexelLookups::add(std::uint32_t number, std::uint8_t lanes, PreparedQuad& quad) {
    quad.texel_lines_begin = static_cast<std::uint32_t>(out_.texel_lines.size());
    quad.texture_parts_begin = static_cast<std::uint32_t>(out_.texture_parts.size());
    quad.texture_count = static_cast<std::uint8_t>(command_.units.size());
    for (std::size_t i = 0; i < command_.units.size(); ++i) {
        const Place& place = places_[command_.units[i]];
        const std::size_t first_line = out_.texel_lines.size();
        std::array<unsigned, 4> samples{}; // a lane
        for (const TexelAccess& access : command_.accesses_of(number, i)) {
            if ((lanes >> access.lane & 1) == 0) continue;
            samples[access.lane] += (access.linear & 4) ? 2 : 1;
            if (access.level < place.lines.size()) add_access(place, access, quad);
        }
        const unsigned steps = *std::max_element(samples.begin(), samples.end());
        out_.texture_parts.push_back(
            {.lines = static_cast<std::uint16_t>(out_.texel_lines.size() - first_line),
             .filter_steps = static_cast<std::uint16_t>(steps)});
        quad.filter_steps = static_cast<std::uint16_t>(quad.filter_steps + steps);
    }
    quad.texel_line_count =
        static_cast<std::uint16_t>(out_.texel_lines.size() - quad.texel_lines_begin);
}

void TexelLookups::add_line(std::uint64_t line, const PreparedQuad& quad) {
    auto begin = out_.texel_lines.begin() + quad.texel_lines_begin;
    if (begin != out_.texel_lines.end() && out_.texel_lines.back() == line) return;
    if (!merges_ && begin != out_.texel_lines.end()) begin = out_.texel_lines.end() - 1;
    if (std::find(begin, out_.texel_lines.end(), line) == out_.texel_lines.end())
        out_.texel_lines.push_back(line);
}

// Most accesses fall on the line of the texel before.
void TexelLookups::add_square(const LevelLines& level,
                              const TexelAccess& access,
                              PreparedQuad& quad) {
    const std::uint64_t layer = level.layer(access.layer0);
    const std::uint64_t rows[]{layer + level.row(access.y0), layer + level.row(access.y1)};
    const std::uint64_t columns[]{level.column(access.x0), level.column(access.x1)};
    quad.texel_reads = static_cast<std::uint16_t>(quad.texel_reads + 4);
    std::uint64_t last = out_.texel_lines.size() > quad.texel_lines_begin ? out_.texel_lines.back()
                                                                          : ~std::uint64_t{0};
    for (const std::uint64_t row : rows)
        for (const std::uint64_t column : columns) {
            const std::uint64_t line = level.line(row + column);
            if (line == last) continue;
            add_line(line, quad);
            last = line;
        }
}

void TexelLookups::add_access(const Place& place, const TexelAccess& access, PreparedQuad& quad) {
    const PlacedLevel& level = (*place.levels)[access.level];
    quad.expands_blocks |= level.compressed && level.expansion_log2 == 0;
    if (is_plain_square(level, access)) // Most are.
        return add_square(place.lines[access.level], access, quad);
    const std::array columns{level.column_offset(access.x0), level.column_offset(access.x1)};
    const std::array rows{level.row_offset(access.y0), level.row_offset(access.y1)};
    for (unsigned corner = 0; corner < 8; ++corner) {
        if (corner & ~unsigned{access.linear}) continue; // Texels that this filter does not read.
        const std::uint16_t x = corner & 1 ? access.x1 : access.x0;
        const std::uint16_t y = corner & 2 ? access.y1 : access.y0;
        const std::uint16_t layer = corner & 4 ? access.layer1 : access.layer0;
        if (x == TexelAccess::BorderTexel || y == TexelAccess::BorderTexel ||
            layer == TexelAccess::BorderTexel) {
            continue;
        }
        ++quad.texel_reads;
        const std::uint64_t at =
            level.layer_address(layer) + columns[corner & 1] + rows[corner >> 1 & 1];
        add_line(level.expansion_log2 == 0 ? quotient(at, line_bytes_)
                                           : level.line(x, y, layer, line_bytes_),
                 quad);
    }
}

} // namespace ffgpu::work
