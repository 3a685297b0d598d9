// The control points of glMap1 and glMap2 in the application's memory.

#pragma once

#include "driver/gl_types.h"
#include "driver/limits.h"
#include "driver/state/evaluator_state.h"

#include <cstdint>

namespace ffgpu::gl {

constexpr unsigned map1_components(GLenum target) {
    const GLenum map = target - GL_MAP1_COLOR_4;
    return map < MapCount ? MapComponents[map] : 0;
}

constexpr unsigned map2_components(GLenum target) {
    const GLenum map = target - GL_MAP2_COLOR_4;
    return map < MapCount ? MapComponents[map] : 0;
}

constexpr bool is_map_order(GLint order) {
    return order >= 1 && order <= static_cast<GLint>(MaxEvaluatorOrder);
}

// From the first component of the first point to the last of the last; 0 where the command is an
// error and reads nothing.
template <class Number>
constexpr std::int64_t
map_points(GLenum target, Number, Number, GLint stride, GLint order, const Number*) {
    const std::int64_t components = map1_components(target);
    if (components == 0 || stride < components || !is_map_order(order)) return 0;
    return std::int64_t{stride} * (order - 1) + components;
}

template <class Number>
constexpr std::int64_t map_points(GLenum target,
                                  Number,
                                  Number,
                                  GLint u_stride,
                                  GLint u_order,
                                  Number,
                                  Number,
                                  GLint v_stride,
                                  GLint v_order,
                                  const Number*) {
    const std::int64_t components = map2_components(target);
    if (components == 0 || u_stride < components || v_stride < components) return 0;
    if (!is_map_order(u_order) || !is_map_order(v_order)) return 0;
    return std::int64_t{u_stride} * (u_order - 1) + std::int64_t{v_stride} * (v_order - 1) +
           components;
}

} // namespace ffgpu::gl
