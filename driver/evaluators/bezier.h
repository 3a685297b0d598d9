// Bezier curves and surfaces of any order up to MaxEvaluatorOrder (GL 1.5, 5.1).

#pragma once

#include "driver/limits.h"
#include "driver/state/evaluator_state.h"
#include "model/device/registers/geometry.h"

#include <array>

namespace ffgpu::gl {

// The Bernstein polynomials of a direction and their derivatives, at one parameter.
struct BernsteinWeights {
    std::array<float, MaxEvaluatorOrder> value{};
    std::array<float, MaxEvaluatorOrder> derivative{}; // with respect to GL's u or v
};
BernsteinWeights bernstein(const EvaluatorMap::Direction& direction, float parameter);

// The point of a map; components beyond the map's are MissingComponents.
Vec4 evaluate(const EvaluatorMap& map,
              unsigned components,
              const BernsteinWeights& u,
              const BernsteinWeights& v);

// The normal that GL_AUTO_NORMAL makes: dp/du x dp/dv, normalised; zero where that vanishes.
Vec4 surface_normal(const EvaluatorMap& map,
                    unsigned components,
                    const BernsteinWeights& u,
                    const BernsteinWeights& v);

} // namespace ffgpu::gl
