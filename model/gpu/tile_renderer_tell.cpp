// What a tile tells of its batches: counts, and the work that is recorded.

#include "model/gpu/tile_renderer.h"
#include "model/gpu/value_recorder.h"

#include <bit>
#include <cstddef>
#include <iterator>

namespace ffgpu {
namespace {

// Without a call: FragmentMask's own comparison is one of the library's.
bool same(const FragmentMask& a, const FragmentMask& b) {
    std::uint64_t different = 0;
    for (std::size_t i = 0; i < a.words.size(); ++i)
        different |= a.words[i] ^ b.words[i];
    return different == 0;
}

// The lanes of `mask`, most often all of the batch's. No mask of all is made: what was just stored
// by words and is loaded by vectors waits until the stores before it are done.
std::uint64_t count_lanes(const FragmentMask& mask, unsigned lanes) {
    std::uint64_t missing = 0;
    for (std::size_t i = 0; i < mask.words.size() && lanes > 64 * i; ++i) {
        const unsigned beyond =
            lanes < 64 * i + 64 ? static_cast<unsigned>(64 * i + 64 - lanes) : 0;
        missing |= ~mask.words[i] << beyond;
    }
    return missing == 0 ? lanes : mask.count();
}

// The samples of quad q: bit 4 i + s for sample s of lane i.
std::uint16_t sample_bits(const SampleMasks& samples, unsigned q) {
    unsigned bits = 0;
    for (unsigned s = 0; s < MaxSamples; ++s)
        for (unsigned lane = 0; lane < 4; ++lane)
            bits |= (samples[s].quad(q) >> lane & 1) << (4 * lane + s);
    return static_cast<std::uint16_t>(bits);
}

} // namespace

void TileRenderer::count(const FragmentMask& covered, const FragmentMask& early) {
    // Most batches lose nobody: comparing masks is quicker than counting bits.
    const auto next =
        [](std::uint64_t count, const FragmentMask& before, const FragmentMask& after) {
            return same(before, after) ? count : std::uint64_t{after.count()};
        };
    const std::uint64_t all = count_lanes(covered, batch_.lanes());
    const std::uint64_t after_early = next(all, covered, early);
    const std::uint64_t coverage = next(after_early, early, fates_.after_coverage);
    const std::uint64_t alpha = next(coverage, fates_.after_coverage, fates_.after_alpha);
    const std::uint64_t stencil = next(alpha, fates_.after_alpha, fates_.after_stencil);
    const std::uint64_t depth = next(stencil, fates_.after_stencil, fates_.after_depth);
    counts_.covered += all;
    counts_.killed_early_depth += all - after_early;
    counts_.killed_coverage += after_early - coverage;
    counts_.killed_alpha += coverage - alpha;
    counts_.killed_stencil += alpha - stencil;
    counts_.killed_depth += stencil - depth;
    counts_.written += depth;
    counts_.quads += batch_.quad_count;
    ++counts_.batches;
    if (multisampled()) return count_samples();
    if (pixels_->count_samples) counts_.counted_samples += depth;
}

// Pixels whose fragments the early depth test would end.
void TileRenderer::count_hidden(BlockMask mask) {
    ++counts_.hidden_blocks;
    if (mask == FullBlock) {
        counts_.covered += 64;
        counts_.killed_early_depth += 64;
        counts_.quads += 16;
        return;
    }
    constexpr BlockMask FirstLanes = 0x1111111111111111;
    const BlockMask pairs = mask | mask >> 1;
    const auto fragments = static_cast<unsigned>(std::popcount(mask));
    counts_.covered += fragments;
    counts_.killed_early_depth += fragments;
    counts_.quads += static_cast<unsigned>(std::popcount((pairs | pairs >> 2) & FirstLanes));
}

void TileRenderer::count_samples() {
    std::uint64_t written = 0;
    for (unsigned i = 0; i < MaxSamples; ++i) {
        counts_.samples_covered += covered_samples_[i].count();
        written += batch_.samples[i].count();
    }
    counts_.samples_written += written;
    if (pixels_->count_samples) counts_.counted_samples += written;
}

void TileRenderer::record(const FragmentMask& covered, const FragmentMask& early) {
    std::pmr::memory_resource* const memory = recording_.memory;
    const auto moved = std::make_move_iterator(footprints_.begin());
    WorkBatch& work = recording_.tile->batches.emplace_back(
        WorkBatch{.draw = command_,
                  .quads = std::pmr::vector<WorkQuad>(batch_.quad_count, memory),
                  .textures = std::pmr::vector<TexelFootprints>(
                      moved, moved + static_cast<std::ptrdiff_t>(footprints_.size()), memory),
                  .value_begin = std::pmr::vector<std::uint32_t>(memory),
                  .values = std::pmr::vector<std::uint32_t>(memory)});
    footprints_.clear();
    record_quads(covered, early, work.quads);
    record_pieces(work);
    if (!values_) return;
    SampleMasks tested;
    if (multisampled())
        tested = fates_.tested;
    else
        tested[0] = fates_.after_alpha;
    record_values({.registers = binned_->context->regs(),
                   .fragments = batch_,
                   .tested = tested,
                   .memory = memory_},
                  work);
}

// Most batches lose nobody.
void TileRenderer::record_quads(const FragmentMask& covered,
                                const FragmentMask& early,
                                std::span<WorkQuad> quads) const {
    const bool whole = same(covered, early) && same(covered, fates_.after_coverage) &&
                       same(covered, fates_.after_alpha) && same(covered, fates_.after_stencil) &&
                       same(covered, fates_.after_depth);
    const auto bits = [](const FragmentMask& mask, unsigned q) {
        return static_cast<std::uint8_t>(mask.quad(q));
    };
    for (unsigned q = 0; q < quads.size(); ++q) {
        WorkQuad& quad = quads[q];
        quad.primitive = batch_.primitive[q];
        quad.x = batch_.x[q];
        quad.y = batch_.y[q];
        quad.covered = bits(covered, q);
        if (whole) {
            quad.after_early_depth = quad.after_coverage = quad.after_alpha = quad.after_stencil =
                quad.after_depth = quad.covered;
        } else {
            quad.after_early_depth = bits(early, q);
            quad.after_coverage = bits(fates_.after_coverage, q);
            quad.after_alpha = bits(fates_.after_alpha, q);
            quad.after_stencil = bits(fates_.after_stencil, q);
            quad.after_depth = bits(fates_.after_depth, q);
        }
        if (!multisampled()) continue;
        quad.samples_covered = sample_bits(covered_samples_, q);
        quad.samples_written = sample_bits(batch_.samples, q);
    }
}

// An image is one piece: it has no runs.
void TileRenderer::record_pieces(WorkBatch& work) const {
    const std::span<const BatchRun> runs = collector_.runs();
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const std::size_t end =
            run + 1 < runs.size() ? runs[run + 1].first_quad : work.quads.size();
        for (std::size_t q = runs[run].first_quad; q < end; ++q)
            work.quads[q].piece = runs[run].record->piece;
    }
}

} // namespace ffgpu
