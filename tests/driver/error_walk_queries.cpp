// Commands that tell state, and occlusion queries.

#include "model/device/layout/limits.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr RefusedCall Calls[] = {
    REFUSED(GL_INVALID_ENUM, GetBooleanv, GL_COLOR, flags),
    REFUSED(GL_INVALID_ENUM, GetDoublev, GL_COLOR, doubles),
    REFUSED(GL_INVALID_ENUM, GetFloatv, GL_COLOR, floats),
    REFUSED(GL_INVALID_ENUM, GetIntegerv, GL_COLOR, ints),
    REFUSED(GL_INVALID_ENUM, GetPointerv, GL_VERTEX_ARRAY, pointers),
    REFUSED(GL_INVALID_ENUM, GetString, GL_VERTEX_ARRAY),
    REFUSED(GL_INVALID_ENUM, IsEnabled, GL_AMBIENT),
    REFUSED(GL_INVALID_ENUM, GetClipPlane, GL_CLIP_PLANE0 + ClipPlanes, doubles),
    REFUSED(GL_INVALID_ENUM, GetLightfv, GL_LIGHT0 + Lights, GL_AMBIENT, floats),
    REFUSED(GL_INVALID_ENUM, GetLightfv, GL_LIGHT0, GL_SHININESS, floats),
    REFUSED(GL_INVALID_ENUM, GetLightiv, GL_LIGHT0, GL_EMISSION, ints),
    REFUSED(GL_INVALID_ENUM, GetMaterialfv, GL_FRONT_AND_BACK, GL_AMBIENT, floats),
    REFUSED(GL_INVALID_ENUM, GetMaterialfv, GL_FRONT, GL_AMBIENT_AND_DIFFUSE, floats),
    REFUSED(GL_INVALID_ENUM, GetMaterialiv, GL_FRONT, GL_POSITION, ints),
    REFUSED(GL_INVALID_ENUM, GetTexEnvfv, GL_TEXTURE, GL_TEXTURE_ENV_MODE, floats),
    REFUSED(GL_INVALID_ENUM, GetTexEnviv, GL_TEXTURE_ENV, GL_COORD_REPLACE, ints),
    REFUSED(GL_INVALID_ENUM, GetTexGendv, GL_Q + 1, GL_EYE_PLANE, doubles),
    REFUSED(GL_INVALID_ENUM, GetTexGenfv, GL_S, GL_TEXTURE_GEN_S, floats),
    REFUSED(GL_INVALID_ENUM, GetTexGeniv, GL_TEXTURE, GL_TEXTURE_GEN_MODE, ints),
    REFUSED(GL_INVALID_ENUM, GetTexParameterfv, GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, floats),
    REFUSED(GL_INVALID_ENUM, GetTexParameteriv, GL_TEXTURE_2D, GL_TEXTURE_WIDTH, ints),
    REFUSED(
        GL_INVALID_ENUM, GetTexLevelParameterfv, GL_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_WIDTH, floats),
    REFUSED(GL_INVALID_VALUE, GetTexLevelParameterfv, GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, floats),
    REFUSED(GL_INVALID_ENUM, GetTexLevelParameteriv, GL_TEXTURE_2D, 0, GL_TEXTURE_WRAP_S, ints),
    REFUSED(GL_INVALID_VALUE,
            GetTexLevelParameteriv,
            GL_TEXTURE_2D,
            MaxTextureLevels,
            GL_TEXTURE_WIDTH,
            ints),
    REFUSED(GL_INVALID_ENUM, GetMapdv, GL_MAP1_GRID_DOMAIN, GL_COEFF, doubles),
    REFUSED(GL_INVALID_ENUM, GetMapfv, GL_MAP1_VERTEX_3, GL_AMBIENT, floats),
    REFUSED(GL_INVALID_ENUM, GetMapiv, GL_MAP2_GRID_DOMAIN, GL_ORDER, ints),
    REFUSED(GL_INVALID_ENUM, GetPixelMapfv, GL_PIXEL_MAP_A_TO_A + 1, floats),
    REFUSED(GL_INVALID_ENUM, GetPixelMapuiv, GL_PIXEL_MAP_I_TO_I - 1, names),
    REFUSED(GL_INVALID_ENUM, GetPixelMapusv, GL_MAP_COLOR, shorts),
    REFUSED(GL_INVALID_ENUM, BeginQuery, GL_TEXTURE_2D, 1),
    REFUSED(GL_INVALID_OPERATION, BeginQuery, GL_SAMPLES_PASSED, 0),
    REFUSED(GL_INVALID_ENUM, EndQuery, GL_TEXTURE_2D),
    REFUSED(GL_INVALID_OPERATION, EndQuery, GL_SAMPLES_PASSED),
    REFUSED(GL_INVALID_VALUE, GenQueries, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteQueries, -1, names),
    REFUSED(GL_INVALID_ENUM, GetQueryiv, GL_TEXTURE_2D, GL_CURRENT_QUERY, ints),
    REFUSED(GL_INVALID_ENUM, GetQueryiv, GL_SAMPLES_PASSED, GL_QUERY_RESULT, ints),
    REFUSED(GL_INVALID_OPERATION, GetQueryObjectiv, 99, GL_QUERY_RESULT, ints),
    REFUSED(GL_INVALID_OPERATION, GetQueryObjectuiv, 99, GL_QUERY_RESULT, names),
};

constexpr RefusedCall ActiveQuery[] = {
    REFUSED(GL_INVALID_OPERATION, BeginQuery, GL_SAMPLES_PASSED, 2),
    REFUSED(GL_INVALID_OPERATION, GetQueryObjectiv, 1, GL_QUERY_RESULT, ints),
    REFUSED(GL_INVALID_OPERATION, GetQueryObjectuiv, 1, GL_QUERY_RESULT, names),
};

constexpr RefusedCall EndedQuery[] = {
    REFUSED(GL_INVALID_ENUM, GetQueryObjectiv, 1, GL_CURRENT_QUERY, ints),
    REFUSED(GL_INVALID_ENUM, GetQueryObjectuiv, 1, GL_QUERY_COUNTER_BITS, names),
};

} // namespace

std::span<const Scene> query_scenes() {
    static const std::array all{
        Scene{"a fresh context", [] {}, Calls},
        Scene{"a query is active", [] { entry::BeginQuery(GL_SAMPLES_PASSED, 1); }, ActiveQuery},
        Scene{"a query has ended",
              [] {
                  entry::BeginQuery(GL_SAMPLES_PASSED, 1);
                  entry::EndQuery(GL_SAMPLES_PASSED);
              },
              EndedQuery},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
