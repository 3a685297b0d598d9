// PreparedScene: work made ready for a machine of a given shape: quads in the order in which its
// rasterizer makes them, and for each quad the lines that it will touch. Addresses are in here;
// time is not.

#pragma once

#include "model/packets/quad_values.h"
#include "model/work/config.h"
#include "model/work/draw_shape.h"
#include "model/work/line_mask.h"
#include "model/work/placed_level.h"
#include "model/work/tile_plan.h"
#include "model/work/whole_command.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu::work {

// A quad, or where the machine's granularity is a fragment, one fragment of a quad.
struct PreparedQuad {
    std::uint32_t draw = 0;      // index into PreparedScene::draws
    std::uint32_t primitive = 0; // number within the draw
    std::uint32_t piece = 0;
    std::uint16_t x = 0, y = 0; // window pixel of lane 0
    std::uint8_t covered = 0, after_early_depth = 0, after_stencil = 0, after_depth = 0;
    bool new_tile = false;          // first of a block of its piece's walk
    std::uint32_t empty_blocks = 0; // walked before that block, since the last that holds quads
    std::uint16_t filter_steps = 0; // bilinear (or simpler) samples a fragment, over all textures
    std::uint16_t texel_reads = 0;
    std::uint16_t border_texels = 0; // read beside them: the border's colour, which is in no line
    std::uint16_t texel_line_count = 0;
    std::uint32_t texel_lines_begin = 0;   // into PreparedScene::texel_lines
    std::uint32_t texture_parts_begin = 0; // into PreparedScene::texture_parts
    std::uint8_t texture_count = 0;
    bool expands_blocks = false;       // reads texels of compressed blocks
    std::uint16_t samples_written = 0; // as WorkQuad has it
    std::uint8_t depth_line_count = 0;
    std::uint8_t color_line_count = 0;    // of all colour targets
    std::uint32_t target_lines_begin = 0; // into PreparedScene::target_lines: depth, then colour
    // With values:
    std::uint16_t samples_covered = 0; // as WorkQuad has it
    std::uint8_t after_alpha = 0;
    std::uint32_t value_count = 0;
    std::uint32_t values_begin = 0; // into PreparedScene::values
};

// A point, line or triangle that comes to set-up: its quads, in their order.
struct PreparedPiece {
    std::uint32_t begin = 0, end = 0; // of the scene's quads
    PieceBox box;
    std::uint32_t empty_blocks = 0; // walked after the last one that holds quads
};

// Memory that an image reads: rows of bytes.
struct ImageMemory {
    std::uint64_t address = 0, row_bytes = 0, stride = 0, rows = 0;
};

// A primitive as it leaves geometry.
struct PreparedPrimitive {
    std::uint32_t last_vertex = 0; // place in GeometryWork::vertices: it is assembled after this
    std::uint32_t first_piece = 0, piece_count = 0; // in PreparedScene::pieces
    std::uint8_t planes = 0;                        // as PrimitiveWork has them
    PrimitiveFate fate = PrimitiveFate::Drawn;
};

// A quad's part of one texture; its lines follow those of the texture before. A line that several
// textures read stands with the first.
struct TexturePart {
    std::uint16_t lines = 0;
    std::uint16_t filter_steps = 0;
};

struct PreparedDraw {
    WorkKind kind = WorkKind::Draw;                        // or an image
    std::uint32_t number = 0;                              // PrimitiveKey::draw
    std::uint32_t register_writes = 0, register_words = 0; // as WorkDraw has them
    ImageMemory image;
    GeometryWork geometry; // Its primitives and pieces are the scene's.
    std::uint32_t first_primitive = 0, primitive_count = 0; // in PreparedScene::primitives
    bool early_depth = false;     // Depth is tested before texturing, and only there.
    bool tests_twice = false;     // before texturing, and once more, and written, after it
    std::uint32_t first_quad = 0; // immediate machines: the draw's quads stand together
    std::uint32_t quad_count = 0;
    std::uint8_t combiners = 0;              // enabled texture environments
    PlacedLevel depth_place;                 // of its target, if it has one
    std::vector<PlacedLevel> color_places;   // of its colour targets
    std::vector<std::uint8_t> color_targets; // their numbers
    // As its state has it (target_access.h).
    std::uint32_t depth_bytes_read = 0; // of a sample, bit i for byte i
    bool writes_depth = false;
    bool reads_color = false, writes_color = false;
    bool masks_color = false; // leaves bytes of pixels that it writes as they are
    bool has_values = false;  // Its quads have.
    QuadValueKinds value_kinds;
    DrawShape shape;
    std::shared_ptr<const Registers> state;

    bool reads_depth() const { return depth_bytes_read != 0; }
    bool uses_depth() const { return reads_depth() || writes_depth; }
};

// Quads in the order in which the rasterizer makes them, and the lines that they touch.
struct PreparedQuads {
    std::vector<PreparedQuad> quads;
    std::vector<std::uint64_t> texel_lines; // line numbers
    std::vector<TexturePart> texture_parts;
    std::vector<std::uint64_t> target_lines;
    std::vector<WrittenBytes> target_bytes; // of each of them: what the quad writes of it
    std::vector<std::uint32_t> values;      // words, where the work has values

    std::span<const std::uint64_t> lines_of(const PreparedQuad& quad) const {
        return std::span(texel_lines).subspan(quad.texel_lines_begin, quad.texel_line_count);
    }
    std::span<const TexturePart> textures_of(const PreparedQuad& quad) const {
        return std::span(texture_parts).subspan(quad.texture_parts_begin, quad.texture_count);
    }
    // Of the fragments whose depth is tested, and of those that are written: as many lines as the
    // layout spreads them over.
    std::span<const std::uint64_t> depth_lines(const PreparedQuad& quad) const {
        return std::span(target_lines).subspan(quad.target_lines_begin, quad.depth_line_count);
    }
    std::span<const std::uint64_t> color_lines(const PreparedQuad& quad) const {
        return std::span(target_lines)
            .subspan(quad.target_lines_begin + quad.depth_line_count, quad.color_line_count);
    }
    // What the quad's samples that passed all tests write of its i-th line.
    const WrittenBytes& depth_bytes(const PreparedQuad& quad, std::size_t i) const {
        return target_bytes[quad.target_lines_begin + i];
    }
    const WrittenBytes& color_bytes(const PreparedQuad& quad, std::size_t i) const {
        return target_bytes[quad.target_lines_begin + quad.depth_line_count + i];
    }
    // Of a quad of this draw, which has values.
    QuadValues values_of(const PreparedDraw& draw, const PreparedQuad& quad) const;
};

// What streams through a machine's pipe in one go: one draw of an immediate machine; of a
// tile-based one all draws that are sorted by screen bins together.
struct PreparedScene : PreparedQuads {
    std::vector<PreparedDraw> draws;
    std::vector<PreparedPrimitive> primitives;
    std::vector<PreparedPiece> pieces; // in the order in which they are walked
    TilePlan tiles;                    // of a tile-based machine
    std::size_t quads_to_come = 0;     // in parts, behind those in here
};

// The last quad of a piece was told.
struct PieceEnd {
    std::uint32_t piece = 0;        // in PreparedScene::pieces
    std::uint32_t empty_blocks = 0; // PreparedPiece's
};

inline void set_ends(const std::vector<PieceEnd>& ends, PreparedScene& scene) {
    for (const PieceEnd& end : ends)
        scene.pieces[end.piece].empty_blocks = end.empty_blocks;
}

// The next quads of a scene that was told without them.
struct PreparedPart : PreparedQuads {
    std::vector<PieceEnd> ends;
};

// A screen bin of a pass; bins of earlier passes come first.
using BinKey = std::uint64_t;
constexpr BinKey bin_key(std::uint32_t pass, std::uint32_t screen_bin) {
    return std::uint64_t{pass} << 32 | screen_bin;
}

// What of a piece is walked in a bin.
struct PiecePart {
    BinKey key = 0;
    std::uint32_t piece = 0; // index into PreparedScene::pieces
};

// Tells the piece's quads, in their order, where blocks begin and how many empty ones are walked
// before. Where no box is told only blocks with quads are.
void walk_piece(const RasterOrder& raster, PreparedPiece& piece, PreparedScene& scene);

// Brings the quads of a whole scene into the order of their bins, a key each; where keys are equal,
// as they were. A piece has a part for each key of its quads, and for those of `walked` that hold
// none of them; the walk of a part stays in the bin. Returns the key of each part. Of the pieces
// before set-up needs the numbers alone.
std::vector<BinKey> sort_quads(const RasterOrder& raster,
                               const std::vector<BinKey>& keys,
                               const std::vector<PiecePart>& walked,
                               PreparedScene& scene);

} // namespace ffgpu::work
