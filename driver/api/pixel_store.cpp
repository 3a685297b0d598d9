// glPixelStore (GL 1.5, 3.6.1).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/conversion.h"

namespace ffgpu::gl::api {
namespace {

struct Place {
    PixelStore* store = nullptr; // null: there is no such parameter
    bool PixelStore::*flag = nullptr;
    GLint PixelStore::*number = nullptr;
};

Place find_parameter(PixelStoreState& state, GLenum name) {
    switch (name) {
    case GL_UNPACK_SWAP_BYTES:
        return {&state.unpack, &PixelStore::swap_bytes};
    case GL_UNPACK_LSB_FIRST:
        return {&state.unpack, &PixelStore::lsb_first};
    case GL_UNPACK_ROW_LENGTH:
        return {&state.unpack, nullptr, &PixelStore::row_length};
    case GL_UNPACK_IMAGE_HEIGHT:
        return {&state.unpack, nullptr, &PixelStore::image_height};
    case GL_UNPACK_SKIP_PIXELS:
        return {&state.unpack, nullptr, &PixelStore::skip_pixels};
    case GL_UNPACK_SKIP_ROWS:
        return {&state.unpack, nullptr, &PixelStore::skip_rows};
    case GL_UNPACK_SKIP_IMAGES:
        return {&state.unpack, nullptr, &PixelStore::skip_images};
    case GL_UNPACK_ALIGNMENT:
        return {&state.unpack, nullptr, &PixelStore::alignment};
    case GL_PACK_SWAP_BYTES:
        return {&state.pack, &PixelStore::swap_bytes};
    case GL_PACK_LSB_FIRST:
        return {&state.pack, &PixelStore::lsb_first};
    case GL_PACK_INVERT_MESA:
        return {&state.pack, &PixelStore::invert};
    case GL_PACK_ROW_LENGTH:
        return {&state.pack, nullptr, &PixelStore::row_length};
    case GL_PACK_IMAGE_HEIGHT:
        return {&state.pack, nullptr, &PixelStore::image_height};
    case GL_PACK_SKIP_PIXELS:
        return {&state.pack, nullptr, &PixelStore::skip_pixels};
    case GL_PACK_SKIP_ROWS:
        return {&state.pack, nullptr, &PixelStore::skip_rows};
    case GL_PACK_SKIP_IMAGES:
        return {&state.pack, nullptr, &PixelStore::skip_images};
    case GL_PACK_ALIGNMENT:
        return {&state.pack, nullptr, &PixelStore::alignment};
    default:
        return {};
    }
}

bool is_valid(GLint PixelStore::*number, GLint value) {
    if (number == &PixelStore::alignment)
        return value == 1 || value == 2 || value == 4 || value == 8;
    return value >= 0;
}

} // namespace

void PixelStorei(Context& context, GLenum pname, GLint param) {
    const Place place = find_parameter(context.client.pixel_store, pname);
    if (!place.store) return context.error(GL_INVALID_ENUM);
    if (place.flag) {
        place.store->*place.flag = param != 0;
    } else if (is_valid(place.number, param)) {
        place.store->*place.number = param;
    } else {
        context.error(GL_INVALID_VALUE);
    }
}

void PixelStoref(Context& context, GLenum pname, GLfloat param) {
    const Place place = find_parameter(context.client.pixel_store, pname);
    PixelStorei(context, pname, place.flag ? param != 0 : round_to_int(static_cast<double>(param)));
}

} // namespace ffgpu::gl::api
