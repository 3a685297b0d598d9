// The vertex arrays by the tokens of glEnableClientState.

#pragma once

#include "driver/state/vertex_array_state.h"

namespace ffgpu::gl {

// GL_TEXTURE_COORD_ARRAY is the client active unit's. Null: no such array.
const VertexArray* find_client_array(const VertexArrayState& state, GLenum token);

} // namespace ffgpu::gl
