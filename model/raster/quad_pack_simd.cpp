// The SIMD form of pack_quads: 8 or 16 quads at once, and no branch that hangs on the mask.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/quad_pack_simd.cpp"

#include "model/raster/quad_pack.h"

#include <array>
#include <bit>
#include <cstring>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX3
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
// Of half a block, which of its eight quads are covered, first to last; after them Nowhere.
constexpr std::size_t HalfQuads = BlockQuads / 2;
constexpr std::uint8_t Nowhere = 0x80; // A shuffle makes it 0.
struct alignas(8) Order {
    std::uint8_t quads[HalfQuads];
};
constexpr std::array<Order, 1 << HalfQuads> Orders = [] {
    std::array<Order, 1 << HalfQuads> all{};
    for (unsigned covered = 0; covered < all.size(); ++covered) {
        std::size_t count = 0;
        for (std::uint8_t& quad : all[covered].quads)
            quad = Nowhere;
        for (unsigned quad = 0; quad < HalfQuads; ++quad)
            if ((covered >> quad & 1) != 0)
                all[covered].quads[count++] = static_cast<std::uint8_t>(quad);
    }
    return all;
}();

// Which quads of each half have a covered lane: bits 0 to 7, and 32 to 39.
HWY_INLINE std::uint64_t covered_quads(BlockMask mask) {
    const BlockMask pairs = mask | mask >> 1;
    std::uint64_t bits = (pairs | pairs >> 2) & 0x1111111111111111;
    bits = (bits | bits >> 3) & 0x0303030303030303;
    bits = (bits | bits >> 6) & 0x000f000f000f000f;
    return (bits | bits >> 12) & 0x000000ff000000ff;
}

// The lower four bits of eight bytes in one word.
HWY_INLINE std::uint32_t join(std::uint64_t bytes) {
    bytes = (bytes | bytes >> 4) & 0x00ff00ff00ff00ff;
    bytes = (bytes | bytes >> 8) & 0x0000ffff0000ffff;
    return static_cast<std::uint32_t>(bytes | bytes >> 16);
}

PackedQuads Pack(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y) {
    const hn::FixedTag<std::uint16_t, HalfQuads> d;
    const hn::FixedTag<std::uint8_t, HalfQuads> bytes;
    const hn::FixedTag<std::uint32_t, HalfQuads / 4> words;
    const hn::FixedTag<std::uint64_t, HalfQuads / 8> whole;
    const std::uint64_t covered = covered_quads(block.mask);
    PackedQuads packed;
    for (unsigned half = 0; half < 2; ++half) {
        const auto lanes = static_cast<std::uint32_t>(block.mask >> 32 * half);
        const auto mask = static_cast<std::uint8_t>(covered >> 32 * half);
        const auto order = hn::Load(bytes, Orders[mask].quads);
        const auto quad = hn::PromoteTo(d, order);
        const auto column = hn::ShiftLeft<1>(hn::And(quad, hn::Set(d, 3)));
        const auto row = hn::ShiftLeft<1>(hn::ShiftRight<2>(quad));
        const auto top = static_cast<std::uint16_t>(block.y + BlockSize / 2 * half);
        hn::StoreU(hn::Add(column, hn::Set(d, block.x)), d, x + packed.count);
        hn::StoreU(hn::Add(row, hn::Set(d, top)), d, y + packed.count);

        constexpr std::uint32_t Lower = 0x0f0f0f0f;
        const auto even = hn::BitCast(bytes, hn::Set(words, lanes & Lower));
        const auto odd = hn::BitCast(bytes, hn::Set(words, lanes >> 4 & Lower));
        const auto inside = hn::TableLookupBytesOr0(hn::InterleaveLower(bytes, even, odd), order);
        packed.lanes |= BlockMask{join(hn::GetLane(hn::BitCast(whole, inside)))}
                        << (4 * packed.count);
        packed.count += static_cast<unsigned>(std::popcount(mask));
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

namespace {

// Chosen before any is called: a look-up a block would be felt, and so would a guard.
const PackQuads ChosenPackQuads = choose_pack_quads();

} // namespace

PackedQuads pack_quads(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y) {
    return ChosenPackQuads(block, x, y);
}

} // namespace ffgpu
#endif
