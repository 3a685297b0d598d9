#include "model/timing/texture_share.h"

#include <algorithm>

namespace ffgpu::timing {

void TextureShare::begin(const work::PreparedQuads& quads, const PreparedQuad& quad) {
    next_ = 0;
    lines_ = quad.texel_line_count;
    if (units_ == 1) return;
    of_unit_.assign(units_, {});
    std::size_t line = 0, part = 0;
    for (const work::TexturePart& texture : quads.textures_of(quad)) {
        for (std::size_t i = 0; i < texture.lines; ++i, ++line)
            of_unit_[(by_texture_ ? part : line) % units_].push_back(line);
        ++part;
    }
    order_.clear();
    for (std::size_t first = 0; order_.size() < lines_; first += lookups_) {
        for (std::size_t unit = 0; unit < units_; ++unit) {
            const std::vector<std::size_t>& own = of_unit_[unit];
            for (std::size_t i = first; i < std::min(first + lookups_, own.size()); ++i)
                order_.push_back({own[i], unit});
        }
    }
}

std::uint32_t TextureShare::filter_cycles(const work::PreparedQuads& quads,
                                          const PreparedQuad& quad) const {
    // Mostly there is nothing to divide by, and a division takes as long as all the rest.
    std::size_t most = units_ == 1 ? quad.filter_steps : (quad.filter_steps + units_ - 1) / units_;
    if (by_texture_ && units_ > 1) {
        const auto textures = quads.textures_of(quad);
        most = 0;
        for (std::size_t unit = 0; unit < units_; ++unit) {
            std::size_t steps = 0;
            for (std::size_t part = unit; part < textures.size(); part += units_)
                steps += textures[part].filter_steps;
            most = std::max(most, steps);
        }
    }
    const std::size_t cycles = width_ == 1 ? most : (most + width_ - 1) / width_;
    return static_cast<std::uint32_t>(std::max<std::size_t>(cycles, 1));
}

} // namespace ffgpu::timing
