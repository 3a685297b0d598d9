// Moves pixels between a surface and an array with one word a fragment, in the order of the lanes.
//
// A quad is two pixels in each of two rows, so a row of a quad is one load or store. A quad that
// hangs over the surface's odd edge goes pixel by pixel: what is not in the surface is not touched.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/packets/fragment_batch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

struct LaneWords {
    alignas(64) std::array<std::uint32_t, BatchFragments> words;

    std::uint32_t* data() { return words.data(); }
    const std::uint32_t* data() const { return words.data(); }
};

// Pixels of 8, 16 or 32 bits. The words of quads without a live fragment stay as they are.
void load_quads(const Surface& surface,
                std::span<const std::byte> memory,
                const FragmentBatch& batch,
                LaneWords& pixels);

// Stores the fragments in `mask`, a part of batch.live. A pixel beside them in their quad may be
// stored as well, as it was: a tile has one writer.
void store_quads(const Surface& surface,
                 std::span<std::byte> memory,
                 const FragmentBatch& batch,
                 const FragmentMask& mask,
                 const LaneWords& pixels);

} // namespace ffgpu
