// Pixel storage and transfer (GL 1.5, state tables 6.22 to 6.27).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"

#include <array>

namespace ffgpu::gl {

std::span<const StateVariable> pixel_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_PACK_SWAP_BYTES, boolean(c.client.pixel_store.pack.swap_bytes)),
        FFGPU_STATE(GL_PACK_LSB_FIRST, boolean(c.client.pixel_store.pack.lsb_first)),
        FFGPU_STATE(GL_PACK_INVERT_MESA, boolean(c.client.pixel_store.pack.invert)),
        FFGPU_STATE(GL_PACK_ROW_LENGTH, integer(c.client.pixel_store.pack.row_length)),
        FFGPU_STATE(GL_PACK_IMAGE_HEIGHT, integer(c.client.pixel_store.pack.image_height)),
        FFGPU_STATE(GL_PACK_SKIP_PIXELS, integer(c.client.pixel_store.pack.skip_pixels)),
        FFGPU_STATE(GL_PACK_SKIP_ROWS, integer(c.client.pixel_store.pack.skip_rows)),
        FFGPU_STATE(GL_PACK_SKIP_IMAGES, integer(c.client.pixel_store.pack.skip_images)),
        FFGPU_STATE(GL_PACK_ALIGNMENT, integer(c.client.pixel_store.pack.alignment)),
        FFGPU_STATE(GL_UNPACK_SWAP_BYTES, boolean(c.client.pixel_store.unpack.swap_bytes)),
        FFGPU_STATE(GL_UNPACK_LSB_FIRST, boolean(c.client.pixel_store.unpack.lsb_first)),
        FFGPU_STATE(GL_UNPACK_ROW_LENGTH, integer(c.client.pixel_store.unpack.row_length)),
        FFGPU_STATE(GL_UNPACK_IMAGE_HEIGHT, integer(c.client.pixel_store.unpack.image_height)),
        FFGPU_STATE(GL_UNPACK_SKIP_PIXELS, integer(c.client.pixel_store.unpack.skip_pixels)),
        FFGPU_STATE(GL_UNPACK_SKIP_ROWS, integer(c.client.pixel_store.unpack.skip_rows)),
        FFGPU_STATE(GL_UNPACK_SKIP_IMAGES, integer(c.client.pixel_store.unpack.skip_images)),
        FFGPU_STATE(GL_UNPACK_ALIGNMENT, integer(c.client.pixel_store.unpack.alignment)),
        FFGPU_STATE(GL_IMPLEMENTATION_COLOR_READ_FORMAT, integer(GL_RGBA)), // OES_read_format
        FFGPU_STATE(GL_IMPLEMENTATION_COLOR_READ_TYPE, integer(GL_UNSIGNED_BYTE)),
        FFGPU_STATE(GL_MAP_COLOR, boolean(s.pixel.map_color)),
        FFGPU_STATE(GL_MAP_STENCIL, boolean(s.pixel.map_stencil)),
        FFGPU_STATE(GL_INDEX_SHIFT, integer(s.pixel.index_shift)),
        FFGPU_STATE(GL_INDEX_OFFSET, integer(s.pixel.index_offset)),
        FFGPU_STATE(GL_RED_SCALE, real(s.pixel.scale[0])),
        FFGPU_STATE(GL_RED_BIAS, real(s.pixel.bias[0])),
        FFGPU_STATE(GL_GREEN_SCALE, real(s.pixel.scale[1])),
        FFGPU_STATE(GL_GREEN_BIAS, real(s.pixel.bias[1])),
        FFGPU_STATE(GL_BLUE_SCALE, real(s.pixel.scale[2])),
        FFGPU_STATE(GL_BLUE_BIAS, real(s.pixel.bias[2])),
        FFGPU_STATE(GL_ALPHA_SCALE, real(s.pixel.scale[3])),
        FFGPU_STATE(GL_ALPHA_BIAS, real(s.pixel.bias[3])),
        FFGPU_STATE(GL_DEPTH_SCALE, real(s.pixel.depth_scale)),
        FFGPU_STATE(GL_DEPTH_BIAS, real(s.pixel.depth_bias)),
        FFGPU_STATE(GL_ZOOM_X, real(s.pixel.zoom_x)),
        FFGPU_STATE(GL_ZOOM_Y, real(s.pixel.zoom_y)),
        FFGPU_STATE(GL_PIXEL_MAP_I_TO_I_SIZE, integer(s.pixel.map(PixelMapName::IToI).size())),
        FFGPU_STATE(GL_PIXEL_MAP_S_TO_S_SIZE, integer(s.pixel.map(PixelMapName::SToS).size())),
        FFGPU_STATE(GL_PIXEL_MAP_I_TO_R_SIZE, integer(s.pixel.map(PixelMapName::IToR).size())),
        FFGPU_STATE(GL_PIXEL_MAP_I_TO_G_SIZE, integer(s.pixel.map(PixelMapName::IToG).size())),
        FFGPU_STATE(GL_PIXEL_MAP_I_TO_B_SIZE, integer(s.pixel.map(PixelMapName::IToB).size())),
        FFGPU_STATE(GL_PIXEL_MAP_I_TO_A_SIZE, integer(s.pixel.map(PixelMapName::IToA).size())),
        FFGPU_STATE(GL_PIXEL_MAP_R_TO_R_SIZE, integer(s.pixel.map(PixelMapName::RToR).size())),
        FFGPU_STATE(GL_PIXEL_MAP_G_TO_G_SIZE, integer(s.pixel.map(PixelMapName::GToG).size())),
        FFGPU_STATE(GL_PIXEL_MAP_B_TO_B_SIZE, integer(s.pixel.map(PixelMapName::BToB).size())),
        FFGPU_STATE(GL_PIXEL_MAP_A_TO_A_SIZE, integer(s.pixel.map(PixelMapName::AToA).size())),
    };
    return Table;
}

} // namespace ffgpu::gl
