// A faster way to the texels of lanes that lie close together, as those of neighbouring pixels do:
// the rows that they lie in are loaded whole, and each lane picks its texel from them. A gather
// costs a load for each lane; the texels are the same.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_TEXEL_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_TEXEL_WINDOW_INL_H
#undef FFGPU_MODEL_TEXTURE_TEXEL_WINDOW_INL_H
#else
#define FFGPU_MODEL_TEXTURE_TEXEL_WINDOW_INL_H
#endif

#include "model/texture/axis-inl.h"
#include "model/texture/texture_unit.h"

#include <algorithm>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

// One level of a 2-D image of 32-bit texels.
struct TexelRows {
    const std::byte* first;
    std::size_t stride; // bytes
    std::int32_t width, height;
};

HWY_INLINE TexelRows texel_rows(const TextureUnit& unit, std::int32_t level) {
    const auto at = static_cast<std::size_t>(level);
    return {unit.texels + unit.levels.offset[at],
            unit.levels.row_stride[at],
            std::max(unit.size[0] >> level, 1),
            std::max(unit.size[1] >> level, 1)};
}

// The places that the lanes read: texel (x, y) of these.
struct FourTexels {
    VI x0, x1, y0, y1;
};

class TexelWindow {
public:
    static constexpr std::int32_t Width = static_cast<std::int32_t>(hn::MaxLanes(DU()));
    static constexpr std::int32_t MostRows = 4;
    // Shorter vectors hold too little of a row.
    static constexpr bool IsUseful = Width >= 8;

    // False where the lanes' texels do not lie in one window, or the rows are shorter than it.
    HWY_INLINE bool place(const TexelRows& rows, const FourTexels& texels) {
        if (rows.width < Width) return false;
        const std::int32_t left =
            std::min(least_of(hn::Min(texels.x0, texels.x1)), rows.width - Width);
        const std::int32_t top = least_of(hn::Min(texels.y0, texels.y1));
        at_ = {hn::Sub(texels.x0, constant(left)),
               hn::Sub(texels.x1, constant(left)),
               hn::Sub(texels.y0, constant(top)),
               hn::Sub(texels.y1, constant(top))};
        const VI right = hn::Max(at_.x0, at_.x1), bottom = hn::Max(at_.y0, at_.y1);
        const MI fits = hn::And(hn::Lt(right, constant(Width)), hn::Lt(bottom, constant(MostRows)));
        if (!hn::AllTrue(DI(), fits)) return false;
        two_rows_ = hn::AllTrue(DI(), hn::Lt(bottom, constant(2)));
        for (std::int32_t row = 0; row < (two_rows_ ? 2 : MostRows); ++row)
            rows_[static_cast<std::size_t>(row)] =
                load(rows, left, std::min(top + row, rows.height - 1));
        return true;
    }

    HWY_INLINE VU upper_left() const { return pick(at_.x0, at_.y0); }
    HWY_INLINE VU upper_right() const { return pick(at_.x1, at_.y0); }
    HWY_INLINE VU lower_left() const { return pick(at_.x0, at_.y1); }
    HWY_INLINE VU lower_right() const { return pick(at_.x1, at_.y1); }

private:
    static HWY_INLINE std::int32_t least_of(VI lanes) {
        return hn::GetLane(hn::MinOfLanes(DI(), lanes));
    }
    static HWY_INLINE VU load(const TexelRows& rows, std::int32_t x, std::int32_t y) {
        const std::byte* const row = rows.first + static_cast<std::size_t>(y) * rows.stride;
        return hn::LoadU(DU(), reinterpret_cast<const std::uint32_t*>(row) + x);
    }
    HWY_INLINE VU pick(VI x, VI y) const {
        const auto index = hn::IndicesFromVec(DU(), x);
        const auto of_pair = [&](std::size_t upper) {
            return hn::IfThenElse(hn::RebindMask(DU(), hn::TestBit(y, constant(1))),
                                  hn::TableLookupLanes(rows_[upper + 1], index),
                                  hn::TableLookupLanes(rows_[upper], index));
        };
        if (two_rows_) return of_pair(0);
        return hn::IfThenElse(
            hn::RebindMask(DU(), hn::TestBit(y, constant(2))), of_pair(2), of_pair(0));
    }

    VU rows_[MostRows];
    FourTexels at_; // in the window
    bool two_rows_ = false;
};

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
