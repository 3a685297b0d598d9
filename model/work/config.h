// What the order and the places of work depend on, of any machine that is explored: raster order,
// scenes, layouts, cache shapes. No time is in here; model/timing adds it.

#pragma once

#include "model/base/parameters.h"
#include "model/work/tile_config.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::work {

enum class Traversal : std::uint8_t { Scanline, Column, Tiled, Nested, Morton, Hilbert };
inline constexpr std::array<std::string_view, 6> TraversalNames{
    "scanline", "column", "tiled", "nested", "morton", "hilbert"};

enum class Architecture : std::uint8_t { Immediate, TileBased };
inline constexpr std::array<std::string_view, 2> ArchitectureNames{"immediate", "tile_based"};

enum class Layout : std::uint8_t { Linear, Blocked, Blocked6d };
inline constexpr std::array<std::string_view, 3> LayoutNames{"linear", "blocked", "blocked_6d"};

// What the rasterizer makes, and all units after it work on. Single fragments are how the
// literature of texture caches counts.
enum class Granularity : std::uint8_t { Quad, Fragment };
inline constexpr std::array<std::string_view, 2> GranularityNames{"quad", "fragment"};

// When a machine tests depth: where nothing can see the difference, before texturing; also draws
// that may lose fragments later, tested before and once more, and written, after texturing; all
// after texturing.
enum class DepthTest : std::uint8_t { AsGlAllows, EarlyWhereExact, Late };
inline constexpr std::array<std::string_view, 3> DepthTestNames{
    "as_gl_allows", "early_where_exact", "late"};

struct RasterOrder {
    Architecture architecture = Architecture::Immediate;
    Granularity granularity = Granularity::Quad;
    Traversal traversal = Traversal::Tiled;
    std::uint32_t tile_width = 8;
    std::uint32_t outer_tile_width = 32;
    std::uint32_t bin_size = 32;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("architecture",
              self.architecture,
              {.meaning = "immediate: primitive after primitive; tile_based: screen bins, each "
                          "with all its primitives",
               .choices = ArchitectureNames});
        field("granularity",
              self.granularity,
              {.meaning = "quad: 2x2 pixels at a time, whose reads of a texel-cache line are one "
                          "look-up; fragment: one pixel at a time, each read a look-up",
               .choices = GranularityNames});
        field("traversal",
              self.traversal,
              {.meaning =
                   "order of a primitive's quads: rows, columns, or tiles; tiles row by row, "
                   "in nested tiles, or along Morton's or Hilbert's curve",
               .choices = TraversalNames});
        field("tile_width",
              self.tile_width,
              {.unit = "pixels",
               .minimum = 2,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of a tile, all but scanline and column: width and height"});
        field("outer_tile_width",
              self.outer_tile_width,
              {.unit = "pixels",
               .minimum = 2,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "nested: width and height of the tiles of tiles; less than a tile's "
                          "counts as a tile's"});
        field("bin_size",
              self.bin_size,
              {.unit = "pixels",
               .minimum = 8,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "tile_based: width and height of a bin"});
    }
};

// A cache and the images that it reads.
struct CacheShape {
    std::uint32_t sets = 64;
    std::uint32_t ways = 4;
    std::uint32_t line_bytes = 64;
    Layout layout = Layout::Blocked;
    std::uint32_t block_width = 4;

    std::uint32_t bytes() const { return sets * ways * line_bytes; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("sets",
              self.sets,
              {.unit = "sets",
               .minimum = 1,
               .maximum = 1 << 20,
               .power_of_two = true,
               .meaning = "1: fully associative"});
        field("ways",
              self.ways,
              {.unit = "ways", .minimum = 1, .maximum = 1 << 16, .meaning = "1: direct mapped"});
        field("line_bytes",
              self.line_bytes,
              {.unit = "bytes",
               .minimum = 16,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "of a line"});
        field("layout", self.layout, {.meaning = "of the image in memory", .choices = LayoutNames});
        field("block_width",
              self.block_width,
              {.unit = "texels",
               .minimum = 1,
               .maximum = 64,
               .power_of_two = true,
               .meaning = "blocked layouts: width and height of a block"});
    }
};

// What a texel cache holds of a compressed texture.
enum class TexelContents : std::uint8_t { Blocks, Texels };
inline constexpr std::array<std::string_view, 2> TexelContentsNames{"blocks", "texels"};

// Where the texels lie that are written to a level which was read before.
enum class RewrittenLevel : std::uint8_t { InPlace, NewPlace };
inline constexpr std::array<std::string_view, 2> RewrittenLevelNames{"in_place", "new_place"};

struct TexelCacheShape : CacheShape {
    TexelContents contents = TexelContents::Blocks;
    std::uint32_t superblock_width = 32;
    RewrittenLevel rewritten = RewrittenLevel::InPlace;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        CacheShape::visit(self, field);
        field("superblock_width",
              self.superblock_width,
              {.unit = "texels",
               .minimum = 2,
               .maximum = 512,
               .power_of_two = true,
               .meaning = "blocked_6d: width and height of a superblock"});
        field("contents",
              self.contents,
              {.meaning =
                   "of compressed textures; blocks: lines hold blocks as they lie in memory, "
                   "expanded at each read; texels: lines hold texels of 4 bytes, expanded "
                   "when the line is filled, which reads the blocks",
               .choices = TexelContentsNames});
        field("rewritten",
              self.rewritten,
              {.meaning =
                   "texels of a level that was read before; in_place: the lines that hold them "
                   "are thrown out of the caches before the next draw, whose quads wait for "
                   "those before them; new_place: the level moves, as a driver does that waits "
                   "for nobody, and none of its lines is there any more",
               .choices = RewrittenLevelNames});
    }
};

struct WorkConfig {
    RasterOrder raster;
    TexelCacheShape texel_cache;
    CacheShape depth_cache;
    CacheShape color_cache;
    TileOrder tiles;
    DepthTest depth_test = DepthTest::AsGlAllows;
    bool target_lines = true;       // Those of depth and colour are wanted.
    bool merges_texel_reads = true; // of a line, by a quad; fragments merge none
};

} // namespace ffgpu::work
