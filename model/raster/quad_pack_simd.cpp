// The SIMD form of pack_quads: 4 to 16 quads at once, and no branch that hangs on the mask.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/quad_pack_simd.cpp"

#include "model/raster/quad_pack.h"

#include <array>
#include <bit>
#include <cstring>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format off: after foreach_target.h
#include "model/arith/lanes/mask_bits-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Quads = hn::CappedTag<std::uint32_t, BlockQuads>; // a lane a quad
using V = hn::Vec<Quads>;

// A quad's place in its block: x in the lower half, y in the upper.
alignas(64) constexpr std::uint32_t Places[BlockQuads] = {0x00000,
                                                          0x00002,
                                                          0x00004,
                                                          0x00006,
                                                          0x20000,
                                                          0x20002,
                                                          0x20004,
                                                          0x20006,
                                                          0x40000,
                                                          0x40002,
                                                          0x40004,
                                                          0x40006,
                                                          0x60000,
                                                          0x60002,
                                                          0x60004,
                                                          0x60006};
alignas(64) constexpr std::uint32_t Shifts[BlockQuads] = {
    0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28};

// The bits of quads from `first` on.
HWY_INLINE V lanes_of(BlockMask mask, std::size_t first) {
    const Quads d;
    const V shifts = hn::Load(d, Shifts + first);
    const auto half = [&](std::size_t quad) HWY_ATTR {
        return static_cast<std::uint32_t>(mask >> (quad < 8 ? 0 : 32));
    };
    const V words = [&]() HWY_ATTR {
        if constexpr (hn::MaxLanes(d) > 8) {
            const hn::Half<Quads> eight;
            return hn::Combine(d, hn::Set(eight, half(8)), hn::Set(eight, half(0)));
        } else {
            return hn::Set(d, half(first));
        }
    }();
    return hn::And(hn::Shr(words, shifts), hn::Set(d, 0xf));
}

// Four bits of each lane in one word.
HWY_INLINE BlockMask join(V lanes) {
    const hn::Rebind<std::uint8_t, Quads> bytes;
    const hn::Repartition<std::uint16_t, decltype(bytes)> pairs;
    const hn::Rebind<std::uint8_t, decltype(pairs)> joined;
    const auto pair = hn::BitCast(pairs, hn::TruncateTo(bytes, lanes));
    std::array<std::uint8_t, hn::MaxLanes(joined)> bits;
    hn::StoreU(hn::TruncateTo(joined, hn::Or(pair, hn::ShiftRight<4>(pair))), joined, bits.data());
    BlockMask mask = 0;
    std::memcpy(&mask, bits.data(), bits.size());
    return mask;
}

#if HWY_TARGET == HWY_AVX3
// All quads in one vector, and their bits by one instruction, which where AVX-512 is takes no
// longer than a shift.
PackedQuads Pack(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y) {
    const Quads d;
    static_assert(hn::MaxLanes(Quads()) == BlockQuads);
    constexpr BlockMask FirstLanes = 0x1111111111111111;
    const hn::Rebind<std::uint16_t, Quads> halves;
    const BlockMask pairs = block.mask | block.mask >> 1;
    const BlockMask covered = (pairs | pairs >> 2) & FirstLanes;
    const auto quads = static_cast<std::uint16_t>(_pext_u64(covered, FirstLanes));
    std::uint8_t bits[sizeof quads];
    std::memcpy(bits, &quads, sizeof quads);
    const V corner = hn::Set(d, block.x | std::uint32_t{block.y} << 16);
    const V places = hn::Compress(hn::Add(corner, hn::Load(d, Places)), hn::LoadMaskBits(d, bits));
    hn::StoreU(hn::TruncateTo(halves, places), halves, x);
    hn::StoreU(hn::TruncateTo(halves, hn::ShiftRight<16>(places)), halves, y);
    return {static_cast<unsigned>(std::popcount(covered)), _pext_u64(block.mask, covered * 0xf)};
}
#else
PackedQuads Pack(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y) {
    const Quads d;
    const hn::Rebind<std::uint16_t, Quads> halves;
    const V corner = hn::Set(d, block.x | std::uint32_t{block.y} << 16);
    PackedQuads packed;
    for (std::size_t first = 0; first < BlockQuads; first += hn::Lanes(d)) {
        const V lanes = lanes_of(block.mask, first);
        const auto covered = hn::Ne(lanes, hn::Zero(d));
        const auto count = static_cast<std::size_t>(std::popcount(bits_from_mask(d, covered)));
        const V places = hn::Compress(hn::Add(corner, hn::Load(d, Places + first)), covered);
        hn::StoreU(hn::TruncateTo(halves, places), halves, x + packed.count);
        hn::StoreU(hn::TruncateTo(halves, hn::ShiftRight<16>(places)), halves, y + packed.count);
        const V inside = hn::IfThenElseZero(hn::FirstN(d, count), hn::Compress(lanes, covered));
        packed.lanes |= join(inside) << (4 * packed.count);
        packed.count += static_cast<unsigned>(count);
    }
    return packed;
}
#endif

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(Pack);

PackQuads choose_pack_quads() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(Pack);
}

PackedQuads pack_quads(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y) {
    static const PackQuads pack = choose_pack_quads(); // A look-up a block would be felt.
    return pack(block, x, y);
}

} // namespace ffgpu
#endif
