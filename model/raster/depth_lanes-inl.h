// The exact depth plane over the lanes of a run: the corners of 2 to 8 quads at once, a lane a
// quad, then their lanes, all modulo 2^64. Included once for each instruction set.

#if defined(FFGPU_MODEL_RASTER_DEPTH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_RASTER_DEPTH_LANES_INL_H
#undef FFGPU_MODEL_RASTER_DEPTH_LANES_INL_H
#else
#define FFGPU_MODEL_RASTER_DEPTH_LANES_INL_H
#endif

#include "model/raster/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {
using Longs = hn::CappedTag<std::int64_t, 8>;
using VL = hn::Vec<Longs>;

alignas(64) constexpr std::array<std::int64_t, 32> LongQuadOfLane =
    quad_of_lane<std::int64_t, 32>();

// A plane's step in one direction, for products with pixels' places.
class DepthStep {
public:
    explicit HWY_INLINE DepthStep(std::int64_t step) {
        const auto low = static_cast<std::int32_t>(step);
        low_ = spread(low);
        high_ = spread((step - low) >> 32);
    }
    // Of places of 32 bits with their sign.
    HWY_INLINE VL times(VL places) const {
        const hn::Repartition<std::int32_t, Longs> d;
        const auto at = hn::BitCast(d, places);
        return hn::Add(hn::ShiftLeft<32>(hn::MulEven(high_, at)), hn::MulEven(low_, at));
    }

private:
    using Halfs = hn::Repartition<std::int32_t, Longs>;
    static HWY_INLINE hn::Vec<Halfs> spread(std::int64_t half) {
        return hn::BitCast(Halfs(), hn::Set(Longs(), half));
    }
    hn::Vec<Halfs> low_, high_;
};

// The places of quads from `quad` on, from the reference pixel.
HWY_INLINE VL load_places(const std::uint16_t* places, std::size_t quad, int reference) {
    const hn::Rebind<std::uint16_t, Longs> narrow;
    const hn::Rebind<std::int32_t, Longs> wider;
    const auto at = hn::PromoteTo(wider, hn::LoadU(narrow, places + quad));
    return hn::PromoteTo(Longs(), hn::Sub(at, hn::Set(wider, reference)));
}

// Of two quads' lanes those of the right column, and of the upper row.
alignas(64) constexpr std::array<std::int64_t, 8> RightLanes{0, -1, 0, -1, 0, -1, 0, -1};
alignas(64) constexpr std::array<std::int64_t, 8> UpperLanes{0, 0, -1, -1, 0, 0, -1, -1};

// What the lanes of a run's depth plane share.
struct DepthLanes {
    static constexpr std::size_t N = hn::MaxLanes(Longs());
    using Words = hn::Repartition<std::uint32_t, Longs>;

    VL dx, dy, lowest, highest;

    HWY_INLINE explicit DepthLanes(const SetupRecord& record)
        : dx(hn::Set(Longs(), record.depth.dx))
        , dy(hn::Set(Longs(), record.depth.dy))
        , lowest(hn::Set(Longs(), std::int64_t{record.depth_min}))
        , highest(hn::Set(Longs(), std::int64_t{record.depth_max})) {}
    // From a quad's corner to lanes part N and on.
    HWY_INLINE VL offsets(std::size_t part) const {
        const Longs d;
        const std::size_t lane = part * N % 4;
        return hn::Add(hn::And(dx, hn::LoadU(d, RightLanes.data() + lane)),
                       hn::And(dy, hn::LoadU(d, UpperLanes.data() + lane)));
    }
    // The values of lanes part N and on, each in the lower half of its 64 bits.
    HWY_INLINE hn::Vec<Words> values(VL corners, std::size_t part) const {
        const Longs d;
        const auto quads = hn::SetTableIndices(d, LongQuadOfLane.data() + part * N);
        const auto sum = hn::Add(hn::TableLookupLanes(corners, quads), offsets(part));
        const auto depth = hn::ShiftRight<DepthPlane::FractionBits>(sum);
        return hn::BitCast(Words(), hn::Min(hn::Max(depth, lowest), highest));
    }
};

HWY_INLINE void depth_run(SubPixelPoint position,
                          const LaneRun& run,
                          const FragmentBatch& batch,
                          std::uint32_t* out) {
    constexpr std::size_t N = DepthLanes::N;
    const Longs d;
    const DepthLanes::Words words;
    const SetupRecord& record = run.record;
    const DepthPlane& plane = record.depth;
    constexpr auto Half = std::int64_t{1} << (DepthPlane::FractionBits - 1);
    if ((plane.dx | plane.dy) == 0) { // What faces the eye, and all of a flat picture.
        const auto depth = (plane.origin + Half) >> DepthPlane::FractionBits;
        const auto value = std::clamp<std::int64_t>(depth, record.depth_min, record.depth_max);
        return fill_run(run, out, static_cast<std::uint32_t>(value));
    }
    const auto origin = hn::Set(d, plane.origin + Half + plane.beside(position));
    const DepthStep dx(plane.dx), dy(plane.dy);
    const DepthLanes lanes(record);
    for (std::size_t first = run.first; first < run.end; first += 4 * N) {
        const VL x = load_places(batch.x.data(), first / 4, record.x_reference);
        const VL y = load_places(batch.y.data(), first / 4, record.y_reference);
        const VL corners = hn::Add(origin, hn::Add(dx.times(x), dy.times(y)));
        for (std::size_t part = 0; part < 4; part += 2) {
            const std::size_t lane = first + part * N;
            if (lane >= run.end) break;
            const auto values = lanes.values(corners, part);
            if (run.end - lane <= N) {
                const hn::Rebind<std::uint32_t, Longs> narrow;
                const auto longs = hn::BitCast(hn::RebindToUnsigned<Longs>(), values);
                store_lanes(narrow, hn::TruncateTo(narrow, longs), out, lane);
                break;
            }
            const auto next = lanes.values(corners, part + 1);
            store_lanes(words, hn::ConcatEven(words, next, values), out, lane);
        }
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
