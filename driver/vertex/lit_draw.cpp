#include "driver/vertex/lit_draw.h"

#include "driver/lower/color_material.h"
#include "driver/lower/lighting.h"
#include "driver/raster_position/host_vertex.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/face_draw.h"
#include "driver/vertex/tracked_draw.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

class LitDraw {
public:
    LitDraw(VertexContext& context, const VertexRun& run, std::span<const MaterialChange> changes)
        : context_(context)
        , run_(run)
        , format_(widen(run.format, Attribute::Color, 4)) {
        for (std::size_t i = 0; i < run.vertex_count(); ++i) {
            while (changes.size() > 1 && changes[1].vertex <= i)
                changes = changes.subspan(1);
            materials_.push_back(&changes.front().materials);
        }
        context_.lower_state();
        registers_ = context_.registers.wanted;
        if (registers_.lighting.separate_specular)
            format_ = widen(format_, Attribute::SecondaryColor, 3);
    }

    void draw() {
        context_.registers.wanted.lighting.enable = false;
        context_.registers.update<&Registers::lighting>();
        for (const RunPrimitive& primitive : run_.primitives)
            draw(primitive);
        context_.dirty.mark(Dirty::Lighting);
    }

private:
    void draw(RunPrimitive primitive) {
        words_.clear();
        add_lit_words(primitive, 0);
        const bool shows_back = registers_.lighting.two_sided && is_polygon(primitive.type);
        if (shows_back) add_lit_words(primitive, 1);
        primitive.first = 0;
        if (shows_back) {
            draw_by_face(context_, format_, words_, primitive);
        } else {
            context_.draw_path().draw({format_, words_, {&primitive, 1}});
        }
    }

    // The primitive's vertices with the colours of a face.
    void add_lit_words(const RunPrimitive& primitive, unsigned face) {
        Registers registers = registers_;
        registers.lighting.color_material_front = 0;
        const std::uint8_t tracked = face == 0 ? registers_.lighting.color_material_front
                                               : registers_.lighting.color_material_back;
        const VertexElement color = format_.elements[attribute_index(Attribute::Color)];
        const VertexElement second = format_.elements[attribute_index(Attribute::SecondaryColor)];
        const std::size_t end = primitive.first + primitive.count;
        for (std::size_t i = primitive.first; i < end; ++i) {
            words_.resize(words_.size() + format_.stride);
            float* const vertex = words_.data() + words_.size() - format_.stride;
            const float* const source = run_.words.data() + i * run_.format.stride;
            convert_vertex(run_.format, format_, source, vertex);
            registers.materials[0] = tracking(
                lower_material((*materials_[i])[face]), tracked, value(i, Attribute::Color));
            const LitColors colors = light(registers, i, face);
            std::copy(colors.primary.begin(), colors.primary.end(), vertex + color.offset);
            if (registers.lighting.separate_specular)
                std::copy_n(colors.secondary.begin(), second.components, vertex + second.offset);
        }
    }

    LitColors light(const Registers& registers, std::size_t i, unsigned face) const {
        EyeVertex eye =
            transform_vertex(registers, value(i, Attribute::Position), value(i, Attribute::Normal));
        if (face == 1)
            for (float& n : eye.normal)
                n = -n;
        return light_vertex(registers, eye, {}, {});
    }

    static Material tracking(Material material, std::uint8_t tracked, const Vec4& color) {
        if (tracked & ColorMaterialAmbient) material.ambient = color;
        if (tracked & ColorMaterialDiffuse) material.diffuse = color;
        if (tracked & ColorMaterialSpecular) material.specular = color;
        if (tracked & ColorMaterialEmission) material.emission = color;
        return material;
    }

    Vec4 value(std::size_t i, Attribute attribute) const {
        const VertexElement element = run_.format.elements[attribute_index(attribute)];
        if (element.components == 0) return context_.state.current.of(attribute);
        Vec4 result = MissingComponents;
        std::copy_n(run_.words.begin() +
                        static_cast<std::ptrdiff_t>(i * run_.format.stride + element.offset),
                    element.components,
                    result.begin());
        return result;
    }

    VertexContext& context_;
    const VertexRun& run_;
    std::vector<const Materials*> materials_; // a vertex
    VertexFormat format_;
    Registers registers_; // of the draw as the application wants it
    std::vector<float> words_;
};

} // namespace

void draw_lit(VertexContext& context,
              const VertexRun& run,
              std::span<const MaterialChange> changes) {
    if (!context.state.lighting.enable) return context.draw_path().draw(run);
    if (draw_tracked(context, run, changes)) return;
    LitDraw(context, run, changes).draw();
}

} // namespace ffgpu::gl
