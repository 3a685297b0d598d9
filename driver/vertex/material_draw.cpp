#include "driver/vertex/material_draw.h"

#include "driver/lower/color_material.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/face_draw.h"
#include "driver/vertex/lit_draw.h"
#include "driver/vertex/primitive_cut.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>
#include <optional>

namespace ffgpu::gl {

namespace {

struct NamedColor {
    std::uint8_t bit; // a ColorMaterialBit
    Vec4 MaterialFace::*color;
};

constexpr NamedColor NamedColors[] = {
    {ColorMaterialAmbient, &MaterialFace::ambient},
    {ColorMaterialDiffuse, &MaterialFace::diffuse},
    {ColorMaterialSpecular, &MaterialFace::specular},
    {ColorMaterialEmission, &MaterialFace::emission},
};

// What differs between the materials of a run's vertices.
struct Differences {
    std::array<std::uint8_t, 2> colors{}; // ColorMaterialBits, front and back
    bool shininess = false;

    bool none() const { return colors[0] == 0 && colors[1] == 0 && !shininess; }
};

struct Faces {
    unsigned first = 0, last = 0; // 0 the front, 1 the back; the last one is not included
};

class MaterialDraw {
public:
    MaterialDraw(VertexContext& context,
                 const VertexRun& run,
                 std::span<const MaterialChange> changes)
        : context_(context)
        , lighting_(context.state.lighting)
        , both_{0, lighting_.model.two_side ? 2u : 1u} {
        materials_.resize(run.vertex_count());
        std::size_t change = 0;
        for (std::size_t i = 0; i < materials_.size(); ++i) {
            while (change + 1 < changes.size() && changes[change + 1].vertex <= i)
                ++change;
            materials_[i] = &changes[change].materials;
        }
    }

    void draw(const VertexRun& run) {
        if (draw_on_device(run, materials_)) return;
        for (const RunPrimitive& primitive : run.primitives)
            draw_primitive(run, primitive);
    }

private:
    using VertexMaterials = std::span<const Materials* const>;

    // Triangles and their like are drawn one by one if need be, but as many together as can be.
    void draw_primitive(const VertexRun& run, const RunPrimitive& primitive) {
        const std::uint32_t step =
            is_independent(primitive.type) ? vertices_of_one(primitive.type) : primitive.count;
        const std::uint32_t end = primitive.first + primitive.count;
        for (std::uint32_t i = primitive.first; i < end;) {
            std::uint32_t next = i + step;
            while (next < end && is_uniform(i, next + step))
                next += step;
            RunPrimitive piece = primitive;
            piece.first = 0;
            piece.count = next - i;
            draw_piece({run.format,
                        run.words.subspan(std::size_t{i} * run.format.stride,
                                          std::size_t{piece.count} * run.format.stride),
                        {&piece, 1}},
                       VertexMaterials(materials_).subspan(i, piece.count));
            i = next;
        }
    }

    bool is_uniform(std::uint32_t begin, std::uint32_t end) const {
        const auto from = materials_.begin();
        return std::all_of(from + begin, from + end, [&](auto m) { return m == from[begin]; });
    }

    void draw_piece(const VertexRun& piece, VertexMaterials materials) {
        if (!draw_on_device(piece, materials)) draw_lit(context_, piece, materials);
    }

    // False if the device cannot light these vertices in one draw.
    bool draw_on_device(const VertexRun& run, VertexMaterials materials) {
        const Differences differences = find_differences(materials);
        const bool by_color = follows_one_color(differences, both_, materials);
        const bool by_face = !by_color && is_one_polygon_primitive(run) &&
                             follows_one_color(differences, front_, materials) &&
                             follows_one_color(differences, back_, materials);
        if (!differences.none() && !by_color && !by_face) return false;
        const Materials latest = std::exchange(lighting_.materials, *materials.front());
        context_.dirty.mark(Dirty::Lighting);
        if (differences.none()) {
            context_.draw_path().draw(run);
        } else {
            draw_by_color(run, differences, by_face, materials);
        }
        lighting_.materials = latest;
        context_.dirty.mark(Dirty::Lighting);
        return true;
    }

    static bool is_one_polygon_primitive(const VertexRun& run) {
        const RunPrimitive& first = run.primitives.front();
        return run.primitives.size() == 1 && is_polygon(first.type) && first.first == 0 &&
               first.count == run.vertex_count();
    }

    Differences find_differences(VertexMaterials materials) const {
        Differences found;
        const Materials* seen = materials.front();
        for (const Materials* const each : materials) {
            if (each == seen) continue;
            seen = each;
            for (unsigned face = 0; face < both_.last; ++face) {
                const MaterialFace& one = (*each)[face];
                const MaterialFace& other = (*materials.front())[face];
                for (const NamedColor& name : NamedColors)
                    if (one.*name.color != other.*name.color) found.colors[face] |= name.bit;
                found.shininess = found.shininess || one.shininess != other.shininess;
            }
        }
        return found;
    }

    // Whether the colours of the faces that differ have the same value in each vertex.
    bool follows_one_color(const Differences& differences,
                           Faces faces,
                           VertexMaterials materials) const {
        if (differences.shininess || uses_colors()) return false;
        const Materials* seen = nullptr;
        return std::all_of(materials.begin(), materials.end(), [&](const Materials* each) {
            return std::exchange(seen, each) == each || one_color(differences, faces, *each);
        });
    }

    static std::optional<Vec4>
    one_color(const Differences& differences, Faces faces, const Materials& materials) {
        std::optional<Vec4> color;
        for (unsigned face = faces.first; face < faces.last; ++face) {
            for (const NamedColor& name : NamedColors) {
                if (!(differences.colors[face] & name.bit)) continue;
                if (color && *color != materials[face].*name.color) return std::nullopt;
                color = materials[face].*name.color;
            }
        }
        return color;
    }

    bool uses_colors() const {
        for (unsigned face = 0; face < both_.last; ++face)
            if (tracked_colors(lighting_.color_material, face) != 0) return true;
        return false;
    }

    // By face: the vertices with the colours of the front, and behind them those of the back.
    void draw_by_color(const VertexRun& run,
                       const Differences& differences,
                       bool by_face,
                       VertexMaterials materials) {
        const VertexFormat format = widen(run.format, Attribute::Color, 4);
        const unsigned offset = format.elements[attribute_index(Attribute::Color)].offset;
        std::vector<float> words;
        const auto add = [&](Faces faces) {
            std::size_t to = words.size(), from = 0;
            words.resize(to + materials.size() * format.stride);
            for (const Materials* const each : materials) {
                convert_vertex(run.format, format, run.words.data() + from, words.data() + to);
                const Vec4 color = *one_color(differences, faces, *each);
                std::copy(color.begin(), color.end(), words.data() + to + offset);
                from += run.format.stride, to += format.stride;
            }
        };
        add(by_face ? front_ : both_);
        if (by_face) add(back_);

        context_.lower_state();
        Lighting& wanted = context_.registers.wanted.lighting;
        wanted.color_material_front = differences.colors[0];
        wanted.color_material_back = differences.colors[1];
        context_.registers.update<&Registers::lighting>();
        if (by_face) {
            draw_by_face(context_, format, words, run.primitives.front());
        } else {
            context_.draw_path().draw({format, words, run.primitives});
        }
    }

    VertexContext& context_;
    LightingState& lighting_;
    const Faces both_; // whose materials are in use
    static constexpr Faces front_{0, 1}, back_{1, 2};
    std::vector<const Materials*> materials_; // a vertex
};

} // namespace

void draw_with_materials(VertexContext& context,
                         const VertexRun& run,
                         std::span<const MaterialChange> changes) {
    if (run.vertex_count() != 0) MaterialDraw(context, run, changes).draw(run);
}

} // namespace ffgpu::gl
