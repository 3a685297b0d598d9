#include "tools/explain/history_facts.h"

#include "model/memory/pixel_format.h"
#include "tools/explain/names.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

Rgba source_value(const FragmentNote& fragment,
                  const EnvironmentNote& environment,
                  CombineSource source) {
    switch (source) {
    case CombineSource::Constant:
        return unpack_rgba8(fragment.registers().combiners[environment.unit].constant);
    case CombineSource::Primary:
        return fragment.primary;
    case CombineSource::Previous:
        return environment.previous;
    case CombineSource::Zero:
        return {};
    case CombineSource::One:
        return {255, 255, 255, 255};
    default:
        break;
    }
    for (const TextureNote& texture : fragment.textures)
        if (texture.unit == static_cast<unsigned>(source)) return texture.color;
    return {0, 0, 0, 255}; // A unit without a texture.
}

Rgba with_operand(Rgba value, CombineOperand operand) {
    const bool alpha = operand == CombineOperand::Alpha || operand == CombineOperand::OneMinusAlpha;
    const bool complement =
        operand == CombineOperand::OneMinusColor || operand == CombineOperand::OneMinusAlpha;
    if (alpha) value.fill(value[3]);
    if (complement)
        for (std::uint8_t& channel : value)
            channel = static_cast<std::uint8_t>(255 - channel);
    return value;
}

} // namespace

std::vector<ArgumentFact> arguments_of(const FragmentNote& fragment,
                                       const EnvironmentNote& environment,
                                       const CombineHalf& half) {
    std::vector<ArgumentFact> facts;
    for (unsigned i = 0; i < argument_count(half.op); ++i) {
        const auto [source, operand] = half.arguments[i];
        facts.push_back({std::string(name_of(source)),
                         name_of(operand),
                         with_operand(source_value(fragment, environment, source), operand)});
    }
    return facts;
}

const StencilFace& stencil_face(const FragmentNote& fragment) {
    const Stencil& stencil = fragment.registers().stencil;
    return fragment.front_facing ? stencil.front : stencil.back;
}

std::string comparison(Compare compare, std::uint64_t reference, std::uint64_t stored) {
    constexpr std::string_view Signs[] = {"", "<", "==", "<=", ">", "!=", ">=", ""};
    if (compare == Compare::Never || compare == Compare::Always)
        return std::string(name_of(compare));
    return fmt::format("{} {} {}", reference, Signs[static_cast<std::size_t>(compare)], stored);
}

std::string blend_formula(BlendEquation equation, BlendFactor source, BlendFactor destination) {
    const std::string s = fmt::format("{} * source", name_of(source)),
                      d = fmt::format("{} * destination", name_of(destination));
    switch (equation) {
    case BlendEquation::Add:
        return s + " + " + d;
    case BlendEquation::Subtract:
        return s + " - " + d;
    case BlendEquation::ReverseSubtract:
        return d + " - " + s;
    case BlendEquation::Min:
        return "min(source, destination)";
    case BlendEquation::Max:
        return "max(source, destination)";
    }
    return {};
}

std::string channels(unsigned mask) {
    std::string text;
    for (unsigned i = 0; i < 4; ++i)
        if (mask >> i & 1) text += "rgba"[i];
    return text.empty() ? "none" : text;
}

std::vector<std::string> attribute_names(const InterpolantLayout& layout) {
    std::vector<std::string> names(layout.count);
    const auto name = [&](int first, unsigned count, const std::string& base, const char* parts) {
        for (unsigned i = 0; first >= 0 && i < count; ++i)
            names[static_cast<unsigned>(first) + i] =
                parts[0] ? fmt::format("{}.{}", base, parts[i]) : base;
    };
    name(layout.color, 4, "color", "rgba");
    name(layout.secondary, 3, "secondary_color", "rgb");
    name(layout.fog, 1, "fog_coordinate", "");
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        name(layout.tex_coord[unit],
             layout.tex_components[unit],
             fmt::format("tex_coord{}", unit),
             "strq");
    return names;
}

const TexelLookup*
lookup_of(const FragmentNote& fragment, unsigned unit, unsigned level, const probed::Texel& texel) {
    for (const TexelLookup& lookup : fragment.timing.lookups)
        if (lookup.unit == unit && lookup.level == level && lookup.x == texel.x &&
            lookup.y == texel.y && lookup.layer == texel.layer)
            return &lookup;
    return nullptr;
}

} // namespace ffgpu::tools
