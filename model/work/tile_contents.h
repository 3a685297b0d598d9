// TileContents: one target in one bin of a tile-based machine: what of it has to be loaded before
// the bin is drawn, and what is new at its end.
//
// The machine keeps, for each byte of a pixel, whether a clear gave it a value in the whole bin,
// and for each sample whether it was written. What is read or kept without that comes from memory,
// and then the whole bin is loaded once, before its first quad.

#pragma once

#include "model/packets/rectangle.h"
#include "model/work/surface_lines.h"

#include <cstdint>
#include <vector>

namespace ffgpu::work {

// A surface that a scene draws into.
struct TileTarget {
    Surface surface;
    PlacedLevel place;
    std::uint32_t line_bytes = 64;
    bool depth = false;

    // Of a bin: what lies on the surface.
    Rectangle cut(const Rectangle& bin) const {
        return intersect(bin, {0, 0, surface.width, surface.height});
    }
};

class TileContents {
public:
    TileContents(const TileTarget& target, const Rectangle& bin, bool detects_overwrite);

    // Pixels of the bin that lie on the target.
    const Rectangle& pixels() const { return pixels_; }

    void clear(const Rectangle& rectangle, PixelBytes bytes);
    // Reads and writes bytes of some pixels.
    void test(std::uint32_t read, std::uint32_t written);
    // Writes whole samples, after having read them where `reads`.
    void write(const PreparedQuad& quad, bool reads);
    // All of it is read.
    void read_all() { test(all_, 0); }

    // When the bin has been drawn:
    bool needs_load() const;
    // Bytes of a sample that are to be stored: of a colour all, of a depth those that are new.
    std::uint32_t dirty() const { return dirty_; }
    // Bytes that have a new value in every sample: what memory holds of them is of no use.
    std::uint32_t overwritten() const { return missing_ == 0 ? all_ : cleared_; }

private:
    bool is_valid(std::uint32_t bytes) const { return (bytes & ~cleared_) == 0; }
    void write_sample(int x, int y, unsigned sample);

    const std::uint32_t all_; // bytes of a sample
    const bool stores_all_;   // where any is new; else what is new
    const unsigned samples_;
    const Rectangle pixels_;
    const bool detects_overwrite_;
    std::uint32_t cleared_ = 0, dirty_ = 0;
    bool load_ = false;
    std::vector<bool> written_; // samples, row by row; empty: none
    std::size_t missing_;       // that were not written
};

} // namespace ffgpu::work
