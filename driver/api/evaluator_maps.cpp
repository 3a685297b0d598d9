// The maps and grids of evaluators (GL 1.5, 5.1 and 6.1.3).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/evaluators/map_points.h"
#include "driver/math/conversion.h"

#include <type_traits>

namespace ffgpu::gl::api {
namespace {

// The active unit matters for the maps of texture coordinates, which unit 0 alone has
// (GL 1.5, 5.1).
bool is_wrong_unit(const Context& context) {
    return context.state.texture.active_unit != 0;
}

bool is_texture_map(std::size_t map) {
    return map >= static_cast<std::size_t>(MapName::TexCoord1) &&
           map <= static_cast<std::size_t>(MapName::TexCoord4);
}

template <class Number>
struct MapAxis {
    Number from, to;
    GLint stride, order;

    bool is_valid(unsigned components) const {
        return from != to && is_map_order(order) && stride >= static_cast<GLint>(components);
    }
    EvaluatorMap::Direction direction() const {
        return {order, static_cast<float>(from), static_cast<float>(to)};
    }
};

template <class Number>
void set_map(EvaluatorMap& map,
             unsigned components,
             const MapAxis<Number>& u,
             const MapAxis<Number>& v,
             const Number* points) {
    EvaluatorMap fresh{.u = u.direction(), .v = v.direction(), .points = {}};
    fresh.points.reserve(static_cast<std::size_t>(u.order) * static_cast<std::size_t>(v.order) *
                         components);
    for (GLint i = 0; i < u.order; ++i) {
        for (GLint j = 0; j < v.order; ++j) {
            const Number* const point =
                points + std::ptrdiff_t{i} * u.stride + std::ptrdiff_t{j} * v.stride;
            for (unsigned c = 0; c < components; ++c)
                fresh.points.push_back(static_cast<float>(point[c]));
        }
    }
    map = std::move(fresh);
}

template <class Number>
void map_1(Context& context, GLenum target, const MapAxis<Number>& u, const Number* points) {
    if (context.fails_inside_begin()) return;
    const unsigned components = map1_components(target);
    if (components == 0) return context.error(GL_INVALID_ENUM);
    if (!u.is_valid(components)) return context.error(GL_INVALID_VALUE);
    const std::size_t map = target - GL_MAP1_COLOR_4;
    if (is_texture_map(map) && is_wrong_unit(context)) return context.error(GL_INVALID_OPERATION);
    const MapAxis<Number> none{0, 1, 0, 1};
    set_map(context.state.evaluator.map1[map], components, u, none, points);
}

template <class Number>
void map_2(Context& context,
           GLenum target,
           const MapAxis<Number>& u,
           const MapAxis<Number>& v,
           const Number* points) {
    if (context.fails_inside_begin()) return;
    const unsigned components = map2_components(target);
    if (components == 0) return context.error(GL_INVALID_ENUM);
    if (!u.is_valid(components) || !v.is_valid(components)) return context.error(GL_INVALID_VALUE);
    const std::size_t map = target - GL_MAP2_COLOR_4;
    if (is_texture_map(map) && is_wrong_unit(context)) return context.error(GL_INVALID_OPERATION);
    set_map(context.state.evaluator.map2[map], components, u, v, points);
}

template <class Number>
Number to(float value) {
    if constexpr (std::is_integral_v<Number>) {
        return round_to_int(static_cast<double>(value));
    } else {
        return static_cast<Number>(value);
    }
}

template <class Number>
void get_map(Context& context, GLenum target, GLenum query, Number* values) {
    if (context.fails_inside_begin()) return;
    const EvaluatorState& state = context.state.evaluator;
    const bool is_1 = map1_components(target) != 0;
    if (!is_1 && map2_components(target) == 0) return context.error(GL_INVALID_ENUM);
    const EvaluatorMap& map =
        is_1 ? state.map1[target - GL_MAP1_COLOR_4] : state.map2[target - GL_MAP2_COLOR_4];
    const auto give = [&](auto value) { *values++ = to<Number>(static_cast<float>(value)); };
    switch (query) {
    case GL_COEFF:
        for (const float point : map.points)
            give(point);
        break;
    case GL_ORDER:
        give(map.u.order);
        if (!is_1) give(map.v.order);
        break;
    case GL_DOMAIN:
        give(map.u.from);
        give(map.u.to);
        if (is_1) break;
        give(map.v.from);
        give(map.v.to);
        break;
    default:
        context.error(GL_INVALID_ENUM);
    }
}

} // namespace

void Map1f(Context& context,
           GLenum target,
           GLfloat u1,
           GLfloat u2,
           GLint stride,
           GLint order,
           const GLfloat* points) {
    map_1<GLfloat>(context, target, {u1, u2, stride, order}, points);
}

void Map1d(Context& context,
           GLenum target,
           GLdouble u1,
           GLdouble u2,
           GLint stride,
           GLint order,
           const GLdouble* points) {
    map_1<GLdouble>(context, target, {u1, u2, stride, order}, points);
}

void Map2f(Context& context,
           GLenum target,
           GLfloat u1,
           GLfloat u2,
           GLint ustride,
           GLint uorder,
           GLfloat v1,
           GLfloat v2,
           GLint vstride,
           GLint vorder,
           const GLfloat* points) {
    map_2<GLfloat>(context, target, {u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, points);
}

void Map2d(Context& context,
           GLenum target,
           GLdouble u1,
           GLdouble u2,
           GLint ustride,
           GLint uorder,
           GLdouble v1,
           GLdouble v2,
           GLint vstride,
           GLint vorder,
           const GLdouble* points) {
    map_2<GLdouble>(context, target, {u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, points);
}

void MapGrid1f(Context& context, GLint un, GLfloat u1, GLfloat u2) {
    if (context.fails_inside_begin()) return;
    if (un < 1) return context.error(GL_INVALID_VALUE);
    context.state.evaluator.settings.grid1 = {un, u1, u2};
}

void MapGrid1d(Context& context, GLint un, GLdouble u1, GLdouble u2) {
    MapGrid1f(context, un, static_cast<GLfloat>(u1), static_cast<GLfloat>(u2));
}

void MapGrid2f(
    Context& context, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2) {
    if (context.fails_inside_begin()) return;
    if (un < 1 || vn < 1) return context.error(GL_INVALID_VALUE);
    context.state.evaluator.settings.grid2 = {EvaluatorGrid{un, u1, u2}, EvaluatorGrid{vn, v1, v2}};
}

void MapGrid2d(
    Context& context, GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2) {
    const auto f = [](GLdouble value) { return static_cast<GLfloat>(value); };
    MapGrid2f(context, un, f(u1), f(u2), vn, f(v1), f(v2));
}

void GetMapfv(Context& context, GLenum target, GLenum query, GLfloat* v) {
    get_map(context, target, query, v);
}

void GetMapdv(Context& context, GLenum target, GLenum query, GLdouble* v) {
    get_map(context, target, query, v);
}

void GetMapiv(Context& context, GLenum target, GLenum query, GLint* v) {
    get_map(context, target, query, v);
}

} // namespace ffgpu::gl::api
