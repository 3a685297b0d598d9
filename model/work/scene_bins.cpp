// The walk of a piece's blocks, and a scene's quads in the order of their bins.

#include "model/work/piece_walk.h"
#include "model/work/prepared_work.h"
#include "model/work/tile_lines.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace ffgpu::work {
namespace {

// What of a box lies in the bin.
PieceBox part_in_bin(const PieceBox& box, const RasterOrder& raster, BinKey key) {
    if (box.empty()) return {};
    const std::uint32_t size = raster.bin_size;
    const Rectangle bin = bin_rectangle(size, static_cast<std::uint32_t>(key));
    const auto inside = [](int bound, int from, int to) {
        return static_cast<std::uint16_t>(std::clamp(bound, from, to));
    };
    return {inside(box.x0, bin.x0, bin.x1),
            inside(box.y0, bin.y0, bin.y1),
            inside(box.x1, bin.x0, bin.x1),
            inside(box.y1, bin.y0, bin.y1)};
}

// A quad of a piece in a bin, or the piece in a bin where it has none.
struct Placed {
    static constexpr std::uint32_t None = ~0u;

    BinKey key = 0;
    std::uint32_t piece = 0, quad = None;

    bool operator<(const Placed& other) const {
        return std::tie(key, piece, quad) < std::tie(other.key, other.piece, other.quad);
    }
};

std::vector<Placed> placed_in_bins(const std::vector<BinKey>& keys,
                                   const std::vector<PiecePart>& walked,
                                   const PreparedScene& scene) {
    std::vector<Placed> order;
    order.reserve(scene.quads.size() + walked.size());
    for (std::uint32_t piece = 0; piece < scene.pieces.size(); ++piece)
        for (std::uint32_t i = scene.pieces[piece].begin; i < scene.pieces[piece].end; ++i)
            order.push_back({keys[i], piece, i});
    for (const PiecePart& part : walked)
        order.push_back({part.key, part.piece, Placed::None});
    std::sort(order.begin(), order.end());
    return order;
}

} // namespace

void walk_piece(const RasterOrder& raster, PreparedPiece& piece, PreparedScene& scene) {
    PieceWalk walk(raster, piece.box);
    for (PreparedQuad& quad : std::span(scene.quads).subspan(piece.begin, piece.end - piece.begin))
        walk.come_to(quad);
    piece.empty_blocks = walk.empty_behind();
}

std::vector<BinKey> sort_quads(const RasterOrder& raster,
                               const std::vector<BinKey>& keys,
                               const std::vector<PiecePart>& walked,
                               PreparedScene& scene) {
    const std::vector<Placed> order = placed_in_bins(keys, walked, scene);
    const std::vector<PreparedPiece> whole = std::exchange(scene.pieces, {});
    const std::vector<PreparedQuad> quads = std::exchange(scene.quads, {});
    std::vector<BinKey> part_keys;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Placed& placed = order[i];
        if (i == 0 || placed.key != order[i - 1].key || placed.piece != order[i - 1].piece) {
            const auto at = static_cast<std::uint32_t>(scene.quads.size());
            const PieceBox box = part_in_bin(whole[placed.piece].box, raster, placed.key);
            scene.pieces.push_back({at, at, box, 0});
            part_keys.push_back(placed.key);
        }
        if (placed.quad == Placed::None) continue;
        scene.quads.push_back(quads[placed.quad]);
        ++scene.pieces.back().end;
    }
    for (PreparedPiece& piece : scene.pieces)
        walk_piece(raster, piece, scene);
    return part_keys;
}

} // namespace ffgpu::work
