// Pixel rectangles, maps, and bitmaps; also through pixel buffers that are too small.

#include "driver/limits.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr GLenum UB = GL_UNSIGNED_BYTE;
constexpr GLsizei TooLong = MaxPixelMapTable + 1;

constexpr RefusedCall Calls[] = {
    REFUSED(GL_INVALID_VALUE, Bitmap, -1, 1, 0, 0, 0, 0, bytes),
    REFUSED(GL_INVALID_VALUE, Bitmap, 1, -1, 0, 0, 0, 0, bytes),
    REFUSED(GL_INVALID_ENUM, CopyPixels, 0, 0, 1, 1, GL_RGBA),
    REFUSED(GL_INVALID_VALUE, CopyPixels, 0, 0, -1, 1, GL_COLOR),
    REFUSED(GL_INVALID_VALUE, DrawPixels, -1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, DrawPixels, 1, 1, GL_FRONT, UB, bytes),
    REFUSED(GL_INVALID_ENUM, DrawPixels, 1, 1, GL_RGBA, GL_DOUBLE, bytes),
    REFUSED(GL_INVALID_ENUM, DrawPixels, 1, 1, GL_RGBA, GL_BITMAP, bytes),
    REFUSED(GL_INVALID_OPERATION, DrawPixels, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, bytes),
    REFUSED(GL_INVALID_OPERATION, DrawPixels, 1, 1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, bytes),
    REFUSED(GL_INVALID_VALUE, ReadPixels, 0, 0, 1, -1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_ENUM, ReadPixels, 0, 0, 1, 1, GL_BACK, UB, bytes),
    REFUSED(GL_INVALID_ENUM, ReadPixels, 0, 0, 1, 1, GL_RGBA, GL_BACK, bytes),
    REFUSED(GL_INVALID_OPERATION, ReadPixels, 0, 0, 1, 1, GL_COLOR_INDEX, UB, bytes),
    REFUSED(GL_INVALID_OPERATION, ReadPixels, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, bytes),
    REFUSED(GL_INVALID_ENUM, PixelMapfv, GL_PIXEL_MAP_A_TO_A + 1, 1, floats),
    REFUSED(GL_INVALID_VALUE, PixelMapfv, GL_PIXEL_MAP_R_TO_R, 0, floats),
    REFUSED(GL_INVALID_VALUE, PixelMapfv, GL_PIXEL_MAP_R_TO_R, TooLong, floats),
    REFUSED(GL_INVALID_VALUE, PixelMapfv, GL_PIXEL_MAP_I_TO_R, 3, floats),
    REFUSED(GL_INVALID_ENUM, PixelMapuiv, GL_MAP_COLOR, 1, names),
    REFUSED(GL_INVALID_VALUE, PixelMapuiv, GL_PIXEL_MAP_S_TO_S, 3, names),
    REFUSED(GL_INVALID_ENUM, PixelMapusv, GL_PIXEL_MAP_I_TO_I - 1, 1, shorts),
    REFUSED(GL_INVALID_VALUE, PixelMapusv, GL_PIXEL_MAP_G_TO_G, -1, shorts),
};

// Eight bytes of pixels to be read from, and to be written to.
void bind_small_pixel_buffers() {
    entry::BindBuffer(GL_PIXEL_UNPACK_BUFFER, 1);
    entry::BufferData(GL_PIXEL_UNPACK_BUFFER, 8, nullptr, GL_STATIC_DRAW);
    entry::BindBuffer(GL_PIXEL_PACK_BUFFER, 2);
    entry::BufferData(GL_PIXEL_PACK_BUFFER, 8, nullptr, GL_STATIC_DRAW);
}

void map_pixel_buffers() {
    bind_small_pixel_buffers();
    entry::MapBuffer(GL_PIXEL_UNPACK_BUFFER, GL_READ_WRITE);
    entry::MapBuffer(GL_PIXEL_PACK_BUFFER, GL_READ_WRITE);
}

constexpr RefusedCall TooSmall[] = {
    REFUSED(GL_INVALID_OPERATION, DrawPixels, 3, 1, GL_RGBA, UB, nullptr),
    REFUSED(GL_INVALID_OPERATION, ReadPixels, 0, 0, 3, 1, GL_RGBA, UB, nullptr),
    REFUSED(GL_INVALID_OPERATION, Bitmap, 32, 3, 0, 0, 0, 0, nullptr),
    REFUSED(GL_INVALID_OPERATION, PolygonStipple, nullptr),
    REFUSED(GL_INVALID_OPERATION, GetPolygonStipple, nullptr),
    REFUSED(GL_INVALID_OPERATION, PixelMapfv, GL_PIXEL_MAP_R_TO_R, 4, nullptr),
    REFUSED(
        GL_INVALID_OPERATION, TexImage2D, GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, UB, nullptr),
};

constexpr RefusedCall Mapped[] = {
    REFUSED(GL_INVALID_OPERATION, DrawPixels, 1, 1, GL_RGBA, UB, nullptr),
    REFUSED(GL_INVALID_OPERATION, ReadPixels, 0, 0, 1, 1, GL_RGBA, UB, nullptr),
    REFUSED(GL_INVALID_OPERATION, Bitmap, 1, 1, 0, 0, 0, 0, nullptr),
    REFUSED(GL_INVALID_OPERATION, PixelMapuiv, GL_PIXEL_MAP_R_TO_R, 1, nullptr),
    REFUSED(GL_INVALID_OPERATION, GetPixelMapfv, GL_PIXEL_MAP_R_TO_R, nullptr),
};

} // namespace

std::span<const Scene> pixel_scenes() {
    static const std::array all{
        Scene{"a fresh context", [] {}, Calls},
        Scene{"pixel buffers of eight bytes", bind_small_pixel_buffers, TooSmall},
        Scene{"mapped pixel buffers", map_pixel_buffers, Mapped},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
