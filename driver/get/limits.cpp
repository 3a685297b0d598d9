// Sizes of the implementation (GL 1.5, state tables 6.31 to 6.33).

#include "driver/limits.h"

#include "driver/context/context.h"
#include "driver/get/state_variable.h"
#include "driver/objects/framebuffer_object.h"

#include <array>

namespace ffgpu::gl {

std::span<const StateVariable> limit_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_MAX_LIGHTS, integer(Lights)),
        FFGPU_STATE(GL_MAX_CLIP_PLANES, integer(ClipPlanes)),
        FFGPU_STATE(GL_MAX_MODELVIEW_STACK_DEPTH, integer(ModelViewStackDepth)),
        FFGPU_STATE(GL_MAX_PROJECTION_STACK_DEPTH, integer(ProjectionStackDepth)),
        FFGPU_STATE(GL_MAX_TEXTURE_STACK_DEPTH, integer(TextureStackDepth)),
        FFGPU_STATE(GL_SUBPIXEL_BITS, integer(SubPixelBits)),
        FFGPU_STATE(GL_MAX_TEXTURE_SIZE, integer(MaxTextureSize)),
        FFGPU_STATE(GL_MAX_3D_TEXTURE_SIZE, integer(MaxTexture3dSize)),
        FFGPU_STATE(GL_MAX_CUBE_MAP_TEXTURE_SIZE, integer(MaxTextureSize)),
        FFGPU_STATE(GL_MAX_RECTANGLE_TEXTURE_SIZE, integer(MaxTextureSize)),
        FFGPU_STATE(GL_MAX_TEXTURE_LOD_BIAS, real(MaxLodBias)),
        FFGPU_STATE(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, real(MaxAnisotropy)),
        FFGPU_STATE(GL_MAX_TEXTURE_UNITS, integer(TextureUnits)),
        FFGPU_STATE(GL_MAX_PIXEL_MAP_TABLE, integer(MaxPixelMapTable)),
        FFGPU_STATE(GL_MAX_NAME_STACK_DEPTH, integer(NameStackDepth)),
        FFGPU_STATE(GL_MAX_LIST_NESTING, integer(MaxListNesting)),
        FFGPU_STATE(GL_MAX_EVAL_ORDER, integer(MaxEvaluatorOrder)),
        FFGPU_STATE(GL_MAX_VIEWPORT_DIMS, integer(MaxSurfaceSize, MaxSurfaceSize)),
        FFGPU_STATE(GL_MAX_ATTRIB_STACK_DEPTH, integer(AttributeStackDepth)),
        FFGPU_STATE(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, integer(ClientAttributeStackDepth)),
        FFGPU_STATE(GL_MAX_ELEMENTS_VERTICES, integer(MaxElementsVertices)),
        FFGPU_STATE(GL_MAX_ELEMENTS_INDICES, integer(MaxElementsIndices)),
        FFGPU_STATE(GL_MAX_RENDERBUFFER_SIZE, integer(MaxSurfaceSize)),
        FFGPU_STATE(GL_MAX_COLOR_ATTACHMENTS, integer(MaxColorAttachments)),
        FFGPU_STATE(GL_MAX_DRAW_BUFFERS, integer(ColorTargets)),
        FFGPU_STATE(GL_MAX_SAMPLES, integer(MaxSamples)),
        FFGPU_STATE(GL_ALIASED_POINT_SIZE_RANGE, real(1, MaxPointSize)),
        FFGPU_STATE(GL_SMOOTH_POINT_SIZE_RANGE, real(1, MaxPointSize)),
        FFGPU_STATE(GL_SMOOTH_POINT_SIZE_GRANULARITY, real(PointSizeGranularity)),
        FFGPU_STATE(GL_ALIASED_LINE_WIDTH_RANGE, real(1, MaxLineWidth)),
        FFGPU_STATE(GL_SMOOTH_LINE_WIDTH_RANGE, real(1, MaxLineWidth)),
        FFGPU_STATE(GL_SMOOTH_LINE_WIDTH_GRANULARITY, real(LineWidthGranularity)),
        FFGPU_STATE(GL_NUM_COMPRESSED_TEXTURE_FORMATS, integer(CompressedTextureFormats.size())),
        FFGPU_STATE(GL_COMPRESSED_TEXTURE_FORMATS, integer(CompressedTextureFormats)),
    };
    return Table;
}

} // namespace ffgpu::gl
