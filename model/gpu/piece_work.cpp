#include "model/gpu/piece_work.h"

#include "model/raster/coverage.h"

#include <bit>

namespace ffgpu {
namespace {

// Attributes of the record that vary; of the texture units' q alone, or of all.
unsigned varying_planes(const InterpolantLayout& layout, const SetupRecord& record, bool q_alone) {
    unsigned planes = 0;
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (layout.tex_coord[unit] < 0) continue;
        const unsigned components = layout.tex_components[unit];
        planes += q_alone ? components / 4 : components;
    }
    if (q_alone) return planes;
    if (layout.color >= 0 && !record.constant_color) planes += 4;
    if (layout.secondary >= 0 && !record.constant_secondary) planes += 3;
    return planes + (layout.fog >= 0);
}

} // namespace

void add_set_up(const InterpolantLayout& layout, const SetupRecord& record, PieceBox& piece) {
    const auto count = [](unsigned n) { return static_cast<std::uint8_t>(n); };
    static_assert(PieceBox::BlockWidth == BlockSize);
    piece.handed_on = true;
    piece.touched_blocks = touched_blocks(edge_set(record));
    const unsigned varying = varying_planes(layout, record, false);
    piece.perspective = record.perspective;
    piece.planes = count(varying + record.perspective);
    piece.values = count(varying - varying_planes(layout, record, true));
    piece.divisors = count((record.perspective && varying != 0) +
                           static_cast<unsigned>(std::popcount(record.divided_units)));
}

} // namespace ffgpu
