#include "model/work/tile_lines.h"

namespace ffgpu::work {
namespace {

constexpr std::uint32_t Piece = 4; // bytes that a masked burst moves together

} // namespace

void add_bin_lines(const TileTarget& target,
                   const Rectangle& bin,
                   std::uint32_t bytes,
                   std::vector<PlacedLine>& lines) {
    const LineGrain grain(target.line_bytes);
    for (const WrittenLine& line :
         rectangle_lines(target.place, grain, target.cut(bin), {bytes, bytes}))
        lines.push_back({line.number * target.line_bytes,
                         grain.moved_bytes(line.bytes.touched, Piece),
                         target.depth});
}

} // namespace ffgpu::work
