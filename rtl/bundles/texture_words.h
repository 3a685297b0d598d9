// A texture unit's registers as the model has understood them: what the RTL decodes, and of a whole
// pipe's units where their levels lie.

#pragma once

#include "model/texture/texture_unit.h"
#include "rtl/bundles/state.h"

namespace ffgpu::rtl {

inline TextureWords texture_words(const TextureUnit& unit) {
    TextureWords words{.image = {.shape = {.kind = unit.kind, .format = unit.format}},
                       .sampler = unit.sampler};
    words.image.srgb = unit.srgb;
    words.image.shape.width = static_cast<std::uint32_t>(unit.size[0]);
    words.image.shape.height = static_cast<std::uint32_t>(unit.size[1]);
    words.image.shape.depth = static_cast<std::uint32_t>(unit.size[2]);
    words.image.shape.levels = unit.last_level + 1;
    words.image.shape.border = static_cast<std::uint32_t>(unit.border);
    return words;
}

struct TextureContext {
    LevelTable levels;
    TextureWords words;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        for (unsigned level = LevelTable::Size; level-- > 0;) {
            field("layer_stride", self.levels.layer_stride[level], 32);
            field("row_stride", self.levels.row_stride[level], 32);
            field("offset", self.levels.offset[level], 32);
        }
        TextureWords::visit(self.words, field);
    }
};

} // namespace ffgpu::rtl
