// PreparedBin: a bin of the work stream made ready for the units: quads in the order in which the
// machine's rasterizer makes them, and for each quad the lines that it will touch. Times are not in
// here; addresses are.

#pragma once

#include "model/packets/work_stream.h"
#include "model/timing/address_map.h"
#include "model/timing/config.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::timing {

struct PreparedQuad {
    std::uint32_t draw = 0;      // index into PreparedBin::draws
    std::uint32_t primitive = 0; // number within the draw
    std::uint16_t x = 0, y = 0;  // window pixel of lane 0
    std::uint8_t covered = 0, after_early_depth = 0, after_stencil = 0, after_depth = 0;
    bool new_tile = false;          // first of a traversal tile of its primitive
    std::uint16_t filter_steps = 0; // bilinear (or simpler) samples a fragment, over all units
    std::uint16_t texel_reads = 0;
    std::uint16_t texel_line_count = 0;
    std::uint32_t texel_lines_begin = 0; // into PreparedBin::texel_lines
    std::uint16_t samples_written = 0;   // as WorkQuad has it
    std::uint8_t depth_line_count = 0;
    std::uint8_t color_line_count = 0;
    std::uint32_t target_lines_begin = 0; // into PreparedBin::target_lines: depth, then colour
};

struct PreparedDraw {
    WorkDraw work;                // geometry, clear, copy, state
    std::uint32_t segment = 0;    // index into PreparedBin::segments
    std::uint32_t first_quad = 0; // immediate machines: the draw's quads stand together
    std::uint32_t quad_count = 0;
    std::uint8_t combiners = 0;           // enabled texture environments
    PlacedLevel depth_place, color_place; // of the targets it has
    bool uses_depth = false;
    bool writes_depth = false;
    bool reads_color = false; // blending, logic op or a partial mask
    bool writes_color = false;
    std::uint32_t primitives_with_quads = 0;

    // Primitives that reach set-up one by one. Images have no geometry work: only what they drew.
    std::uint32_t primitives() const {
        return std::max(work.geometry.primitives_in, primitives_with_quads);
    }

    // Keys up to which the quads belong to the first n of them.
    std::uint32_t keys_before(std::uint32_t n) const {
        const std::uint64_t keys = work.geometry.keys_end - work.geometry.keys_begin;
        return work.geometry.keys_begin +
               static_cast<std::uint32_t>(n * keys / std::max(primitives(), 1u));
    }
};

// Draws between two clears or copies: what a tile-based machine may sort by screen bins.
struct Segment {
    std::uint32_t draws = 0; // that stream through the pipe
    std::uint32_t quads_begin = 0, quads_end = 0;
};

// Bytes of device memory that the host wrote.
struct HostWrite {
    std::uint64_t begin = 0, end = 0;
};

struct PreparedBin {
    std::vector<HostWrite> host_writes; // before its draws; the vertex fetch takes them
    std::vector<PreparedDraw> draws;
    std::vector<Segment> segments;
    std::vector<PreparedQuad> quads;
    std::vector<std::uint64_t> texel_lines; // line numbers
    std::vector<std::uint64_t> target_lines;
    std::uint64_t finished_draws = 0; // by the unit that read a draw last
    std::uint64_t retired_quads = 0;  // counted by the unit that ends a quad

    // No token points in here any more.
    bool is_done() const { return finished_draws == draws.size() && retired_quads == quads.size(); }

    std::span<const std::uint64_t> lines_of(const PreparedQuad& quad) const {
        return std::span(texel_lines).subspan(quad.texel_lines_begin, quad.texel_line_count);
    }

    // Of the covered fragments, and of those that are written. With one sample a pixel a quad lies
    // in one line; with several it may need a line or two for each row.
    std::span<const std::uint64_t> depth_lines(const PreparedQuad& quad) const {
        return std::span(target_lines).subspan(quad.target_lines_begin, quad.depth_line_count);
    }
    std::span<const std::uint64_t> color_lines(const PreparedQuad& quad) const {
        return std::span(target_lines)
            .subspan(quad.target_lines_begin + quad.depth_line_count, quad.color_line_count);
    }
};

// Immediate machines: draw after draw, primitive after primitive, quads in the traversal order.
// Tile-based machines: screen bins in row order, inside each the same.
PreparedBin prepare(const WorkBin& bin, const TimingConfig& config, AddressMap& addresses);

} // namespace ffgpu::timing
