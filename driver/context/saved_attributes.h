// What the attribute stacks keep. Only the groups in `mask` hold a value.

#pragma once

#include "driver/gl_types.h"
#include "driver/state/state.h"
#include "driver/texture/saved_textures.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace ffgpu::gl {

// GL 1.5, state tables 6.5 to 6.35, column "attribute".
struct SavedAttributes {
    GLbitfield mask = 0;

    CurrentState current;                    // GL_CURRENT_BIT
    PointState point;                        // GL_POINT_BIT
    std::uint8_t coord_replace = 0;          //   and one bit a texture unit
    LineState line;                          // GL_LINE_BIT
    PolygonState polygon;                    // GL_POLYGON_BIT
    PolygonStipplePattern polygon_stipple{}; // GL_POLYGON_STIPPLE_BIT
    PixelState pixel;                        // GL_PIXEL_MODE_BIT: without the maps
    GLenum read_buffer = GL_NONE;            //   and this
    LightingState lighting;                  // GL_LIGHTING_BIT
    FogState fog;                            // GL_FOG_BIT
    DepthState depth;                        // GL_DEPTH_BUFFER_BIT
    Vec4 clear_accum{};                      // GL_ACCUM_BUFFER_BIT
    StencilState stencil;                    // GL_STENCIL_BUFFER_BIT
    ViewportState viewport;                  // GL_VIEWPORT_BIT
    TransformGroup transform;                // GL_TRANSFORM_BIT
    std::vector<bool> capabilities;          // GL_ENABLE_BIT: by for_each_capability_flag
    AlphaTestState alpha_test;               // GL_COLOR_BUFFER_BIT
    BlendState blend;                        //   and these
    DrawBufferList draw_buffers{};
    std::array<bool, 4> color_mask{};
    GLuint index_mask = 0;
    Vec4 clear_color{};
    float clear_index = 0;
    HintState hint;                        // GL_HINT_BIT
    EvaluatorSettings evaluator;           // GL_EVAL_BIT
    GLuint list_base = 0;                  // GL_LIST_BIT
    std::optional<SavedTextures> textures; // GL_TEXTURE_BIT
    ScissorState scissor;                  // GL_SCISSOR_BIT
    MultisampleState multisample;          // GL_MULTISAMPLE_BIT
};

struct SavedClientAttributes {
    GLbitfield mask = 0;

    PixelStoreState pixel_store; // GL_CLIENT_PIXEL_STORE_BIT, with the pixel buffers
    BufferState buffers;
    std::optional<SavedVertexArrays> arrays; // GL_CLIENT_VERTEX_ARRAY_BIT, with the array buffer
};

} // namespace ffgpu::gl
