// compile_draw_state: what the stages derive from a draw's registers, once.

#include "model/packets/draw_state.h"

#include <algorithm>

namespace ffgpu {
namespace {

std::uint8_t sampled_by(const CombineHalf& half) {
    std::uint8_t units = 0;
    for (unsigned i = 0; i < argument_count(half.op); ++i)
        if (half.arguments[i].source < CombineSource::Constant)
            units |=
                static_cast<std::uint8_t>(1u << static_cast<unsigned>(half.arguments[i].source));
    return units;
}

std::uint8_t sampled_units(const Registers& registers) {
    std::uint8_t present = 0, read = 0;
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (registers.images[unit].shape.kind != TextureKind::None)
            present |= static_cast<std::uint8_t>(1u << unit);
        const Combiner& combiner = registers.combiners[unit];
        if (!combiner.enable) continue;
        read |= sampled_by(combiner.rgb);
        if (combiner.rgb.op != CombineOp::Dot3Rgba) read |= sampled_by(combiner.alpha);
    }
    return present & read;
}

// Whether q can be anything but 1 after generation and matrix.
bool q_varies(const Registers& registers, unsigned unit) {
    const TexCoordSetup& setup = registers.tex_coords[unit];
    if (setup.mode[3] != TexGenMode::Off) return true;
    const Mat4& m = setup.matrix;
    const bool keeps_q = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
    if (setup.matrix_enable && !keeps_q) return true;
    const auto attribute = static_cast<unsigned>(tex_coord(unit));
    const unsigned components = registers.vertex_format.elements[attribute].components;
    return components == 4 || (components == 0 && registers.current.values[attribute][3] != 1);
}

std::uint8_t coordinate_count(const Registers& registers, unsigned unit) {
    if (q_varies(registers, unit)) return 4;
    const TextureShape& shape = registers.images[unit].shape;
    const bool compares =
        format_info(shape.format).is_depth && registers.samplers[unit].compare_enable;
    const bool has_r = shape.kind == TextureKind::ThreeD || shape.kind == TextureKind::Cube;
    return has_r || compares ? 3 : 2;
}

InterpolantLayout compile_layout(const Registers& registers, std::uint8_t units) {
    InterpolantLayout layout;
    const auto place = [&layout](unsigned components) {
        const std::uint8_t at = layout.count;
        layout.count = static_cast<std::uint8_t>(at + components);
        return static_cast<std::int8_t>(at);
    };
    if (!uses_color(registers)) return layout;
    layout.color = place(4);
    if (registers.fragment.color_sum) layout.secondary = place(3);
    if (registers.fog.mode != FogMode::Off) layout.fog = place(1);
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (!(units >> unit & 1)) continue;
        layout.tex_components[unit] = coordinate_count(registers, unit);
        layout.tex_coord[unit] = place(layout.tex_components[unit]);
    }
    return layout;
}

bool masks_samples(const Registers& registers) {
    return registers.multisample.alpha_to_coverage || registers.multisample.sample_mask != 0xf;
}

// The depth test may come first where nothing between it and its place in the pipe can see the
// difference: a test that kills after depth was written would, and so would the stencil's
// operations and a test of the stored depth.
bool early_depth_allowed(const Registers& registers, bool multisample) {
    const DepthControl& depth = registers.depth;
    return registers.targets.depth.format != Format::None && depth.test_enable &&
           !depth.bounds_enable && !registers.stencil.enable &&
           !(depth.write_enable &&
             (registers.fragment.alpha_test || (multisample && masks_samples(registers))));
}

} // namespace

bool uses_color(const Registers& registers) {
    const auto& colors = registers.targets.color;
    const bool has_target = std::any_of(colors.begin(), colors.end(), [](const Surface& color) {
        return color.format != Format::None;
    });
    return registers.fragment.alpha_test || registers.multisample.alpha_to_coverage ||
           (has_target && registers.blend.write_mask != 0);
}

DrawState compile_draw_state(std::shared_ptr<const Registers> registers, std::uint32_t number) {
    const Registers& r = *registers;
    DrawState state;
    state.number = number;
    state.units = uses_color(r) ? sampled_units(r) : std::uint8_t{0};
    state.layout = compile_layout(r, state.units);
    state.samples = static_cast<std::uint8_t>(r.targets.samples());
    state.multisample = state.samples > 1 && r.multisample.enable;
    state.early_depth = early_depth_allowed(r, state.multisample);
    state.needs_depth = r.targets.depth.format != Format::None && r.depth.test_enable;
    state.antialias = !state.multisample && (r.primitive.polygon_smooth ||
                                             r.primitive.line_smooth || r.primitive.point_smooth);
    state.registers = std::move(registers);
    return state;
}

} // namespace ffgpu
