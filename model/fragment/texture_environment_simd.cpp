// Texture environments on batches, plane by plane: each channel of a unit is a loop over 16-bit
// lanes for its operation. Products are kept in units of 1/65025; sums of them saturate at 65535,
// beyond the clamp at 65025, so that 16 bits suffice for exact results.

#include "model/base/simd_targets.h"
#include "model/fragment/texture_environment.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/texture_environment_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "model/fragment/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

class PlaneReader {
public:
    PlaneReader(const PlaneArgument& argument, const FragmentBatch& batch)
        : at_(argument.step == 0
                  ? argument.constant.data()
                  : reinterpret_cast<const std::uint16_t*>(
                        reinterpret_cast<const std::byte*>(&batch) + argument.offset))
        , step_(argument.step)
        , complement_(set16(argument.complement)) {}

    HWY_INLINE V16 operator()(std::size_t lane) const {
        return hn::Xor(hn::Load(D16(), at_ + lane * step_), complement_);
    }

private:
    const std::uint16_t* at_;
    std::size_t step_;
    V16 complement_;
};

// 32512 = floor(65025 / 2): the half that signed operations subtract, less a half unit, which
// finish_signed_product makes up for.
constexpr unsigned HalfSquared = Unorm8OneSquared / 2;

// max(0, x + y - 32512), saturated, for x, y <= 65025.
HWY_INLINE V16 add_signed(V16 x, V16 y) {
    const V16 half = set16(HalfSquared);
    const V16 above = hn::SaturatedAdd(x, hn::SaturatedSub(y, half));
    return hn::SaturatedSub(above, hn::SaturatedSub(half, y));
}

HWY_INLINE V16 scale_product(V16 product, unsigned shift) {
    for (unsigned i = 0; i < shift; ++i)
        product = hn::SaturatedAdd(product, product);
    return product;
}

HWY_INLINE V16 finish_product(V16 product, unsigned shift) {
    return clamp_and_divide_by_255(scale_product(product, shift));
}

// The exact value is product - 1/2. Unscaled the half cannot change the rounding.
HWY_INLINE V16 finish_signed_product(V16 product, unsigned shift) {
    const V16 scaled = scale_product(product, shift);
    return clamp_and_divide_by_255(hn::SaturatedSub(scaled, set16((1u << shift) >> 1)));
}

HWY_INLINE V16 finish_sum(V16 sum, unsigned shift) {
    return hn::Min(hn::ShiftLeftSame(sum, static_cast<int>(shift)), set16(255));
}

template <CombineOp Op, class Arguments>
HWY_INLINE V16 evaluate(const Arguments& a, std::size_t i, unsigned shift) {
    const V16 one = set16(255);
    if constexpr (Op == CombineOp::Modulate) {
        return finish_product(hn::Mul(a[0](i), a[1](i)), shift);
    } else if constexpr (Op == CombineOp::Add) {
        return finish_sum(hn::Add(a[0](i), a[1](i)), shift);
    } else if constexpr (Op == CombineOp::AddSigned) {
        const V16 sum = hn::Add(a[0](i), a[1](i));
        const V16 doubled = hn::SaturatedSub(hn::Add(sum, sum), one);
        const V16 scaled = hn::ShiftLeftSame(doubled, static_cast<int>(shift));
        return hn::ShiftRight<1>(hn::Add(hn::Min(scaled, set16(510)), set16(1)));
    } else if constexpr (Op == CombineOp::Interpolate) {
        const V16 t = a[2](i);
        return finish_product(hn::Add(hn::Mul(a[0](i), t), hn::Mul(a[1](i), complement(t))), shift);
    } else if constexpr (Op == CombineOp::Subtract) {
        return finish_sum(hn::SaturatedSub(a[0](i), a[1](i)), shift);
    } else if constexpr (Op == CombineOp::ModulateAdd) {
        return finish_product(hn::SaturatedAdd(hn::Mul(a[0](i), a[2](i)), hn::Mul(a[1](i), one)),
                              shift);
    } else if constexpr (Op == CombineOp::ModulateSignedAdd) {
        return finish_signed_product(add_signed(hn::Mul(a[0](i), a[2](i)), hn::Mul(a[1](i), one)),
                                     shift);
    } else if constexpr (Op == CombineOp::ModulateSubtract) {
        return finish_product(hn::SaturatedSub(hn::Mul(a[0](i), a[2](i)), hn::Mul(a[1](i), one)),
                              shift);
    } else if constexpr (Op == CombineOp::AddProducts) {
        return finish_product(
            hn::SaturatedAdd(hn::Mul(a[0](i), a[1](i)), hn::Mul(a[2](i), a[3](i))), shift);
    } else if constexpr (Op == CombineOp::AddProductsSigned) {
        return finish_signed_product(
            add_signed(hn::Mul(a[0](i), a[1](i)), hn::Mul(a[2](i), a[3](i))), shift);
    } else {
        return finish_sum(a[0](i), shift);
    }
}

// `first`: which argument stands in the first one's place.
template <CombineOp Op>
void run_plane(const PlaneProgram& program,
               const FragmentBatch& batch,
               std::uint16_t* to,
               unsigned first = 0) {
    const PlaneReader arguments[4] = {{program.arguments[first], batch},
                                      {program.arguments[1], batch},
                                      {program.arguments[2], batch},
                                      {program.arguments[3], batch}};
    const unsigned lanes = batch.lanes();
    const unsigned shift = program.scale_shift;
    if (shift == 0) {
        for (unsigned i = 0; i < lanes; i += Lanes16)
            hn::Store(evaluate<Op>(arguments, i, 0), D16(), to + i);
    } else {
        for (unsigned i = 0; i < lanes; i += Lanes16)
            hn::Store(evaluate<Op>(arguments, i, shift), D16(), to + i);
    }
}

// Times one: of a white primary colour, which most textures are modulated with.
void run_modulate(const PlaneProgram& program, const FragmentBatch& batch, std::uint16_t* to) {
    const auto is_one = [&](unsigned i) {
        return (program.arguments[i].primary & batch.full_channels) != 0;
    };
    if (is_one(0)) return run_plane<CombineOp::Replace>(program, batch, to, 1);
    if (is_one(1)) return run_plane<CombineOp::Replace>(program, batch, to, 0);
    run_plane<CombineOp::Modulate>(program, batch, to);
}

void run_channel(const PlaneProgram& program, const FragmentBatch& batch, std::uint16_t* to) {
    switch (program.op) {
    case CombineOp::Modulate:
        return run_modulate(program, batch, to);
    case CombineOp::Add:
        return run_plane<CombineOp::Add>(program, batch, to);
    case CombineOp::AddSigned:
        return run_plane<CombineOp::AddSigned>(program, batch, to);
    case CombineOp::Interpolate:
        return run_plane<CombineOp::Interpolate>(program, batch, to);
    case CombineOp::Subtract:
        return run_plane<CombineOp::Subtract>(program, batch, to);
    case CombineOp::ModulateAdd:
        return run_plane<CombineOp::ModulateAdd>(program, batch, to);
    case CombineOp::ModulateSignedAdd:
        return run_plane<CombineOp::ModulateSignedAdd>(program, batch, to);
    case CombineOp::ModulateSubtract:
        return run_plane<CombineOp::ModulateSubtract>(program, batch, to);
    case CombineOp::AddProducts:
        return run_plane<CombineOp::AddProducts>(program, batch, to);
    case CombineOp::AddProductsSigned:
        return run_plane<CombineOp::AddProductsSigned>(program, batch, to);
    default:
        return run_plane<CombineOp::Replace>(program, batch, to);
    }
}

// --- Dot products: three 18-bit terms need 32-bit lanes ------------------------------------------

using DSigned32 = hn::Rebind<std::int32_t, DHalf16>;
using VSigned32 = hn::Vec<DSigned32>;

// sum((2a - 255)(2b - 255)) of one half of the lanes.
template <class Half>
HWY_INLINE VSigned32 dot_terms(const V16 (&a)[3], const V16 (&b)[3], Half&& half) {
    const DSigned32 d;
    const VSigned32 one = hn::Set(d, 255);
    const auto centred = [&](V16 value) {
        const VSigned32 wide = hn::PromoteTo(d, half(value));
        return hn::Sub(hn::Add(wide, wide), one);
    };
    VSigned32 sum = hn::Zero(d);
    for (unsigned c = 0; c < 3; ++c)
        sum = hn::Add(sum, hn::Mul(centred(a[c]), centred(b[c])));
    return sum;
}

// Of all lanes, before the scale.
struct DotProducts {
    VSigned32 lower, upper;
};

HWY_INLINE DotProducts dot_products(const V16 (&a)[3], const V16 (&b)[3]) {
    const DHalf16 dh;
    return {dot_terms(a, b, [&](V16 v) { return hn::LowerHalf(dh, v); }),
            dot_terms(a, b, [&](V16 v) { return hn::UpperHalf(dh, v); })};
}

HWY_INLINE V16 scaled(const DotProducts& dots, unsigned shift) {
    const DSigned32 d;
    const DHalf16 dh;
    const auto clamped = [&](VSigned32 sum) {
        const VSigned32 scaled = hn::ShiftLeftSame(sum, static_cast<int>(shift));
        const VSigned32 limit = hn::Set(d, static_cast<std::int32_t>(Unorm8OneSquared));
        return hn::DemoteTo(dh, hn::Max(hn::Min(scaled, limit), hn::Zero(d)));
    };
    return divide_by_255(hn::Combine(D16(), clamped(dots.upper), clamped(dots.lower)));
}

void run_dot_product(const UnitProgram& unit, FragmentBatch& batch) {
    const auto argument = [&](unsigned channel, unsigned index) {
        return PlaneReader(unit.channels[channel].arguments[index], batch);
    };
    const PlaneReader a[3] = {argument(0, 0), argument(1, 0), argument(2, 0)};
    const PlaneReader b[3] = {argument(0, 1), argument(1, 1), argument(2, 1)};
    ColorPlanes& color = batch.color;
    for (unsigned i = 0; i < batch.lanes(); i += Lanes16) {
        const V16 x[3] = {a[0](i), a[1](i), a[2](i)};
        const V16 y[3] = {b[0](i), b[1](i), b[2](i)};
        const DotProducts dots = dot_products(x, y);
        const V16 dot = scaled(dots, unit.channels[0].scale_shift);
        hn::Store(dot, D16(), color.r.data() + i);
        hn::Store(dot, D16(), color.g.data() + i);
        hn::Store(dot, D16(), color.b.data() + i);
        if (!unit.alpha_from_dot) continue;
        hn::Store(scaled(dots, unit.channels[3].scale_shift), D16(), color.a.data() + i);
    }
}

// In place: a colour channel reads its own plane and alpha planes, and alpha is written last.
void run_unit(const UnitProgram& unit, FragmentBatch& batch) {
    ColorPlanes& color = batch.color;
    if (unit.dot_product) {
        run_dot_product(unit, batch);
    } else {
        run_channel(unit.channels[0], batch, color.r.data());
        run_channel(unit.channels[1], batch, color.g.data());
        run_channel(unit.channels[2], batch, color.b.data());
    }
    if (!unit.alpha_from_dot) run_channel(unit.channels[3], batch, color.a.data());
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(run_unit);

void run_environment(const EnvironmentProgram& program, unsigned i, FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(run_unit)(program.units[i], batch);
}

} // namespace ffgpu
#endif
