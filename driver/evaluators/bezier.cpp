#include "driver/evaluators/bezier.h"

#include "driver/vertex/vertex_run.h"

#include <cmath>

namespace ffgpu::gl {

namespace {

using Weights = std::array<float, MaxEvaluatorOrder>;

// All polynomials of degree order - 1 at t: each degree from the one before.
Weights bernstein_values(unsigned order, float t) {
    Weights weights{};
    weights[0] = 1;
    for (unsigned degree = 1; degree < order; ++degree) {
        for (unsigned i = degree + 1; i-- > 0;) {
            const float from_left = i == 0 ? 0 : t * weights[i - 1];
            weights[i] = from_left + (1 - t) * (i < degree ? weights[i] : 0);
        }
    }
    return weights;
}

Vec4 weighted_sum(
    const EvaluatorMap& map, unsigned components, const Weights& u, const Weights& v, Vec4 sum) {
    for (unsigned c = 0; c < components; ++c)
        sum[c] = 0;
    const float* point = map.points.data();
    for (unsigned i = 0; i < static_cast<unsigned>(map.u.order); ++i) {
        for (unsigned j = 0; j < static_cast<unsigned>(map.v.order); ++j, point += components) {
            const float weight = u[i] * v[j];
            for (unsigned c = 0; c < components; ++c)
                sum[c] += weight * point[c];
        }
    }
    return sum;
}

} // namespace

BernsteinWeights bernstein(const EvaluatorMap::Direction& direction, float parameter) {
    BernsteinWeights weights;
    const auto order = static_cast<unsigned>(direction.order);
    const float scale = 1 / (direction.to - direction.from);
    const float t = (parameter - direction.from) * scale;
    weights.value = bernstein_values(order, t);
    if (order < 2) return weights;
    const Weights lower = bernstein_values(order - 1, t);
    const float factor = static_cast<float>(order - 1) * scale;
    for (unsigned i = 0; i < order; ++i) {
        const float before = i == 0 ? 0 : lower[i - 1];
        const float here = i == order - 1 ? 0 : lower[i];
        weights.derivative[i] = factor * (before - here);
    }
    return weights;
}

Vec4 evaluate(const EvaluatorMap& map,
              unsigned components,
              const BernsteinWeights& u,
              const BernsteinWeights& v) {
    return weighted_sum(map, components, u.value, v.value, MissingComponents);
}

Vec4 surface_normal(const EvaluatorMap& map,
                    unsigned components,
                    const BernsteinWeights& u,
                    const BernsteinWeights& v) {
    constexpr Vec4 Zero{};
    const Vec4 p = evaluate(map, components, u, v);
    Vec4 du = weighted_sum(map, components, u.derivative, v.value, Zero);
    Vec4 dv = weighted_sum(map, components, u.value, v.derivative, Zero);
    if (components == 4) {
        // The derivative of x / w, but for the factor 1 / w^2.
        for (unsigned c = 0; c < 3; ++c) {
            du[c] = du[c] * p[3] - p[c] * du[3];
            dv[c] = dv[c] * p[3] - p[c] * dv[3];
        }
    }
    const Vec4 normal{du[1] * dv[2] - du[2] * dv[1],
                      du[2] * dv[0] - du[0] * dv[2],
                      du[0] * dv[1] - du[1] * dv[0],
                      1};
    const float length =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > 0)) return {0, 0, 0, 1};
    return {normal[0] / length, normal[1] / length, normal[2] / length, 1};
}

} // namespace ffgpu::gl
