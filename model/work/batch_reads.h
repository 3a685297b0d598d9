// BatchReads: the lines that a batch's quads read, a plane of accesses at a time. The texels that a
// quad reads of one level lie in few rectangles of one line each (level_lines.h), mostly in two
// beside each other, two above them, or in one: vectors tell for all quads which of these four each
// fragment is the first to read.

#pragma once

#include "model/packets/work_stream.h"
#include "model/work/quad_lines.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

// Of each quad the four rectangles from the one of texel (x, y) on, to the right and up, and which
// of them a fragment reads that no fragment before it does, in the order of its reads: a bit each.
struct PlaneRectangles {
    // In any lane: the quad reads something else.
    static constexpr std::uint16_t Others = 0x8000;

    // By lane; of quads that have a live lane.
    alignas(64) std::array<std::uint16_t, BatchFragments> first;
    alignas(64) std::array<std::uint32_t, BatchFragments> x, y; // twice: in both halves
};

// Of squares in rectangles of texels that are told apart by `bits` of their coordinates.
void find_rectangles(const AccessPlane& plane,
                     const FragmentMask& live,
                     const RectangleBits& bits,
                     PlaneRectangles& found);
// Quad by quad: what it says.
void find_rectangles_plainly(const AccessPlane& plane,
                             const FragmentMask& live,
                             const RectangleBits& bits,
                             PlaneRectangles& found);

class BatchReads {
public:
    // Of fragments in `lanes`; textures by unit.
    void set(const WorkBatch& batch,
             const FragmentMask& lanes,
             std::span<const TextureLines* const> textures);

    // In the order of the machine, which merges a quad's reads of a line. Quads are asked for in
    // the order of the batch.
    void add_quad(unsigned quad, QuadLines& lines);
    // Instead: whether it reads the lines of the quad before it, which had some, in the same order,
    // as the lanes of both read first the same rectangles.
    bool repeats(unsigned quad) {
        const bool again = before_ + 1 == quad && (repeats_ >> quad & 1) != 0;
        before_ += again;
        return again;
    }
    // Texels that such a quad reads.
    std::uint32_t reads(unsigned quad) const;

private:
    struct Plane {
        const AccessPlane* accesses = nullptr;
        FragmentMask live;
        PlaneRectangles rectangles;
    };
    struct Unit {
        const TextureLines* texture = nullptr;
        std::size_t begin = 0, end = 0; // of planes_
    };

    static constexpr unsigned None = BatchQuads;

    bool add_rectangles(const Unit& unit, unsigned quad, QuadLines& lines) const;
    void add_each(const Unit& unit, unsigned quad, QuadLines& lines) const;

    std::vector<Unit> units_;
    std::vector<Plane> planes_; // the first plane_count_ of them
    std::size_t plane_count_ = 0;
    std::uint64_t repeats_ = 0; // quads that read the rectangles of the quad before, a bit each
    unsigned before_ = None;    // the last quad, if it had lines and all of these lie in rectangles
};

} // namespace ffgpu::work
