#include "driver/state/evaluator_state.h"

namespace ffgpu::gl {

// The initial maps: order 1 with one control point (GL 1.5, state table 6.28).
EvaluatorState::EvaluatorState() {
    const auto set = [&](MapName name, std::vector<float> point) {
        map1[static_cast<std::size_t>(name)].points = point;
        map2[static_cast<std::size_t>(name)].points = std::move(point);
    };
    set(MapName::Color4, {1, 1, 1, 1});
    set(MapName::Index, {1});
    set(MapName::Normal, {0, 0, 1});
    set(MapName::TexCoord1, {0});
    set(MapName::TexCoord2, {0, 0});
    set(MapName::TexCoord3, {0, 0, 0});
    set(MapName::TexCoord4, {0, 0, 0, 1});
    set(MapName::Vertex3, {0, 0, 0});
    set(MapName::Vertex4, {0, 0, 0, 1});
}

} // namespace ffgpu::gl
