#include "driver/pixel/pixel_format.h"

namespace ffgpu::gl {

ComponentOrder component_order(GLenum format) {
    switch (format) {
    case GL_COLOR_INDEX:
        return {PixelKind::Index, 1};
    case GL_STENCIL_INDEX:
        return {PixelKind::Stencil, 1};
    case GL_DEPTH_COMPONENT:
        return {PixelKind::Depth, 1};
    case GL_DEPTH_STENCIL:
        return {PixelKind::DepthStencil, 1};
    case GL_RED:
        return {PixelKind::Color, 1, {0}};
    case GL_GREEN:
        return {PixelKind::Color, 1, {1}};
    case GL_BLUE:
        return {PixelKind::Color, 1, {2}};
    case GL_ALPHA:
        return {PixelKind::Color, 1, {3}};
    case GL_RGB:
        return {PixelKind::Color, 3, {0, 1, 2}};
    case GL_RGBA:
        return {PixelKind::Color, 4, {0, 1, 2, 3}};
    case GL_BGR:
        return {PixelKind::Color, 3, {2, 1, 0}};
    case GL_BGRA:
        return {PixelKind::Color, 4, {2, 1, 0, 3}};
    case GL_ABGR_EXT:
        return {PixelKind::Color, 4, {3, 2, 1, 0}};
    case GL_LUMINANCE:
        return {PixelKind::Color, 1, {0}, true};
    case GL_LUMINANCE_ALPHA:
        return {PixelKind::Color, 2, {0, 3}, true};
    default:
        return {};
    }
}

PackedType packed_type(GLenum type) {
    switch (type) {
    case GL_UNSIGNED_BYTE_3_3_2:
        return {3, 1, {{{5, 3}, {2, 3}, {0, 2}, {}}}};
    case GL_UNSIGNED_BYTE_2_3_3_REV:
        return {3, 1, {{{0, 3}, {3, 3}, {6, 2}, {}}}};
    case GL_UNSIGNED_SHORT_5_6_5:
        return {3, 2, {{{11, 5}, {5, 6}, {0, 5}, {}}}};
    case GL_UNSIGNED_SHORT_5_6_5_REV:
        return {3, 2, {{{0, 5}, {5, 6}, {11, 5}, {}}}};
    case GL_UNSIGNED_SHORT_4_4_4_4:
        return {4, 2, {{{12, 4}, {8, 4}, {4, 4}, {0, 4}}}};
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
        return {4, 2, {{{0, 4}, {4, 4}, {8, 4}, {12, 4}}}};
    case GL_UNSIGNED_SHORT_5_5_5_1:
        return {4, 2, {{{11, 5}, {6, 5}, {1, 5}, {0, 1}}}};
    case GL_UNSIGNED_SHORT_1_5_5_5_REV:
        return {4, 2, {{{0, 5}, {5, 5}, {10, 5}, {15, 1}}}};
    case GL_UNSIGNED_INT_8_8_8_8:
        return {4, 4, {{{24, 8}, {16, 8}, {8, 8}, {0, 8}}}};
    case GL_UNSIGNED_INT_8_8_8_8_REV:
        return {4, 4, {{{0, 8}, {8, 8}, {16, 8}, {24, 8}}}};
    case GL_UNSIGNED_INT_10_10_10_2:
        return {4, 4, {{{22, 10}, {12, 10}, {2, 10}, {0, 2}}}};
    case GL_UNSIGNED_INT_2_10_10_10_REV:
        return {4, 4, {{{0, 10}, {10, 10}, {20, 10}, {30, 2}}}};
    default:
        return {};
    }
}

unsigned type_bytes(GLenum type) {
    switch (type) {
    case GL_BITMAP:
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT:
        return 2;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_UNSIGNED_INT_24_8:
        return 4;
    default:
        return packed_type(type).bytes;
    }
}

unsigned pixel_bytes(GLenum format, GLenum type) {
    const unsigned components = packed_type(type).count > 0 ? 1 : component_order(format).count;
    return components * type_bytes(type);
}

GLenum format_type_error(GLenum format, GLenum type) {
    const ComponentOrder order = component_order(format);
    if (type_bytes(type) == 0) return GL_INVALID_ENUM;
    // GL 1.5, table 3.8: three fields are RGB, four are RGBA or BGRA (with EXT_abgr, ABGR),
    // whatever else the format is.
    if (const unsigned fields = packed_type(type).count; fields != 0) {
        const bool fits = fields == 3 ? format == GL_RGB : order.count == 4;
        return fits ? GL_NO_ERROR : GL_INVALID_OPERATION;
    }
    const bool both = order.kind == PixelKind::DepthStencil;
    if (type == GL_UNSIGNED_INT_24_8) return both ? GL_NO_ERROR : GL_INVALID_OPERATION;
    if (order.count == 0 || both) return GL_INVALID_ENUM;
    const bool is_index = order.kind == PixelKind::Index || order.kind == PixelKind::Stencil;
    return type == GL_BITMAP && !is_index ? GL_INVALID_ENUM : GL_NO_ERROR;
}

} // namespace ffgpu::gl
