#include "model/gpu/hidden_blocks.h"

#include "model/gpu/block_depths.h"

#include <algorithm>

namespace ffgpu {
namespace {

// Whether draws that pass a test by these registers leave no depth farther than it was.
bool brings_nearer(const DepthControl& depth) {
    return !depth.test_enable || !depth.write_enable || depth.compare == Compare::Never ||
           depth.compare == Compare::Less || depth.compare == Compare::Equal ||
           depth.compare == Compare::Lequal;
}

// Not of a sane program.
bool share_memory(const Surface& a, const Surface& b) {
    return a.address < b.address + b.bytes() && b.address < a.address + a.bytes();
}

// Steeper planes leave the range of their numbers within a block.
bool is_steep(std::int64_t step) {
    constexpr std::int64_t Limit = std::int64_t{1} << 58;
    return step > Limit || step < -Limit;
}

// The least depth that the plane has in a block: at one of its corners.
std::uint32_t nearest_in(const SetupRecord& record, const BlockCoverage& block) {
    const DepthPlane& plane = record.depth;
    if (is_steep(plane.dx) || is_steep(plane.dy)) return record.depth_min;
    constexpr int Last = BlockSize - 1;
    constexpr auto Half = std::int64_t{1} << (DepthPlane::FractionBits - 1);
    const std::int64_t corner = plane.at(block.x + (plane.dx < 0 ? Last : 0) - record.x_reference,
                                         block.y + (plane.dy < 0 ? Last : 0) - record.y_reference);
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(
        (corner + Half) >> DepthPlane::FractionBits, record.depth_min, record.depth_max));
}

} // namespace

void HiddenBlocks::begin_tile(const Rectangle& tile) {
    tile_ = tile;
    tells_ = false;
    forget();
}

void HiddenBlocks::begin_draws(const FragmentPipe& pipe) {
    const DepthControl& depth = pipe.stencil_depth.depth;
    bool alone = pipe.samples == 1;
    for (const ColorTarget& color : pipe.color_targets)
        alone &= !share_memory(color.surface, pipe.depth_target);
    if (!alone || !brings_nearer(depth) || pipe.depth_target != target_) forget();
    target_ = pipe.depth_target;
    equal_passes_ = depth.compare == Compare::Lequal;
    tells_ = alone && pipe.early_depth && (depth.compare == Compare::Less || equal_passes_);
}

bool HiddenBlocks::hides(const SetupRecord& record, const BlockCoverage& block) {
    const unsigned x = block.x - static_cast<unsigned>(tile_.x0);
    const unsigned y = block.y - static_cast<unsigned>(tile_.y0);
    const std::size_t index = y / BlockSize * BlocksAcross + x / BlockSize;
    const bool is_full = block.mask == FullBlock;
    Bound& bound = bounds_[index];
    if (!known_[index]) {
        if (!is_full) return false;
        bound = {};
        known_.set(index);
    }
    const std::uint32_t nearest = nearest_in(record, block);
    const auto all_fail = [&] {
        return equal_passes_ ? nearest > bound.farthest : nearest >= bound.farthest;
    };
    if (all_fail()) return true;
    if (!is_full) return false;
    if (bound.wait > 0) {
        --bound.wait;
        return false;
    }
    bound.farthest = farthest_depth(target_, block.x, block.y, memory_); // All are covered.
    if (all_fail()) {
        bound.failures = 0;
        return true;
    }
    constexpr std::uint8_t MostFailures = 6;
    bound.wait = static_cast<std::uint8_t>((1u << bound.failures) - 1);
    bound.failures = std::min<std::uint8_t>(bound.failures + 1, MostFailures);
    return false;
}

} // namespace ffgpu
