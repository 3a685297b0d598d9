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

// Those of one access: the border colour's are none.
std::uint64_t texels_of(const TexelAccess& access) {
    constexpr std::uint16_t Border = TexelAccess::BorderTexel;
    const auto inside = [](std::uint16_t first, std::uint16_t second, bool both) {
        return (first != Border ? 1u : 0u) + (both && second != Border ? 1u : 0u);
    };
    return std::uint64_t{inside(access.x0, access.x1, (access.linear & 1) != 0)} *
           inside(access.y0, access.y1, (access.linear & 2) != 0) *
           inside(access.layer0, access.layer1, (access.linear & 4) != 0);
}

struct TexelCounts {
    std::uint64_t accesses = 0, reads = 0;
};

// A fragment that the early depth test ended reads nothing.
TexelCounts texels_of(const work::WholeCommand& command) {
    TexelCounts counts;
    for (std::size_t quad = 0; quad < command.quads.size(); ++quad)
        for (std::size_t unit = 0; unit < command.units.size(); ++unit)
            for (const TexelAccess& access : command.accesses_of(quad, unit)) {
                if ((command.quads[quad].after_early_depth >> access.lane & 1) == 0) continue;
                ++counts.accesses;
                counts.reads += texels_of(access);
            }
    return counts;
}

} // namespace

std::string_view draw_fact_names() {
    return "call,function,primitive,vertices,primitives,quads,fragments_covered,"
           "fragments_killed_early_depth,fragments_killed_coverage,fragments_killed_alpha,"
           "fragments_killed_stencil,fragments_killed_depth,fragments_written,textures,"
           "texel_accesses,texel_reads";
}

std::string draw_facts(const work::WholeCommand& command, const DrawNote& note) {
    const bool has_note =
        command.draw.kind == WorkKind::Draw || command.draw.kind == WorkKind::Image;
    const bool has_call = has_note && !note.call.name.empty();
    const Fates fates = fates_of(command.quads);
    const TexelCounts texels = texels_of(command);
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
        texels.accesses,
        texels.reads);
}

} // namespace ffgpu::tools
