#include "driver/get/client_arrays.h"

namespace ffgpu::gl {

const VertexArray* find_client_array(const VertexArrayState& state, GLenum token) {
    switch (token) {
    case GL_VERTEX_ARRAY:
        return &state.of(Attribute::Position);
    case GL_NORMAL_ARRAY:
        return &state.of(Attribute::Normal);
    case GL_COLOR_ARRAY:
        return &state.of(Attribute::Color);
    case GL_SECONDARY_COLOR_ARRAY:
        return &state.of(Attribute::SecondaryColor);
    case GL_FOG_COORD_ARRAY:
        return &state.of(Attribute::FogCoordinate);
    case GL_EDGE_FLAG_ARRAY:
        return &state.of(Attribute::EdgeFlag);
    case GL_TEXTURE_COORD_ARRAY:
        return &state.of(tex_coord(state.active_unit));
    case GL_INDEX_ARRAY:
        return &state.object->color_index;
    default:
        return nullptr;
    }
}

} // namespace ffgpu::gl
