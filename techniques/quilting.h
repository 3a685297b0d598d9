// Data-driven synthesis (T22): a larger texture quilted of pieces of a small one, joined along cuts
// of least error.
//
// Source: Efros and Freeman 2001, "Image Quilting for Texture Synthesis and Transfer".

#pragma once

#include "techniques/image.h"

#include <cstdint>
#include <vector>

namespace ffgpu::techniques {

// The cut from the first row to the last of least summed error, moving by at most one column a row:
// one column index a row. Of equal sums the path with the smaller column wins, from the last row
// up.
std::vector<int> minimum_error_cut(const Field& error);

struct Quilt {
    int block = 24;      // side of a piece, texels; at most the source's sides
    int overlap = 6;     // how far pieces overlap, less than a block
    int across = 5;      // pieces in each direction: the result's side is
                         // across (block - overlap) + overlap
    int candidates = 40; // places of the source that are tried for each piece
};

// Raster order from the bottom left. The first piece, and each candidate of the others, begins at
// two draws of Random(seed), x below(width - block + 1), then y below(height - block + 1); of the
// candidates the first with the least sum of squared differences over the overlap is taken. A piece
// covers the result to the right of its left cut and above its lower cut, the cuts themselves
// included.
Field quilt(const Field& source, const Quilt& quilt, std::uint64_t seed);

} // namespace ffgpu::techniques
