// Evaluators (GL 1.5, 5.1; state table 6.28). Enables, grids and AUTO_NORMAL are GL_EVAL_BIT; the
// maps themselves are in no group.

#pragma once

#include "driver/gl_types.h"

#include <array>
#include <vector>

namespace ffgpu::gl {

// In the order of the tokens from GL_MAP1_COLOR_4 and GL_MAP2_COLOR_4 on.
enum class MapName {
    Color4,
    Index,
    Normal,
    TexCoord1,
    TexCoord2,
    TexCoord3,
    TexCoord4,
    Vertex3,
    Vertex4,
    Count
};
constexpr std::size_t MapCount = static_cast<std::size_t>(MapName::Count);

constexpr std::array<unsigned, MapCount> MapComponents{4, 1, 3, 1, 2, 3, 4, 3, 4};

// points[(i * v.order + j) * components + c], u first. Of a one-dimensional map v has order 1.
struct EvaluatorMap {
    struct Direction {
        GLint order = 1;
        float from = 0, to = 1;
    };
    Direction u, v;
    std::vector<float> points;
};

struct EvaluatorGrid {
    GLint segments = 1;
    float from = 0, to = 1;
};

// GL_EVAL_BIT.
struct EvaluatorSettings {
    bool auto_normal = false;
    std::array<bool, MapCount> map1_enable{}, map2_enable{}; // by token - GL_MAP1_COLOR_4 ...
    EvaluatorGrid grid1;
    std::array<EvaluatorGrid, 2> grid2; // u, v
};

struct EvaluatorState {
    EvaluatorState();

    EvaluatorSettings settings;
    std::array<EvaluatorMap, MapCount> map1, map2;
};

} // namespace ffgpu::gl
