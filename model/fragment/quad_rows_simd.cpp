#include "model/base/simd_targets.h"
#include "model/fragment/quad_rows.h"

#include <array>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/quad_rows_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

// A vector holds one, two or four quads.
using D = hn::CappedTag<std::uint32_t, 4 * RowQuads>;
using DHalf = hn::Half<D>;
constexpr unsigned Lanes = hn::MaxLanes(D());

// The lanes of a vector's quads in the order of its rows, the lower one first; and back.
struct Orders {
    alignas(64) std::array<std::int32_t, Lanes> to_rows{}, to_quads{};
};

constexpr Orders make_orders() {
    Orders orders;
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        const unsigned quad = lane / 4, upper = lane / 2 % 2, right = lane % 2;
        const unsigned place = upper * (Lanes / 2) + 2 * quad + right;
        orders.to_rows[place] = static_cast<std::int32_t>(lane);
        orders.to_quads[lane] = static_cast<std::int32_t>(place);
    }
    return orders;
}

constexpr Orders Order = make_orders();

template <class Byte>
auto* words(Byte* bytes) {
    using Word = std::conditional_t<std::is_const_v<Byte>, const std::uint32_t, std::uint32_t>;
    return reinterpret_cast<Word*>(bytes);
}

HWY_INLINE void load_vector(const std::byte* lower, std::size_t stride, std::uint32_t* pixels) {
    const D d;
    const DHalf half;
    const auto rows =
        hn::Combine(d, hn::LoadU(half, words(lower + stride)), hn::LoadU(half, words(lower)));
    hn::StoreU(
        hn::TableLookupLanes(rows, hn::SetTableIndices(d, Order.to_quads.data())), d, pixels);
}

HWY_INLINE void store_vector(std::byte* lower, std::size_t stride, const std::uint32_t* pixels) {
    const D d;
    const DHalf half;
    const auto rows =
        hn::TableLookupLanes(hn::LoadU(d, pixels), hn::SetTableIndices(d, Order.to_rows.data()));
    hn::StoreU(hn::LowerHalf(half, rows), half, words(lower));
    hn::StoreU(hn::UpperHalf(half, rows), half, words(lower + stride));
}

// Quads one by one: two pixels of each row.
void load_quad(const std::byte* lower, std::size_t stride, std::uint32_t* pixels) {
    std::memcpy(pixels, lower, 8);
    std::memcpy(pixels + 2, lower + stride, 8);
}

void store_quad(std::byte* lower, std::size_t stride, const std::uint32_t* pixels) {
    std::memcpy(lower, pixels, 8);
    std::memcpy(lower + stride, pixels + 2, 8);
}

void load(const PixelRows<const std::byte>& from,
          const FragmentBatch& batch,
          std::uint32_t* pixels) {
    for (unsigned q = 0; q < batch.quad_count;) {
        const std::byte* const lower = from.of_quad(batch, q);
        if (q + RowQuads > batch.quad_count || !is_row(batch, q)) {
            load_quad(lower, from.stride, pixels + 4 * q++);
            continue;
        }
        for (unsigned lane = 0; lane < 4 * RowQuads; lane += Lanes)
            load_vector(lower + 2 * lane, from.stride, pixels + 4 * q + lane);
        q += RowQuads;
    }
}

void store(const PixelRows<std::byte>& to,
           const FragmentBatch& batch,
           const std::uint32_t* pixels) {
    for (unsigned q = 0; q < batch.quad_count;) {
        std::byte* const lower = to.of_quad(batch, q);
        if (q + RowQuads > batch.quad_count || !is_row(batch, q)) {
            store_quad(lower, to.stride, pixels + 4 * q++);
            continue;
        }
        for (unsigned lane = 0; lane < 4 * RowQuads; lane += Lanes)
            store_vector(lower + 2 * lane, to.stride, pixels + 4 * q + lane);
        q += RowQuads;
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {
HWY_EXPORT(load);
HWY_EXPORT(store);
} // namespace

void load_rows(const PixelRows<const std::byte>& from,
               const FragmentBatch& batch,
               std::uint32_t* pixels) {
    HWY_DYNAMIC_DISPATCH(load)(from, batch, pixels);
}

void store_rows(const PixelRows<std::byte>& to,
                const FragmentBatch& batch,
                const std::uint32_t* pixels) {
    HWY_DYNAMIC_DISPATCH(store)(to, batch, pixels);
}

} // namespace ffgpu
#endif
