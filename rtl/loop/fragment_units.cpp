// Environments, colour sum, fog, coverage and alpha test.

#include "Valpha_test.h"
#include "Vapply_coverage.h"
#include "Vcolor_sum.h"
#include "Vfog.h"
#include "Vtexture_environment.h"
#include "rtl/loop/loop_stages.h"
#include "rtl/loop/quads.h"
#include "rtl/loop/unit_driver.h"

namespace ffgpu::rtl {
namespace {

struct TextureEnvironmentUnit : OneToOne<ShadeQuad> {
    static constexpr const char* Name = "texture_environment";
    using Dut = Vtexture_environment;
    using State = EnvironmentWords;
    using Input = ShadeQuad;
    using Output = ShadeQuad;
};

struct ColorSumUnit : OneToOne<ShadeQuad> {
    static constexpr const char* Name = "color_sum";
    using Dut = Vcolor_sum;
    using State = ControlWords;
    using Input = ShadeQuad;
    using Output = ShadeQuad;
};

struct FogUnit : OneToOne<ShadeQuad> {
    static constexpr const char* Name = "fog";
    using Dut = Vfog;
    using State = FogWords;
    using Input = ShadeQuad;
    using Output = Quad;
};

struct ApplyCoverageUnit : OneToOne<Quad> {
    static constexpr const char* Name = "apply_coverage";
    using Dut = Vapply_coverage;
    using State = NoState;
    using Input = Quad;
    using Output = Quad;
};

struct AlphaTestUnit : OneToOne<Quad> {
    static constexpr const char* Name = "alpha_test";
    using Dut = Valpha_test;
    using State = ControlWords;
    using Input = Quad;
    using Output = Quad;
};

std::vector<Quad> quads_of(const FragmentBatch& batch) {
    std::vector<Quad> quads;
    for (unsigned q = 0; q < batch.quad_count; ++q)
        quads.push_back(quad_of(batch, q, batch.color));
    return quads;
}

// What else a unit reads is added by `fill(shaded, i, lane of the batch)`.
template <class Fill>
std::vector<ShadeQuad>
shade_quads(const FragmentBatch& batch, const ColorPlanes& color, const Fill& fill) {
    std::vector<ShadeQuad> quads;
    for (unsigned q = 0; q < batch.quad_count; ++q) {
        quads.push_back({.quad = quad_of(batch, q, color)});
        for (unsigned i = 0; i < Lanes; ++i)
            fill(quads.back(), i, Lanes * q + i);
    }
    return quads;
}

} // namespace

void run_environment(const EnvironmentProgram& program, unsigned i, FragmentBatch& batch) {
    const auto fill = [&](ShadeQuad& shaded, unsigned at, unsigned lane) {
        shaded.primary[at] = packed_color(batch.primary, lane);
        for (unsigned unit = 0; unit < TextureUnits; ++unit)
            if ((program.sampled_units >> unit & 1) != 0)
                shaded.samples[Lanes * unit + at] = packed_color(batch.texture[unit], lane);
    };
    const auto inputs = shade_quads(batch, i == 0 ? batch.primary : batch.color, fill);
    FastFragmentStages.run_environment(program, i, batch);
    const EnvironmentWords words{program.units[i].combiner, program.sampled_units};
    take_colors(TextureEnvironmentUnit::Name,
                unit<TextureEnvironmentUnit>().run(words, inputs, bank_of(batch)),
                batch);
}

void add_secondary(FragmentBatch& batch) {
    const auto fill = [&](ShadeQuad& shaded, unsigned at, unsigned lane) {
        shaded.secondary[at] = packed_color(batch.secondary, lane);
    };
    const auto inputs = shade_quads(batch, batch.color, fill);
    FastFragmentStages.add_secondary(batch);
    const ControlWords words{{.color_sum = true}};
    take_colors(ColorSumUnit::Name, unit<ColorSumUnit>().run(words, inputs, bank_of(batch)), batch);
}

void apply_fog(const FogCurve& curve, FragmentBatch& batch) {
    const auto fill = [&](ShadeQuad& shaded, unsigned at, unsigned lane) {
        shaded.fog_coordinate[at] = batch.fog_coordinate[lane];
    };
    const auto inputs = shade_quads(batch, batch.color, fill);
    FastFragmentStages.apply_fog(curve, batch);
    take_colors(FogUnit::Name, unit<FogUnit>().run({curve}, inputs, bank_of(batch)), batch);
}

void apply_coverage(FragmentBatch& batch) {
    const auto inputs = quads_of(batch);
    FastFragmentStages.apply_coverage(batch);
    take_colors(ApplyCoverageUnit::Name, unit<ApplyCoverageUnit>().run({}, inputs), batch);
}

FragmentMask alpha_test(const FragmentControl& control, const FragmentBatch& batch) {
    const FragmentMask expected = FastFragmentStages.alpha_test(control, batch);
    loop_log().count(AlphaTestUnit::Name, "", batch.live.count());
    const auto outputs = unit<AlphaTestUnit>().run({control}, quads_of(batch), bank_of(batch));
    return take_live(AlphaTestUnit::Name, outputs, batch, expected);
}

} // namespace ffgpu::rtl
