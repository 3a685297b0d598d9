// What glGet tells about the sizes of this implementation (GL 1.5, state tables 6.31 to 6.33). All
// that the device decides comes from model/device/layout/limits.h.

#pragma once

#include "driver/gl_types.h"
#include "model/device/layout/limits.h"

#include <array>

namespace ffgpu::gl {

constexpr unsigned AttributeStackDepth = 16;
constexpr unsigned ClientAttributeStackDepth = 16;
constexpr unsigned NameStackDepth = 64;
constexpr unsigned MaxListNesting = 64;
constexpr unsigned MaxEvaluatorOrder = 30;
constexpr unsigned MaxPixelMapTable = 256;
constexpr unsigned MaxElementsVertices = 65536; // the recommended size of one glDrawRangeElements
constexpr unsigned MaxElementsIndices = 65536;

constexpr float MaxPointSize = 256;
constexpr float PointSizeGranularity = 0.125f;
constexpr float MaxLineWidth = 64;
constexpr float LineWidthGranularity = 0.125f;
constexpr float OffsetUnitsInRange = (1u << 24) - 1; // EXT_polygon_offset counts depth in [0, 1]
constexpr float MaxLodBias = 15;
constexpr float MaxAnisotropy = 16;

constexpr unsigned QueryCounterBits = 64; // of glGetQueryiv; 32 reach the application
constexpr unsigned AccumulationBits = 16;

constexpr std::array<GLenum, 5> CompressedTextureFormats{
    GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
    GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
    GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
    GL_COMPRESSED_RGB_FXT1_3DFX,
    GL_COMPRESSED_RGBA_FXT1_3DFX,
};

} // namespace ffgpu::gl
