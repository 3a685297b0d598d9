#include "driver/vertex/tracked_draw.h"

#include "driver/lower/lighting.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace ffgpu::gl {
namespace {

struct TrackedColor {
    std::uint8_t bit; // of ColorMaterialBits
    Vec4 MaterialFace::*color;
};
constexpr TrackedColor TrackedColors[] = {{ColorMaterialAmbient, &MaterialFace::ambient},
                                          {ColorMaterialDiffuse, &MaterialFace::diffuse},
                                          {ColorMaterialSpecular, &MaterialFace::specular},
                                          {ColorMaterialEmission, &MaterialFace::emission}};

using TrackedBits = std::array<std::uint8_t, 2>; // front, back

// The colours that are not the same at all vertices; none: something else than colours is not.
std::optional<TrackedBits> differing_colors(std::span<const MaterialChange> changes,
                                            std::size_t faces) {
    TrackedBits bits{};
    const Materials& first = changes.front().materials;
    for (const MaterialChange& change : changes)
        for (std::size_t face = 0; face < faces; ++face) {
            const MaterialFace& material = change.materials[face];
            if (material.shininess != first[face].shininess) return std::nullopt;
            for (const auto& [bit, color] : TrackedColors)
                if (material.*color != first[face].*color) bits[face] |= bit;
        }
    return bits;
}

// The one value of all the colours in `bits`; null: they have several. Without bits any will do.
const Vec4* shared_color(const Materials& materials, const TrackedBits& bits) {
    if (bits == TrackedBits{}) return &MissingComponents;
    const Vec4* shared = nullptr;
    for (std::size_t face = 0; face < bits.size(); ++face)
        for (const auto& [bit, color] : TrackedColors) {
            if ((bits[face] & bit) == 0) continue;
            const Vec4& value = materials[face].*color;
            if (shared && *shared != value) return nullptr;
            shared = &value;
        }
    return shared;
}

} // namespace

bool draw_tracked(VertexContext& context,
                  const VertexRun& run,
                  std::span<const MaterialChange> changes) {
    context.lower_state();
    Registers& wanted = context.registers.wanted;
    const Lighting& lighting = wanted.lighting;
    if ((lighting.color_material_front | lighting.color_material_back) != 0) return false;
    const std::optional<TrackedBits> bits = differing_colors(changes, lighting.two_sided ? 2 : 1);
    if (!bits) return false;

    const VertexFormat format = widen(run.format, Attribute::Color, 4);
    const std::size_t color_at = format.elements[attribute_index(Attribute::Color)].offset;
    const std::size_t old_components =
        run.format.elements[attribute_index(Attribute::Color)].components;
    std::vector<float> words(std::size_t{run.vertex_count()} * format.stride);
    for (std::size_t i = 0; i < run.vertex_count(); ++i) {
        while (changes.size() > 1 && changes[1].vertex <= i)
            changes = changes.subspan(1);
        const Vec4* const color = shared_color(changes.front().materials, *bits);
        if (!color) return false;
        const float* const source = run.words.data() + i * run.format.stride;
        float* to = std::copy_n(source, color_at, words.data() + i * format.stride);
        to = std::copy(color->begin(), color->end(), to);
        std::copy(source + color_at + old_components, source + run.format.stride, to);
    }
    // All but the tracked colours are the same at all vertices, the last one's too.
    for (std::size_t face = 0; face < 2; ++face)
        wanted.materials[face] = lower_material(changes.front().materials[face]);
    context.registers.update<&Registers::materials>();
    wanted.lighting.color_material_front = (*bits)[0];
    wanted.lighting.color_material_back = (*bits)[1];
    context.registers.update<&Registers::lighting>();
    context.draw_path().draw({format, words, run.primitives});
    context.dirty.mark(Dirty::Lighting);
    return true;
}

} // namespace ffgpu::gl
