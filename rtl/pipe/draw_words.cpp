#include "rtl/pipe/draw_words.h"

#include <bit>

namespace ffgpu::rtl {
namespace {

constexpr std::uint64_t bits(unsigned count, unsigned from) {
    return ((std::uint64_t{1} << count) - 1) << from;
}

std::uint64_t carried(const InterpolantLayout& layout) {
    std::uint64_t attributes = 0;
    if (layout.color >= 0) attributes |= bits(4, PrimaryAttribute);
    if (layout.secondary >= 0) attributes |= bits(3, SecondaryAttribute);
    if (layout.fog >= 0) attributes |= bits(1, FogAttribute);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (layout.tex_coord[unit] >= 0)
            attributes |= bits(layout.tex_components[unit], CoordinateAttributes + 4 * unit);
    return attributes;
}

SurfaceWords place_of(const Surface& surface) {
    return {surface.address, surface.stride};
}

PlaneWrite plane_write(unsigned attribute, const AttributePlane& plane) {
    const std::int64_t c = plane.c + AttributePlane::Half;
    constexpr std::int64_t Mask = (1 << AttributePlane::GuardBits) - 1;
    return {.attribute = static_cast<std::uint8_t>(attribute),
            .whole = static_cast<std::int32_t>(c >> AttributePlane::GuardBits),
            .fraction = static_cast<std::uint32_t>(c & Mask),
            .dx = plane.dx,
            .dy = plane.dy,
            .scale = static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(plane.scale) >> 23)};
}

} // namespace

DrawWords draw_words(const DrawContext& context) {
    const PixelContext& pixels = *context.pixels;
    const FragmentPipe& pipe = pixels.pipe;
    const StencilDepthState& depth = pipe.stencil_depth;
    DrawWords words;
    words.carried = carried(pixels.layout);
    words.sampled_units = pixels.units;
    words.combiners = context.regs().combiners;
    words.control = {context.regs().fragment};
    words.fog = {pipe.fog};
    words.stencil_depth = {{.enable = depth.stencil, .front = depth.front, .back = depth.back},
                           depth.depth,
                           depth.format};
    words.depth_place = place_of(pipe.depth_target);
    for (const ColorTarget& target : pipe.color_targets) {
        if (target.surface.format == Format::None) continue;
        words.blend = {pipe.color_stage.state, context.regs().fragment, target.surface.format};
        words.blend.blend.write_mask = target.write_mask;
        words.color_place = place_of(target.surface);
    }
    return words;
}

std::array<TextureContext, TextureUnits> texture_contexts(const DrawContext& context) {
    std::array<TextureContext, TextureUnits> contexts;
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (!context.pixels->samples(unit)) continue;
        const TextureUnit& texture = context.pixels->textures[unit];
        contexts[unit] = {texture.levels, texture_words(texture)};
        contexts[unit].words.image.address = context.regs().images[unit].address;
    }
    return contexts;
}

std::vector<PlaneWrite> plane_writes(const InterpolantLayout& layout, const SetupRecord& record) {
    std::vector<PlaneWrite> writes;
    const auto add = [&](unsigned attribute, int first, unsigned count) {
        if (first < 0) return;
        for (unsigned i = 0; i < count; ++i)
            writes.push_back(
                plane_write(attribute + i, record.plane(static_cast<unsigned>(first) + i)));
    };
    if (!record.constant_color) add(PrimaryAttribute, layout.color, 4);
    if (!record.constant_secondary) add(SecondaryAttribute, layout.secondary, 3);
    add(FogAttribute, layout.fog, 1);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        add(CoordinateAttributes + 4 * unit, layout.tex_coord[unit], layout.tex_components[unit]);
    if (record.perspective) writes.push_back(plane_write(InverseWAttribute, record.inverse_w()));
    return writes;
}

} // namespace ffgpu::rtl
