// StoredPlane: an attribute plane as records keep it, in the parts that the interpolator works
// with, in 32 bytes. Steps stand as pairs, that in x in the lower half and that in y in the upper:
// a pair times a pixel's (x, y), of 16 bits each, is one multiply-add.

#pragma once

#include "model/packets/interpolants.h"
#include "model/raster/attribute_plane.h"

#include <bit>
#include <cstdint>

namespace ffgpu {

struct alignas(16) StoredPlane {
    // Bits of a step in `low` and `middle`, so that sums of products fit 32 bits; `high` has the
    // 16 above, with the sign. |step| is below 2^44: a lane two pixels away still fits.
    static constexpr int LowBits = AttributePlane::GuardBits, MiddleBits = 15;
    static constexpr std::uint32_t LowMask = (1u << LowBits) - 1,
                                   MiddleMask = (1u << MiddleBits) - 1;
    // The guard bits of c + Half stand above the scale's exponent, which is 15 bits below its place
    // in a binary32: a shift drops each to have the other.
    static constexpr int FractionShift = 32 - LowBits, ScaleShift = 15;

    std::uint32_t fraction_and_scale = 0;
    std::int32_t whole = 0; // of c + Half, without guard bits
    std::uint32_t low = 0, middle = 0;
    std::uint32_t high = 0;
    std::int32_t right = 0, up = 0, diagonal = 0; // AttributePlane::lane_offsets()

    StoredPlane() = default;
    explicit StoredPlane(const AttributePlane& plane)
        : fraction_and_scale(part(plane.c + AttributePlane::Half, 0, LowMask) << FractionShift |
                             std::bit_cast<std::uint32_t>(plane.scale) >> ScaleShift)
        , whole(static_cast<std::int32_t>((plane.c + AttributePlane::Half) >> LowBits))
        , low(pair(plane, 0, LowMask))
        , middle(pair(plane, LowBits, MiddleMask))
        , high(pair(plane, LowBits + MiddleBits, 0xffff))
        , right(plane.lane_offsets()[1])
        , up(plane.lane_offsets()[2])
        , diagonal(plane.lane_offsets()[3]) {}

    float scale() const { return std::bit_cast<float>(fraction_and_scale << ScaleShift); }
    AttributePlane plane() const {
        const std::int64_t c =
            std::int64_t{whole} * (1 << LowBits) + (fraction_and_scale >> FractionShift);
        return {c - AttributePlane::Half, step(0), step(16), scale()};
    }

private:
    static std::uint32_t part(std::int64_t value, int from, std::uint32_t mask) {
        return static_cast<std::uint32_t>(value >> from) & mask;
    }
    static std::uint32_t pair(const AttributePlane& plane, int from, std::uint32_t mask) {
        return part(plane.dx, from, mask) | part(plane.dy, from, mask) << 16;
    }
    std::int64_t step(int half) const {
        const auto top = static_cast<std::int16_t>(high >> half);
        const std::int64_t upper =
            std::int64_t{top} * (1 << MiddleBits) + (middle >> half & MiddleMask);
        return upper * (1 << LowBits) + (low >> half & LowMask);
    }
};
static_assert(sizeof(StoredPlane) == 32);

// Set-up writes a primitive's planes by vectors of up to 8: this many behind each other may change.
constexpr unsigned PlaneRoom = (MaxInterpolants + 1 + 7) & ~7u;

} // namespace ffgpu
