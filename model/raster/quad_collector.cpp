#include "model/raster/quad_collector.h"

#include <algorithm>

namespace ffgpu {
namespace {

struct QuadOffsets {
    std::array<std::uint16_t, BlockQuads> x{}, y{};

    constexpr QuadOffsets() {
        for (unsigned q = 0; q < BlockQuads; ++q) {
            x[q] = static_cast<std::uint16_t>(q % BlockQuadsAcross * 2);
            y[q] = static_cast<std::uint16_t>(q / BlockQuadsAcross * 2);
        }
    }
};
constexpr QuadOffsets Offsets;

} // namespace

void QuadCollector::clear() {
    batch_.quad_count = 0;
    batch_.live = {};
    batch_.front_facing = {};
    run_count_ = 0;
    std::fill_n(live_.begin(), touched_end_, 0);
    touched_end_ = 0;
    std::fill_n(live_samples_.begin(), touched_samples_end_, std::array<BlockMask, MaxSamples>{});
    touched_samples_end_ = 0;
}

void QuadCollector::begin_run(const SetupRecord& record) {
    const bool same = run_count_ != 0 && runs_[run_count_ - 1].record == &record;
    // A full batch gets no further run: append() will take nothing.
    if (!same && batch_.quad_count < BatchQuads) runs_[run_count_++] = {&record, batch_.quad_count};
}

// Appends quads of `mask` while there is room; returns the part of it that is left.
BlockMask
QuadCollector::append(const BlockCoverage& block, BlockMask mask, const BlockAntialias* antialias) {
    if (!antialias && batch_.quad_count <= BatchQuads - BlockQuads) { // as many as it may have
        append_block({block.x, block.y, mask});
        return 0;
    }
    while (mask != 0 && batch_.quad_count < BatchQuads) {
        const unsigned quad = static_cast<unsigned>(std::countr_zero(mask)) / 4;
        const BlockMask bits = mask & (BlockMask{0xf} << (4 * quad));
        mask ^= bits;
        const unsigned n = append_quad(block.x + Offsets.x[quad],
                                       block.y + Offsets.y[quad],
                                       static_cast<unsigned>(bits >> (4 * quad)));
        for (unsigned lane = 0; antialias && lane < 4; ++lane)
            batch_.antialias[4 * n + lane] = (*antialias)[4 * quad + lane];
    }
    return mask;
}

// A quad of the last run's primitive with those lanes live; returns its number.
unsigned QuadCollector::append_quad(unsigned x, unsigned y, unsigned lanes) {
    const SetupRecord& record = *runs_[run_count_ - 1].record;
    const unsigned n = batch_.quad_count++;
    batch_.x[n] = static_cast<std::uint16_t>(x);
    batch_.y[n] = static_cast<std::uint16_t>(y);
    batch_.primitive[n] = record.key;
    batch_.front_facing[n / 64] |= std::uint64_t{record.front_facing} << (n % 64);
    batch_.live.words[n / 16] |= std::uint64_t{lanes} << (4 * (n % 16));
    return n;
}

// Appends quads of `block` while there is room, and takes them out of it.
void QuadCollector::append_samples(SampleBlock& block) {
    if (batch_.quad_count == 0) batch_.samples = {};
    BlockMask left = block.any();
    while (left != 0 && batch_.quad_count < BatchQuads) {
        const unsigned quad = static_cast<unsigned>(std::countr_zero(left)) / 4;
        const BlockMask lanes = BlockMask{0xf} << (4 * quad);
        const unsigned n = append_quad(block.x + Offsets.x[quad],
                                       block.y + Offsets.y[quad],
                                       static_cast<unsigned>((left & lanes) >> (4 * quad)));
        left &= ~lanes;
        for (unsigned i = 0; i < MaxSamples; ++i) {
            const BlockMask bits = (block.masks[i] & lanes) >> (4 * quad);
            batch_.samples[i].words[n / 16] |= bits << (4 * (n % 16));
            block.masks[i] &= ~lanes;
        }
    }
}

// There is room for all quads of a block.
void QuadCollector::append_block(const BlockCoverage& block) {
    const SetupRecord& record = *runs_[run_count_ - 1].record;
    const unsigned n = batch_.quad_count;
    const PackedQuads packed = pack_(block, batch_.x.data() + n, batch_.y.data() + n);
    std::fill_n(batch_.primitive.data() + n, BlockQuads, record.key);
    static_assert(BatchQuads == 64, "one word of front_facing");
    const std::uint64_t quads = (std::uint64_t{1} << packed.count) - 1;
    batch_.front_facing[0] |= (record.front_facing ? quads : 0) << n;
    const unsigned shift = 4 * (n % 16);
    batch_.live.words[n / 16] |= packed.lanes << shift;
    if (shift != 0) batch_.live.words[n / 16 + 1] |= packed.lanes >> (64 - shift);
    batch_.quad_count += packed.count;
}

} // namespace ffgpu
