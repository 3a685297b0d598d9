// TexelLookups: what the textures of a draw ask of the texel cache, quad by quad: the lines that
// hold the texels which the filters read, and how many bilinear samples each texture takes.
//
// A quad's reads of one line are one look-up, as a chip that works in quads merges them. Work that
// comes fragment by fragment is not merged: each read is a look-up, as the literature counts, save
// that reads of one line that follow each other are told once, which no cache can tell apart.

#pragma once

#include "model/work/level_lines.h"
#include "model/work/prepared_work.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

class TexelLookups {
public:
    TexelLookups(const WholeCommand& command, const WorkConfig& config, PreparedScene& out);

    void place(unsigned unit, const std::vector<PlacedLevel>& levels);

    // Of the fragments `lanes` of the command's quad `number`.
    void add(std::uint32_t number, std::uint8_t lanes, PreparedQuad& quad);

private:
    struct Place {
        const std::vector<PlacedLevel>* levels = nullptr;
        std::vector<LevelLines> lines; // of each
    };

    void add_access(const Place& place, const TexelAccess& access, PreparedQuad& quad);
    void add_square(const LevelLines& level, const TexelAccess& access, PreparedQuad& quad);
    void add_line(std::uint64_t line, const PreparedQuad& quad);

    const WholeCommand& command_;
    const std::uint32_t line_bytes_;
    const bool merges_;
    PreparedScene& out_;
    std::array<Place, TextureUnits> places_{};
};

} // namespace ffgpu::work
