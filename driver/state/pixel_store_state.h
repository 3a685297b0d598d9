// How pixels lie in the application's memory (glPixelStore; GL 1.5, table 3.1 and 4.3.2).

#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

struct PixelStore {
    bool swap_bytes = false;
    bool lsb_first = false;
    GLint row_length = 0; // 0: the width of the image
    GLint image_height = 0;
    GLint skip_pixels = 0;
    GLint skip_rows = 0;
    GLint skip_images = 0;
    GLint alignment = 4;
    bool invert = false; // MESA_pack_invert: rows from the top down; of pack alone
};

struct PixelStoreState {
    PixelStore pack;   // to the application: glReadPixels, glGetTexImage ...
    PixelStore unpack; // from the application: glDrawPixels, glTexImage2D ...
};

} // namespace ffgpu::gl
