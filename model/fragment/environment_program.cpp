// Compiles combiners into plane programs: which plane or constant each argument reads.

#include "model/fragment/texture_environment.h"

#include <algorithm>

namespace ffgpu {
namespace {

struct Source {
    const ColorPlanes* planes = nullptr; // within `batch`, or null:
    PixelColor constant{};
};

// Only the places of its members matter.
const FragmentBatch& batch_layout() {
    static const FragmentBatch batch{};
    return batch;
}

Source resolve(CombineSource source,
               const Combiner& combiner,
               std::uint8_t sampled_units,
               const ColorPlanes& previous) {
    const auto index = static_cast<unsigned>(source);
    if (index < TextureUnits) {
        if ((sampled_units >> index & 1) == 0) return {.constant = UnsampledTexture};
        return {.planes = &batch_layout().texture[index]};
    }
    switch (source) {
    case CombineSource::Constant:
        return {.constant = unpack_rgba8(combiner.constant)};
    case CombineSource::Primary:
        return {.planes = &batch_layout().primary};
    case CombineSource::Previous:
        return {.planes = &previous};
    case CombineSource::One:
        return {.constant = {255, 255, 255, 255}};
    default:
        return {};
    }
}

const std::uint16_t* channel_plane(const ColorPlanes& planes, unsigned channel) {
    const std::uint16_t* of[] = {
        planes.r.data(), planes.g.data(), planes.b.data(), planes.a.data()};
    return of[channel];
}

PlaneArgument
compile_argument(const Source& source, CombineOperand operand, unsigned result_channel) {
    const bool alpha = operand == CombineOperand::Alpha || operand == CombineOperand::OneMinusAlpha;
    const bool complement =
        operand == CombineOperand::OneMinusColor || operand == CombineOperand::OneMinusAlpha;
    const unsigned channel = alpha ? 3 : result_channel;
    PlaneArgument argument;
    argument.complement = complement ? 255 : 0;
    if (source.planes == nullptr) {
        argument.constant.fill(source.constant[channel]);
    } else {
        const auto* plane =
            reinterpret_cast<const std::byte*>(channel_plane(*source.planes, channel));
        argument.offset =
            static_cast<std::uint32_t>(plane - reinterpret_cast<const std::byte*>(&batch_layout()));
        argument.step = 1;
        if (source.planes == &batch_layout().primary && !complement)
            argument.primary = static_cast<std::uint8_t>(1u << channel);
    }
    return argument;
}

void compile_unit(const Combiner& combiner,
                  std::uint8_t sampled_units,
                  const ColorPlanes& previous,
                  UnitProgram& unit) {
    unit.combiner = combiner;
    unit.alpha_from_dot = combiner.rgb.op == CombineOp::Dot3Rgba;
    unit.dot_product = unit.alpha_from_dot || combiner.rgb.op == CombineOp::Dot3Rgb;
    for (unsigned channel = 0; channel < 4; ++channel) {
        const CombineHalf& half = channel == 3 ? combiner.alpha : combiner.rgb;
        PlaneProgram& program = unit.channels[channel];
        program.op = half.op;
        program.scale_shift = std::min<std::uint8_t>(half.scale_shift, 2);
        for (unsigned i = 0; i < half.arguments.size(); ++i) {
            const CombineArgument& argument = half.arguments[i];
            program.arguments[i] =
                compile_argument(resolve(argument.source, combiner, sampled_units, previous),
                                 argument.operand,
                                 channel);
        }
    }
}

} // namespace

EnvironmentProgram compile_environments(std::span<const Combiner, TextureUnits> combiners,
                                        std::uint8_t sampled_units) {
    EnvironmentProgram program;
    program.sampled_units = sampled_units;
    const auto enabled = std::count_if(combiners.begin(),
                                       combiners.end(),
                                       [](const Combiner& combiner) { return combiner.enable; });
    program.units.reserve(static_cast<std::size_t>(enabled));
    for (const Combiner& combiner : combiners) {
        if (!combiner.enable) continue;
        const ColorPlanes& previous =
            program.units.empty() ? batch_layout().primary : batch_layout().color;
        UnitProgram& unit = program.units.emplace_back();
        compile_unit(combiner, sampled_units, previous, unit);
        unit.unit = static_cast<std::uint8_t>(&combiner - combiners.data());
    }
    return program;
}

} // namespace ffgpu
