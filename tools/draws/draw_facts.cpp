#include "tools/draws/draw_facts.h"

#include "model/device/enumerators.h"

#include <bit>
#include <cstdint>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

struct Fates {
    std::uint64_t covered = 0, early = 0, coverage = 0, alpha = 0, stencil = 0, depth = 0;
    std::uint64_t written = 0;
};

unsigned lost(std::uint8_t before, std::uint8_t after) {
    return static_cast<unsigned>(std::popcount(static_cast<unsigned>(before & ~after)));
}

Fates fates_of(const std::vector<WorkQuad>& quads) {
    Fates fates;
    for (const WorkQuad& quad : quads) {
        fates.covered += static_cast<unsigned>(std::popcount(quad.covered));
        fates.early += lost(quad.covered, quad.after_early_depth);
        fates.coverage += lost(quad.after_early_depth, quad.after_coverage);
        fates.alpha += lost(quad.after_coverage, quad.after_alpha);
        fates.stencil += lost(quad.after_alpha, quad.after_stencil);
        fates.depth += lost(quad.after_stencil, quad.after_depth);
        fates.written += static_cast<unsigned>(std::popcount(quad.after_depth));
    }
    return fates;
}

// "0:TwoD/rgba8/256x256/9 1:...": of the units that were read.
std::string textures_of(const work::WholeCommand& command) {
    std::string text;
    for (const std::uint8_t unit : command.units) {
        const TextureShape& shape = command.draw.state->images[unit].shape;
        text += fmt::format("{}{}:{}/{}/{}x{}",
                            text.empty() ? "" : " ",
                            unit,
                            EnumeratorNames<TextureKind>[static_cast<std::size_t>(shape.kind)],
                            format_info(shape.format).name,
                            shape.width,
                            shape.height);
        if (shape.kind == TextureKind::ThreeD) text += fmt::format("x{}", shape.depth);
        text += fmt::format("/{}", shape.levels);
    }
    return text;
}

std::uint64_t texel_reads(const work::WholeCommand& command) {
    std::uint64_t reads = 0;
    for (const TexelAccess& access : command.accesses)
        reads += std::uint64_t{1} << std::popcount(access.linear);
    return reads;
}

} // namespace

std::string_view draw_fact_names() {
    return "call,function,primitive,vertices,primitives,quads,fragments_covered,"
           "fragments_killed_early,fragments_killed_coverage,fragments_killed_alpha,"
           "fragments_killed_stencil,fragments_killed_depth,fragments_written,textures,"
           "texel_accesses,texel_reads";
}

std::string draw_facts(const work::WholeCommand& command, const DrawNote& note) {
    const bool has_note =
        command.draw.kind == WorkKind::Draw || command.draw.kind == WorkKind::Image;
    const bool has_call = has_note && !note.call.name.empty();
    const Fates fates = fates_of(command.quads);
    const auto primitive = static_cast<std::size_t>(note.draw.primitive);
    return fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
        has_call ? std::to_string(note.call.number) : "",
        has_call ? note.call.name : "",
        command.draw.kind == WorkKind::Draw ? EnumeratorNames<PrimitiveType>[primitive] : "",
        command.draw.geometry.vertices.size(),
        command.draw.geometry.primitives.size(),
        command.quads.size(),
        fates.covered,
        fates.early,
        fates.coverage,
        fates.alpha,
        fates.stencil,
        fates.depth,
        fates.written,
        textures_of(command),
        command.accesses.size(),
        texel_reads(command));
}

} // namespace ffgpu::tools
