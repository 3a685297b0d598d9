// TexelLookups: what the textures of a draw ask of the texel cache, quad by quad: the lines that
// hold the texels which the filters read (quad_lines.h), and how many bilinear samples each texture
// takes. Work that comes fragment by fragment is not merged.

#pragma once

#include "model/work/prepared_work.h"
#include "model/work/quad_lines.h"

#include <array>
#include <cstdint>
#include <memory>

namespace ffgpu::work {

class TexelLookups {
public:
    TexelLookups(const WholeCommand& command, const WorkConfig& config);

    void place(unsigned unit, const std::shared_ptr<const TextureLines>& texture) {
        textures_[unit] = texture;
    }

    // Of the fragments `lanes` of the command's quad `number`. Its lines are appended to `out`.
    void add(std::uint32_t number, std::uint8_t lanes, PreparedQuad& quad, PreparedQuads& out);

private:
    const WholeCommand& command_;
    std::array<std::shared_ptr<const TextureLines>, TextureUnits> textures_;
    QuadLines lines_;
};

} // namespace ffgpu::work
