// DrawShape: how large the pieces of a draw are, and how full its quads. It follows from the work
// alone.

#pragma once

#include "model/packets/work_stream.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu::work {

struct DrawShape {
    // Points, lines and triangles that came to set-up, by what they cover: nothing, 1, 2 to 3, 4 to
    // 7 ... Samples: of multisampled targets.
    static constexpr std::size_t Sizes = 28;
    std::array<std::uint32_t, Sizes> piece_pixels{}, piece_samples{};
    // Quads, by the number of lanes that are covered, and that are written.
    std::array<std::uint32_t, 5> quad_lanes_covered{}, quad_lanes_written{};

    // All quads of one piece.
    void add_piece(std::span<const WorkQuad> quads, bool multisampled) {
        std::uint32_t pixels = 0, samples = 0;
        for (const WorkQuad& quad : quads) {
            pixels += count(quad.covered);
            if (multisampled)
                samples += static_cast<std::uint32_t>(std::popcount(quad.samples_covered));
        }
        ++piece_pixels[range(pixels)];
        if (multisampled) ++piece_samples[range(samples)];
    }
    void add_quads(std::span<const WorkQuad> quads) {
        for (const WorkQuad& quad : quads) {
            ++quad_lanes_covered[count(quad.covered)];
            ++quad_lanes_written[count(quad.after_depth)];
        }
    }

    // Calls each(name, unit, meaning, counts).
    template <class Each>
    static void visit(const DrawShape& self, Each&& each) {
        each("piece_pixels", "pieces", "by the pixels that they cover", self.piece_pixels);
        each("piece_samples",
             "pieces",
             "of multisampled targets, by the samples that they cover",
             self.piece_samples);
        each("quad_lanes_covered", "quads", "by the lanes covered", self.quad_lanes_covered);
        each("quad_lanes_written", "quads", "by the lanes written", self.quad_lanes_written);
    }

private:
    // Of four lanes, from a table of four bits each: baseline x86-64 counts bits by a call.
    static std::uint32_t count(unsigned lanes) {
        constexpr std::uint64_t Counts = 0x4332'3221'3221'2110;
        return static_cast<std::uint32_t>(Counts >> 4 * (lanes & 0xf)) & 7;
    }
    static std::size_t range(std::uint32_t size) {
        return std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(size)), Sizes - 1);
    }
};

} // namespace ffgpu::work
