#include "tools/explain/fragment_text.h"

#include "model/memory/pixel_format.h"
#include "tools/explain/history_facts.h"
#include "tools/explain/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ffgpu::tools {
namespace {

std::string vertex_text(const WindowVertex& vertex,
                        std::size_t number,
                        const std::vector<std::string>& attributes) {
    constexpr double Pixel = 1 << SubPixelBits;
    std::string text = fmt::format("     vertex {}: ({}, {}), depth {}, 1/w {}",
                                   number,
                                   vertex.x / Pixel,
                                   vertex.y / Pixel,
                                   vertex.depth,
                                   vertex.inverse_w);
    for (std::size_t i = 0; i < attributes.size(); ++i)
        text += fmt::format(", {} {}", attributes[i], vertex.attributes[i]);
    return text + '\n';
}

std::string sample_text(unsigned bits) {
    return fmt::format("{:04b}", bits);
}

// Values before the division by w, in the scale of the record that set-up made.
template <class Values>
std::string over_w_text(const Values& values, std::size_t count) {
    return fmt::format("over w {}", fmt::join(values.begin(), values.begin() + count, ", "));
}

std::string interpolated_text(const FragmentNote& fragment) {
    std::string text;
    if (fragment.depth) text += fmt::format("   depth {}\n", *fragment.depth);
    if (!fragment.sample_depths.empty())
        text +=
            fmt::format("   depth of the samples {}\n", fmt::join(fragment.sample_depths, ", "));
    if (fragment.inverse_w)
        text += fmt::format(
            "   1/w {}, w {}, in the primitive's scale\n", *fragment.inverse_w, fragment.w);
    if (!fragment.has_colors) return text;
    const InterpolantLayout& layout = fragment.state->layout;
    const auto line = [&](const char* name, const std::string& over_w, const std::string& value) {
        text += fmt::format("   {}: {}{}\n", name, fragment.image ? "" : over_w + " -> ", value);
    };
    if (layout.color >= 0)
        line("primary", over_w_text(fragment.primary_over_w, 4), color_text(fragment.primary));
    if (layout.secondary >= 0)
        line(
            "secondary", over_w_text(fragment.secondary_over_w, 3), color_text(fragment.secondary));
    if (layout.fog >= 0)
        line("fog coordinate",
             fmt::format("over w {}", fragment.fog_over_w),
             fmt::format("{}", fragment.fog_coordinate));
    return text;
}

std::string half_text(const char* name,
                      const FragmentNote& fragment,
                      const EnvironmentNote& environment,
                      const CombineHalf& half) {
    std::string text = fmt::format("     {}: {}", name, name_of(half.op));
    const char* before = "(";
    for (const ArgumentFact& fact : arguments_of(fragment, environment, half)) {
        text +=
            fmt::format("{}{}.{} = {}", before, fact.source, fact.operand, color_text(fact.value));
        before = ", ";
    }
    return text + (half.scale_shift ? fmt::format(") * {}\n", 1u << half.scale_shift) : ")\n");
}

std::string environment_text(const FragmentNote& fragment, const EnvironmentNote& environment) {
    const Combiner& combiner = fragment.registers().combiners[environment.unit];
    return fmt::format("   environment {}: previous {}\n{}{}     -> {}\n",
                       environment.unit,
                       color_text(environment.previous),
                       half_text("rgb", fragment, environment, combiner.rgb),
                       half_text("alpha", fragment, environment, combiner.alpha),
                       color_text(environment.result));
}

const char* verdict(bool passed) {
    return passed ? "passed" : "failed";
}

std::string visit_text(const FragmentNote& fragment, const DepthVisit& visit) {
    const Registers& registers = fragment.registers();
    const std::string of_sample =
        fragment.state->samples > 1 ? fmt::format(", sample {}", visit.sample) : "";
    std::string text;
    if (registers.stencil.enable) {
        const StencilFace& face = stencil_face(fragment);
        text += fmt::format("   stencil test{}: {} under mask {:#x}: {}; {} becomes {}\n",
                            of_sample,
                            comparison(face.compare, face.reference, visit.stored_stencil),
                            face.compare_mask,
                            verdict(visit.passed_stencil),
                            visit.stored_stencil,
                            visit.new_stencil);
    }
    const bool depth_came = !registers.stencil.enable || visit.passed_stencil;
    if (!registers.depth.test_enable || !depth_came) return text;
    return text + fmt::format("   {}depth test{}: {}: {}; {} becomes {}\n",
                              visit.early ? "early " : "",
                              of_sample,
                              comparison(registers.depth.compare, visit.depth, visit.stored_depth),
                              verdict(visit.passed_depth),
                              visit.stored_depth,
                              visit.new_depth);
}

std::string write_text(const FragmentNote& fragment, const WriteNote& write) {
    const Blend& blend = fragment.registers().blend;
    std::string text = fmt::format("   write to target {}", write.target);
    if (fragment.state->samples > 1) text += fmt::format(", sample {}", write.sample);
    text += fmt::format(
        ": source {}, destination {}\n", color_text(write.source), color_text(write.destination));
    if (blend.logic_op_enable) {
        text += fmt::format("     logic operation {}\n", name_of(blend.logic_op));
    } else if (blend.enable) {
        text += fmt::format(
            "     rgb {}; alpha {}\n",
            blend_formula(blend.rgb_equation, blend.rgb_source, blend.rgb_destination),
            blend_formula(blend.alpha_equation, blend.alpha_source, blend.alpha_destination));
        text += fmt::format("     constant {}, blended {}\n",
                            color_text(blend.constant),
                            color_text(write.blended));
    }
    return text + fmt::format("     write mask {}, stored {}\n",
                              channels(blend.write_mask),
                              color_text(write.stored));
}

} // namespace

std::string color_text(const Rgba& color) {
    return fmt::format("({})", fmt::join(color, ", "));
}

std::string color_text(std::uint32_t rgba8) {
    return color_text(unpack_rgba8(rgba8));
}

std::string geometry_text(const FragmentNote& fragment) {
    std::string text;
    if (fragment.primitive) {
        const PrimitiveNote& primitive = *fragment.primitive;
        text += fmt::format("   {}, {} facing\n",
                            name_of(primitive.shape),
                            fragment.front_facing ? "front" : "back");
        const auto names = attribute_names(fragment.state->layout);
        for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
            text += vertex_text(primitive.vertices[i], i, names);
        text += fmt::format("   edges {}\n", fmt::join(fragment.edges, ", "));
        const auto weights = primitive.weights(fragment.x, fragment.y);
        if (!weights.empty())
            text +=
                fmt::format("   weights {:.6f}; with perspective {:.6f}\n",
                            fmt::join(weights, ", "),
                            fmt::join(primitive.perspective_weights(fragment.x, fragment.y), ", "));
    } else {
        text += "   of a drawn image\n";
    }
    if (fragment.state->samples > 1)
        text += fmt::format("   covers samples {}\n", sample_text(fragment.samples_covered));
    return text + interpolated_text(fragment);
}

std::string shading_text(const FragmentNote& fragment) {
    std::string text;
    const auto change = [&](const char* name, const ColorChange& color) {
        text += fmt::format(
            "   {}: {} -> {}\n", name, color_text(color.before), color_text(color.after));
    };
    for (const EnvironmentNote& environment : fragment.environments)
        text += environment_text(fragment, environment);
    if (fragment.color_sum) change("color sum", *fragment.color_sum);
    if (fragment.fog) {
        change("fog", *fragment.fog);
        text += fmt::format("     factor {}/255 of the fragment, the rest of the fog's {}\n",
                            fragment.fog_factor,
                            color_text(fragment.registers().fog.color));
    }
    if (fragment.antialias) {
        change("coverage", *fragment.antialias);
        text += fmt::format("     factor {}/255\n", fragment.coverage);
    }
    return text;
}

std::string tests_text(const FragmentNote& fragment) {
    const Registers& registers = fragment.registers();
    std::string early, text;
    for (const DepthVisit& visit : fragment.visits)
        (visit.early ? early : text) += visit_text(fragment, visit);
    std::string between;
    if (fragment.sample_mask)
        between += fmt::format("   sample mask: {} -> {}\n",
                               sample_text((*fragment.sample_mask)[0]),
                               sample_text((*fragment.sample_mask)[1]));
    if (fragment.alpha_passed)
        between += fmt::format("   alpha test: {}: {}\n",
                               comparison(registers.fragment.alpha_compare,
                                          fragment.alpha,
                                          registers.fragment.alpha_reference),
                               verdict(*fragment.alpha_passed));
    text = early + between + text;
    for (const WriteNote& write : fragment.writes)
        text += write_text(fragment, write);
    const std::string_view end = FragmentEndNames[static_cast<std::size_t>(fragment.end)];
    text += fragment.end != FragmentEnd::Written ? fmt::format("   ended at the {}\n", end)
            : fragment.writes.empty()            ? "   passed; no colour is written\n"
                                                 : "";
    for (const TargetLookup& lookup : fragment.timing.targets)
        text += fmt::format("   {} cache, line {:#x}: {} in cycle {}\n",
                            lookup.cache == TargetLookup::Cache::Depth ? "depth" : "colour",
                            lookup.line,
                            lookup.missed ? "miss" : "hit",
                            lookup.cycle);
    if (fragment.timing.retired)
        text += fmt::format("   its quad retired in cycle {}\n", *fragment.timing.retired);
    return text;
}

} // namespace ffgpu::tools
