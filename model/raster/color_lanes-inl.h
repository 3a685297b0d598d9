// Colours over the lanes of a run: as planes of channels, or as the words of rgba8 targets.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_RASTER_COLOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_RASTER_COLOR_LANES_INL_H
#undef FFGPU_MODEL_RASTER_COLOR_LANES_INL_H
#else
#define FFGPU_MODEL_RASTER_COLOR_LANES_INL_H
#endif

#include "model/raster/plane_lanes-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

// A colour's channel of a primitive: product * scale clamped to 0 .. 255, then floor(that + 1/2).
// As powers of two are exact, the limit is scaled instead, and product and sum are one rounding.
class ColorRounding {
public:
    explicit ColorRounding(float scale)
        : scale_(scale)
        , highest_(std::bit_cast<float>(std::bit_cast<std::uint32_t>(255.0f) +
                                        std::bit_cast<std::uint32_t>(1.0f) -
                                        std::bit_cast<std::uint32_t>(scale))) {}

    // A word of it: the integer is its lowest byte, and the bytes beside that one are 0.
    template <class V>
    HWY_INLINE auto rounded(V product) const {
        const hn::DFromV<V> d;
        const hn::RebindToUnsigned<decltype(d)> words;
        const V clamped = hn::Min(hn::Max(product, hn::Zero(d)), hn::Set(d, highest_));
        const V sum = hn::MulAdd(clamped, hn::Set(d, scale_), hn::Set(d, 0.5f));
        // With its last bit it is no integer, so that less 1/2 it is rounded as the floor is.
        const auto inside = hn::Or(hn::BitCast(words, sum), hn::Set(words, 1));
        const V shifted = hn::Add(hn::BitCast(d, inside), hn::Set(d, ToLowerBits - 0.5f));
        return hn::BitCast(words, shifted);
    }

    template <class V>
    HWY_INLINE void store(V product, std::uint16_t* plane, std::size_t lane) const {
        const hn::Rebind<std::uint16_t, hn::DFromV<V>> halves;
        store_lanes(halves, hn::TruncateTo(halves, rounded(product)), plane, lane);
    }

private:
    // Adding it leaves a small integer in the lower bits.
    static constexpr float ToLowerBits = 0x1p23f;
    float scale_, highest_;
};

// A colour whose planes stand at `first` in the layout.
template <unsigned Channels>
void color_run(const LaneRun& run,
               int first,
               const std::uint8_t* constant,
               const PerspectivePlanes& planes,
               const std::array<std::uint16_t*, Channels>& out) {
    if (constant) {
        for (std::size_t i = 0; i < Channels; ++i)
            fill_run(run, out[i], std::uint16_t{constant[i]});
        return;
    }
    const std::array<float, Channels> scales =
        scales_of<Channels>(run, static_cast<unsigned>(first));
    for_products<Channels>(run,
                           static_cast<unsigned>(first),
                           planes,
                           planes.w.data(),
                           [&](unsigned i, auto product, std::size_t lane)
                               HWY_ATTR { ColorRounding(scales[i]).store(product, out[i], lane); });
}

// Rgba8 words on their way, and 1 / w of their lanes.
template <class V>
struct ColorWords {
    using Words = hn::RebindToUnsigned<hn::DFromV<V>>;
    V w;
    hn::Vec<Words> words;

    HWY_INLINE explicit ColorWords(V over_w)
        : w(over_w)
        , words(hn::Zero(Words())) {}

    // Channels come from the first on. `value`: rounded().
    HWY_INLINE void add(unsigned channel, hn::Vec<Words> value) {
        switch (channel) {
        case 0:
            words = hn::And(value, hn::Set(Words(), 0xff));
            return;
        case 1:
            words = hn::Or(words, hn::ShiftLeft<8>(value));
            return;
        case 2:
            words = hn::Or(words, hn::ShiftLeft<16>(value));
            return;
        default:
            words = hn::Or(words, hn::ShiftLeft<24>(value));
        }
    }
};

void color_words_run(const LaneRun& run,
                     unsigned first,
                     const PerspectivePlanes& planes,
                     std::uint32_t* out) {
    const std::array<float, 4> scales = scales_of<4>(run, first);
    for_integers<4>(
        run,
        first,
        planes,
        [&](auto d, std::size_t lane)
            HWY_ATTR { return ColorWords(hn::LoadU(d, planes.w.data() + lane)); },
        [&](auto& at, unsigned i, auto integers, std::size_t lane) HWY_ATTR {
            const hn::RebindToFloat<hn::DFromV<decltype(integers)>> d;
            const hn::RebindToUnsigned<decltype(d)> words;
            const auto product = hn::Mul(hn::ConvertTo(d, integers), at.w);
            at.add(i, ColorRounding(scales[i]).rounded(product));
            if (i == 3) store_lanes(words, at.words, out, lane);
        });
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
