// QuadCollector: fills a FragmentBatch with the covered quads of consecutive primitives of a draw
// within one tile, so that small primitives make full batches.
//
// A batch ends when it is full, or when a pixel is covered that is live in it already: the
// primitive that covers it later must see what the earlier one wrote. Where primitives cover
// samples, that goes for samples: neighbours in a mesh share the pixels of their edge in one batch.

#pragma once

#include "model/packets/fragment_batch.h"
#include "model/raster/coverage.h"
#include "model/raster/quad_pack.h"
#include "model/raster/sample_coverage.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace ffgpu {

// The quads of one primitive in a batch: those from first_quad on, up to the next run's.
struct BatchRun {
    const SetupRecord* record;
    unsigned first_quad;
};

// Coverage in 0 .. 255 of a block's pixels, by block_bit().
using BlockAntialias = std::array<std::uint8_t, BlockSize * BlockSize>;

// A window's pixels by the blocks that they lie in: that of its lower left, and those to the right,
// above and beyond both.
struct WindowParts {
    BlockMask here, right, up, diagonal;

    explicit WindowParts(const BlockCoverage& window) {
        constexpr unsigned Row = 4 * BlockQuadsAcross;                             // bits
        const unsigned x = window.x % BlockSize / 2, y = window.y % BlockSize / 2; // quads
        // Columns that stay in the blocks to the left, of all rows of quads.
        const BlockMask left = BlockMask{0x0001000100010001} * (0xffffu >> (4 * x));
        const auto above = [&](BlockMask mask) { return mask >> 1 >> (Row * (4 - y) - 1); };
        const BlockMask stay = (window.mask & left) << (4 * x);
        const BlockMask leave = (window.mask & ~left) >> 1 >> (4 * (4 - x) - 1);
        here = stay << (Row * y);
        right = leave << (Row * y);
        up = above(stay);
        diagonal = above(leave);
    }
};

class QuadCollector {
public:
    explicit QuadCollector(FragmentBatch& batch, PackQuads pack = pack_quads)
        : batch_(batch)
        , pack_(pack) {
        clear();
    }

    void begin_tile(const Rectangle& tile) {
        tile_ = tile;
        batch_.tile_x = static_cast<std::uint16_t>(tile.x0);
        batch_.tile_y = static_cast<std::uint16_t>(tile.y0);
    }

    // Adds a block of `record`; calls flush() before the batch overflows or a pixel recurs.
    // flush() carries out the batch and ends with clear(). `antialias` may be null: all 255.
    template <class Flush>
    void add(const SetupRecord& record,
             const BlockCoverage& block,
             const BlockAntialias* antialias,
             Flush&& flush);

    // The same for a window of a primitive that fits one: its pixels lie in up to four blocks.
    template <class Flush>
    void add_window(const SetupRecord& record, const BlockCoverage& window, Flush&& flush);

    // The same for samples; fills the batch's `samples` as well.
    template <class Flush>
    void add_samples(const SetupRecord& record, const SampleBlock& block, Flush&& flush);

    bool empty() const { return batch_.quad_count == 0; }
    std::span<const BatchRun> runs() const { return {runs_.data(), run_count_}; }
    void clear();

private:
    static constexpr unsigned BlocksAcross = MaxTileSize / BlockSize;

    template <class Block>
    unsigned block_index(const Block& block) const {
        const unsigned x = block.x - static_cast<unsigned>(tile_.x0);
        const unsigned y = block.y - static_cast<unsigned>(tile_.y0);
        return y / BlockSize * BlocksAcross + x / BlockSize;
    }
    void begin_run(const SetupRecord& record);
    BlockMask append(const BlockCoverage& block, BlockMask mask, const BlockAntialias* antialias);
    void append_block(const BlockCoverage& block);
    void append_samples(SampleBlock& block);
    unsigned append_quad(unsigned x, unsigned y, unsigned lanes);

    FragmentBatch& batch_;
    const PackQuads pack_;
    Rectangle tile_;
    unsigned run_count_ = 0;
    std::array<BatchRun, BatchQuads> runs_;
    // Pixels live in the batch, by block. Windows have no pixels in blocks beyond the tile's.
    std::array<BlockMask, MaxTileBlocks + BlocksAcross + 1> live_{};
    unsigned touched_end_ = 0; // Blocks from here on are 0 in live_.
    std::array<std::array<BlockMask, MaxSamples>, MaxTileBlocks> live_samples_{};
    unsigned touched_samples_end_ = 0;
};

template <class Flush>
void QuadCollector::add(const SetupRecord& record,
                        const BlockCoverage& block,
                        const BlockAntialias* antialias,
                        Flush&& flush) {
    const unsigned index = block_index(block);
    if ((live_[index] & block.mask) != 0) flush();
    BlockMask left = block.mask;
    while (true) {
        begin_run(record);
        const BlockMask before = left;
        left = append(block, left, antialias);
        live_[index] |= before & ~left;
        touched_end_ = touched_end_ > index ? touched_end_ : index + 1;
        if (left == 0) return;
        flush();
    }
}

template <class Flush>
void QuadCollector::add_window(const SetupRecord& record,
                               const BlockCoverage& window,
                               Flush&& flush) {
    BlockMask* const live = live_.data() + block_index(window);
    const WindowParts parts(window);
    const BlockMask recurring = (live[0] & parts.here) | (live[1] & parts.right) |
                                (live[BlocksAcross] & parts.up) |
                                (live[BlocksAcross + 1] & parts.diagonal);
    if (recurring != 0 || batch_.quad_count > BatchQuads - BlockQuads) flush();
    begin_run(record);
    append_block(window);
    live[0] |= parts.here;
    live[1] |= parts.right;
    live[BlocksAcross] |= parts.up;
    live[BlocksAcross + 1] |= parts.diagonal;
    const auto end = static_cast<unsigned>(live - live_.data()) + BlocksAcross + 2;
    touched_end_ = touched_end_ > end ? touched_end_ : end;
}

template <class Flush>
void QuadCollector::add_samples(const SetupRecord& record,
                                const SampleBlock& block,
                                Flush&& flush) {
    const unsigned index = block_index(block);
    std::array<BlockMask, MaxSamples>& live = live_samples_[index];
    bool recurs = false;
    for (unsigned i = 0; i < MaxSamples; ++i)
        recurs = recurs || (live[i] & block.masks[i]) != 0;
    if (recurs) flush();
    SampleBlock left = block;
    while (true) {
        begin_run(record);
        const SampleBlock before = left;
        append_samples(left);
        for (unsigned i = 0; i < MaxSamples; ++i)
            live[i] |= before.masks[i] & ~left.masks[i];
        touched_samples_end_ = touched_samples_end_ > index ? touched_samples_end_ : index + 1;
        if (left.any() == 0) return;
        flush();
    }
}

} // namespace ffgpu
