#include "driver/evaluators/evaluate_vertex.h"

#include "driver/evaluators/bezier.h"
#include "driver/vertex/immediate_vertices.h"
#include "driver/vertex/vertex_context.h"

#include <optional>

namespace ffgpu::gl {

namespace {

using Maps = std::array<EvaluatorMap, MapCount>;
using Enables = std::array<bool, MapCount>;

constexpr std::size_t number(MapName map) {
    return static_cast<std::size_t>(map);
}

// The first enabled map of those that stand for one attribute, the widest first.
template <class... Names>
std::optional<std::size_t> enabled_map(const Enables& enables, Names... names) {
    std::optional<std::size_t> found;
    (..., (!found && enables[number(names)] ? void(found = number(names)) : void()));
    return found;
}

// Attributes that the maps make hold for this vertex alone: the current ones stay.
class TemporaryAttribute {
public:
    TemporaryAttribute(ImmediateVertices& vertices,
                       Attribute attribute,
                       unsigned components,
                       const Vec4& value)
        : vertices_(vertices)
        , attribute_(attribute)
        , before_(vertices.value_of(attribute)) {
        vertices.set(attribute, components, value);
    }
    ~TemporaryAttribute() { vertices_.set(attribute_, width(before_), before_); }
    TemporaryAttribute(const TemporaryAttribute&) = delete;
    TemporaryAttribute& operator=(const TemporaryAttribute&) = delete;

private:
    // So that the vertex format does not grow for components that are what they would be anyway.
    static unsigned width(const Vec4& value) {
        for (unsigned c = 4; c > 1; --c)
            if (value[c - 1] != MissingComponents[c - 1]) return c;
        return 1;
    }

    ImmediateVertices& vertices_;
    Attribute attribute_;
    Vec4 before_;
};

class Evaluation {
public:
    Evaluation(VertexContext& context, const Maps& maps, const Enables& enables, float u, float v)
        : context_(context)
        , maps_(maps)
        , enables_(enables)
        , u_(u)
        , v_(v) {}

    // `auto_normal`: of a surface, in place of the normal map.
    void emit(bool auto_normal) {
        const auto position = enabled_map(enables_, MapName::Vertex4, MapName::Vertex3);
        if (!position) return;
        std::optional<TemporaryAttribute> color, normal, tex_coord;
        set(color, Attribute::Color, enabled_map(enables_, MapName::Color4));
        set(tex_coord,
            Attribute::TexCoord0,
            enabled_map(enables_,
                        MapName::TexCoord4,
                        MapName::TexCoord3,
                        MapName::TexCoord2,
                        MapName::TexCoord1));
        const unsigned components = MapComponents[*position];
        if (auto_normal) {
            const EvaluatorMap& map = maps_[*position];
            const Vec4 value =
                surface_normal(map, components, bernstein(map.u, u_), bernstein(map.v, v_));
            normal.emplace(context_.immediate(), Attribute::Normal, 3u, value);
        } else {
            set(normal, Attribute::Normal, enabled_map(enables_, MapName::Normal));
        }
        context_.immediate().vertex(components, value_of(*position));
    }

private:
    void set(std::optional<TemporaryAttribute>& place,
             Attribute attribute,
             std::optional<std::size_t> map) {
        if (map)
            place.emplace(context_.immediate(), attribute, MapComponents[*map], value_of(*map));
    }

    Vec4 value_of(std::size_t name) const {
        const EvaluatorMap& map = maps_[name];
        return evaluate(map, MapComponents[name], bernstein(map.u, u_), bernstein(map.v, v_));
    }

    VertexContext& context_;
    const Maps& maps_;
    const Enables& enables_;
    float u_, v_;
};

} // namespace

void evaluate_vertex_1(VertexContext& context, float u) {
    const EvaluatorState& state = context.state.evaluator;
    Evaluation(context, state.map1, state.settings.map1_enable, u, 0).emit(false);
}

void evaluate_vertex_2(VertexContext& context, float u, float v) {
    const EvaluatorState& state = context.state.evaluator;
    Evaluation(context, state.map2, state.settings.map2_enable, u, v)
        .emit(state.settings.auto_normal);
}

float grid_parameter(const EvaluatorGrid& grid, std::int64_t i) {
    if (i == 0) return grid.from;
    if (i == grid.segments) return grid.to; // Exactly.
    const float step = (grid.to - grid.from) / static_cast<float>(grid.segments);
    return static_cast<float>(i) * step + grid.from;
}

} // namespace ffgpu::gl
