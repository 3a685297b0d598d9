// The operations of scalar_lanes.h over Highway's vectors, for the instruction set being compiled.
// No fused multiply-add, no approximate reciprocals: each lane has the scalar form's bits.

#if HWY_TARGET == HWY_SCALAR

namespace ffgpu::HWY_NAMESPACE {
using namespace scalar_lanes;
} // namespace ffgpu::HWY_NAMESPACE

#else

namespace ffgpu::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntegerTag = hn::RebindToSigned<FloatTag>;
constexpr FloatTag FloatLanes{};
constexpr IntegerTag IntegerLanes{};
constexpr unsigned LaneCount = static_cast<unsigned>(hn::MaxLanes(FloatLanes));

struct Floats {
    hn::Vec<FloatTag> value;
};
struct Integers {
    hn::Vec<IntegerTag> value;
};
struct Mask {
    hn::Mask<FloatTag> value;
};

inline Floats splat(float x) {
    return {hn::Set(FloatLanes, x)};
}
inline Integers splat_integer(std::int32_t x) {
    return {hn::Set(IntegerLanes, x)};
}
inline Floats load(const float* from) {
    return {hn::Load(FloatLanes, from)};
}
inline void store(Floats x, float* to) {
    hn::Store(x.value, FloatLanes, to);
}
inline void store_integers(Integers x, std::uint32_t* to) {
    hn::Store(x.value, IntegerLanes, reinterpret_cast<std::int32_t*>(to));
}

inline Floats operator+(Floats a, Floats b) {
    return {hn::Add(a.value, b.value)};
}
inline Floats operator-(Floats a, Floats b) {
    return {hn::Sub(a.value, b.value)};
}
inline Floats operator*(Floats a, Floats b) {
    return {hn::Mul(a.value, b.value)};
}
inline Floats operator/(Floats a, Floats b) {
    return {hn::Div(a.value, b.value)};
}
inline Floats negate(Floats a) {
    return {hn::Neg(a.value)};
}
inline Floats square_root(Floats a) {
    return {hn::Sqrt(a.value)};
}
inline Floats absolute(Floats a) {
    return {hn::Abs(a.value)};
}

inline Mask operator<(Floats a, Floats b) {
    return {hn::Lt(a.value, b.value)};
}
inline Mask operator>(Floats a, Floats b) {
    return {hn::Gt(a.value, b.value)};
}
inline Mask operator>=(Floats a, Floats b) {
    return {hn::Ge(a.value, b.value)};
}
inline Mask operator==(Floats a, Floats b) {
    return {hn::Eq(a.value, b.value)};
}
inline Mask operator&(Mask a, Mask b) {
    return {hn::And(a.value, b.value)};
}
inline Mask operator|(Mask a, Mask b) {
    return {hn::Or(a.value, b.value)};
}
inline Mask operator!(Mask a) {
    return {hn::Not(a.value)};
}
inline bool any(Mask a) {
    return !hn::AllFalse(FloatLanes, a.value);
}

inline Floats select(Mask mask, Floats yes, Floats no) {
    return {hn::IfThenElse(mask.value, yes.value, no.value)};
}
inline Floats zero_unless(Mask mask, Floats yes) {
    return {hn::IfThenElseZero(mask.value, yes.value)};
}
inline Integers zero_unless(Mask mask, Integers yes) {
    return {hn::IfThenElseZero(hn::RebindMask(IntegerLanes, mask.value), yes.value)};
}

// x86's own instructions return the second operand where one is NaN; Arm's do not.
inline Floats minimum(Floats a, Floats b) {
#if HWY_ARCH_X86
    return {hn::Min(a.value, b.value)};
#else
    return select(a < b, a, b);
#endif
}
inline Floats maximum(Floats a, Floats b) {
#if HWY_ARCH_X86
    return {hn::Max(a.value, b.value)};
#else
    return select(a > b, a, b);
#endif
}

inline Integers operator+(Integers a, Integers b) {
    return {hn::Add(a.value, b.value)};
}
inline Integers operator-(Integers a, Integers b) {
    return {hn::Sub(a.value, b.value)};
}
inline Integers operator&(Integers a, Integers b) {
    return {hn::And(a.value, b.value)};
}
inline Integers operator|(Integers a, Integers b) {
    return {hn::Or(a.value, b.value)};
}
template <int Bits>
Integers shift_left(Integers a) {
    return {hn::ShiftLeft<Bits>(a.value)};
}
template <int Bits>
Integers shift_right(Integers a) {
    return {hn::ShiftRight<Bits>(a.value)};
}

inline Integers bits_of(Floats a) {
    return {hn::BitCast(IntegerLanes, a.value)};
}
inline Floats from_bits(Integers a) {
    return {hn::BitCast(FloatLanes, a.value)};
}
inline Floats to_floats(Integers a) {
    return {hn::ConvertTo(FloatLanes, a.value)};
}
inline Floats gather(const float* table, Integers at) {
    return {hn::GatherIndex(FloatLanes, table, at.value)};
}

// Four planes, from lane `first` on, become four words in each of LaneCount rows: 4x4 transposes.
inline void
store_rows(const std::array<const float*, 4>& planes, std::byte* row, std::size_t row_bytes) {
    using Tag = hn::FixedTag<std::uint32_t, 4>;
    using WideTag = hn::Repartition<std::uint64_t, Tag>;
    constexpr Tag Four{};
    constexpr WideTag Two{};
    const auto word = [&](const float* from) {
        return hn::Load(Four, reinterpret_cast<const std::uint32_t*>(from));
    };
    for (unsigned lane = 0; lane < LaneCount; lane += 4, row += 4 * row_bytes) {
        const auto a = word(planes[0] + lane), b = word(planes[1] + lane);
        const auto c = word(planes[2] + lane), d = word(planes[3] + lane);
        const auto ab_low = hn::BitCast(Two, hn::InterleaveLower(Four, a, b));
        const auto ab_high = hn::BitCast(Two, hn::InterleaveUpper(Four, a, b));
        const auto cd_low = hn::BitCast(Two, hn::InterleaveLower(Four, c, d));
        const auto cd_high = hn::BitCast(Two, hn::InterleaveUpper(Four, c, d));
        const auto put = [&](unsigned n, auto value) {
            hn::StoreU(hn::BitCast(Four, value),
                       Four,
                       reinterpret_cast<std::uint32_t*>(row + n * row_bytes));
        };
        put(0, hn::InterleaveLower(Two, ab_low, cd_low));
        put(1, hn::InterleaveUpper(Two, ab_low, cd_low));
        put(2, hn::InterleaveLower(Two, ab_high, cd_high));
        put(3, hn::InterleaveUpper(Two, ab_high, cd_high));
    }
}

} // namespace ffgpu::HWY_NAMESPACE

#endif
