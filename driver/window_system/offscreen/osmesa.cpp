#include "driver/window_system/offscreen/osmesa.h"

#include "driver/context/offscreen.h"
#include "driver/window_system/exports/proc_address.h"
#include "driver/window_system/process_gpu.h"
#include "driver/window_system/turn.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#define FFGPU_EXPORT extern "C" __attribute__((visibility("default")))

using ffgpu::gl::ProcessGpu;
using ffgpu::gl::Turn;

// An off-screen context and the program's memory that it is shown in.
struct osmesa_context {
    GLenum format = OSMESA_RGBA;
    std::unique_ptr<ffgpu::gl::OffscreenContext> context;

    std::byte* buffer = nullptr;
    GLenum type = GL_UNSIGNED_BYTE;
    GLsizei width = 0, height = 0;
    GLint row_length = 0;
    bool y_up = true;
    std::vector<std::uint8_t> rows;   // of the picture, as the device has them
    std::vector<std::uint32_t> depth; // what OSMesaGetDepthBuffer handed out
};

namespace {

thread_local OSMesaContext current = nullptr;

// Byte places of r, g, b, a in a pixel, and its size.
struct ChannelOrder {
    int r, g, b, a, bytes; // a < 0: none
};

ChannelOrder channel_order(GLenum format) {
    switch (format) {
    case OSMESA_BGRA:
        return {2, 1, 0, 3, 4};
    case OSMESA_ARGB:
        return {1, 2, 3, 0, 4};
    case OSMESA_RGB:
        return {0, 1, 2, -1, 3};
    case OSMESA_BGR:
        return {2, 1, 0, -1, 3};
    case OSMESA_RGB_565:
        return {0, 0, 0, -1, 2};
    default:
        return {0, 1, 2, 3, 4};
    }
}

bool is_known_format(GLenum format) {
    return format == OSMESA_RGBA || format == OSMESA_BGRA || format == OSMESA_ARGB ||
           format == OSMESA_RGB || format == OSMESA_BGR || format == OSMESA_RGB_565;
}

void store_row(const osmesa_context& to, const std::uint8_t* rgba, std::byte* out) {
    if (to.format == OSMESA_RGBA) { // as the device has it
        std::memcpy(out, rgba, 4 * static_cast<std::size_t>(to.width));
        return;
    }
    const ChannelOrder order = channel_order(to.format);
    for (GLsizei x = 0; x < to.width; ++x, rgba += 4, out += order.bytes) {
        if (to.format == OSMESA_RGB_565) {
            const auto packed = static_cast<std::uint16_t>((rgba[0] >> 3) << 11 |
                                                           (rgba[1] >> 2) << 5 | rgba[2] >> 3);
            out[0] = static_cast<std::byte>(packed & 0xff);
            out[1] = static_cast<std::byte>(packed >> 8);
            continue;
        }
        out[order.r] = static_cast<std::byte>(rgba[0]);
        out[order.g] = static_cast<std::byte>(rgba[1]);
        out[order.b] = static_cast<std::byte>(rgba[2]);
        if (order.a >= 0) out[order.a] = static_cast<std::byte>(rgba[3]);
    }
}

// Copies the picture into the program's buffer.
void present(osmesa_context& to) {
    const ffgpu::Surface surface = to.context->drawable().readable_front();
    if (!to.buffer || surface.format == ffgpu::Format::None) return;
    ffgpu::Device& device = ProcessGpu::instance().device();
    const auto pixels = static_cast<std::size_t>(to.row_length > 0 ? to.row_length : to.width);
    const std::size_t bytes = std::size_t{surface.stride} * static_cast<std::size_t>(to.height);
    const bool as_in_device = to.format == OSMESA_RGBA && to.y_up &&
                              pixels == static_cast<std::size_t>(to.width) &&
                              surface.stride == 4 * pixels;
    if (as_in_device) return device.read_memory(surface.address, {to.buffer, bytes});
    std::vector<std::uint8_t>& rgba = to.rows;
    rgba.resize(bytes);
    device.read_memory(surface.address, std::as_writable_bytes(std::span(rgba)));
    const std::size_t out_stride =
        pixels * static_cast<std::size_t>(channel_order(to.format).bytes);
    for (GLsizei y = 0; y < to.height; ++y) {
        const auto row = static_cast<std::size_t>(to.y_up ? y : to.height - 1 - y);
        store_row(
            to, &rgba[static_cast<std::size_t>(y) * surface.stride], to.buffer + row * out_stride);
    }
}

OSMesaContext create(GLenum format,
                     GLint depth_bits,
                     GLint stencil_bits,
                     GLint accumulation_bits,
                     OSMesaContext share) {
    if (!is_known_format(format)) return nullptr;
    const Turn turn;
    ProcessGpu& gpu = ProcessGpu::instance();
    const bool stencil = stencil_bits > 0;
    const int depth = stencil || depth_bits > 16 ? 24 : depth_bits > 0 ? 16 : 0;
    try {
        auto made = std::make_unique<osmesa_context>();
        made->format = format;
        made->context = std::make_unique<ffgpu::gl::OffscreenContext>(
            gpu.device(),
            ffgpu::gl::OffscreenContext::Options{
                .format = {.double_buffer = false,
                           .alpha = channel_order(format).a >= 0,
                           .depth_bits = static_cast<std::uint8_t>(depth),
                           .stencil_bits = static_cast<std::uint8_t>(stencil ? 8 : 0),
                           .accumulation = accumulation_bits > 0,
                           .supersampling =
                               static_cast<std::uint8_t>(gpu.control_panel().supersampling)},
                .shared = share ? share->context->shared() : gpu.make_shared_objects()});
        made->context->context().on_flush = [context = made.get()] { present(*context); };
        return made.release();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

} // namespace

FFGPU_EXPORT OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext sharelist) {
    return create(format, 24, 8, 16, sharelist);
}

FFGPU_EXPORT OSMesaContext OSMesaCreateContextExt(
    GLenum format, GLint depthBits, GLint stencilBits, GLint accumBits, OSMesaContext sharelist) {
    return create(format, depthBits, stencilBits, accumBits, sharelist);
}

FFGPU_EXPORT OSMesaContext OSMesaCreateContextAttribs(const int* attribList,
                                                      OSMesaContext sharelist) {
    GLenum format = OSMESA_RGBA;
    GLint depth = 0, stencil = 0, accumulation = 0;
    for (const int* at = attribList; at && at[0] != 0; at += 2) {
        switch (at[0]) {
        case OSMESA_FORMAT:
            format = static_cast<GLenum>(at[1]);
            break;
        case OSMESA_DEPTH_BITS:
            depth = at[1];
            break;
        case OSMESA_STENCIL_BITS:
            stencil = at[1];
            break;
        case OSMESA_ACCUM_BITS:
            accumulation = at[1];
            break;
        case OSMESA_PROFILE:
            if (at[1] != OSMESA_COMPAT_PROFILE) return nullptr;
            break;
        case OSMESA_CONTEXT_MAJOR_VERSION:
            if (at[1] > 1) return nullptr;
            break;
        case OSMESA_CONTEXT_MINOR_VERSION:
            break;
        default:
            return nullptr;
        }
    }
    return create(format, depth, stencil, accumulation, sharelist);
}

FFGPU_EXPORT void OSMesaDestroyContext(OSMesaContext ctx) {
    const Turn turn;
    if (current == ctx) current = nullptr;
    delete ctx;
}

FFGPU_EXPORT GLboolean
OSMesaMakeCurrent(OSMesaContext ctx, void* buffer, GLenum type, GLsizei width, GLsizei height) {
    const Turn turn;
    if (!ctx) {
        ffgpu::gl::make_current(nullptr, nullptr, nullptr);
        current = nullptr;
        return GL_TRUE;
    }
    const GLenum wanted =
        ctx->format == OSMESA_RGB_565 ? GL_UNSIGNED_SHORT_5_6_5 : GL_UNSIGNED_BYTE;
    const auto limit = static_cast<GLsizei>(ffgpu::MaxSurfaceSize);
    if (!buffer || type != wanted || width < 1 || height < 1 || width > limit || height > limit)
        return GL_FALSE;
    try {
        ctx->context->drawable().resize(static_cast<unsigned>(width),
                                        static_cast<unsigned>(height));
    } catch (const std::bad_alloc&) {
        return GL_FALSE;
    }
    ctx->buffer = static_cast<std::byte*>(buffer);
    ctx->type = type;
    ctx->width = width;
    ctx->height = height;
    ctx->context->make_current();
    current = ctx;
    return GL_TRUE;
}

FFGPU_EXPORT OSMesaContext OSMesaGetCurrentContext() {
    return current;
}

FFGPU_EXPORT void OSMesaPixelStore(GLint pname, GLint value) {
    if (!current) return;
    if (pname == OSMESA_ROW_LENGTH && value >= 0) current->row_length = value;
    if (pname == OSMESA_Y_UP) current->y_up = value != 0;
}

FFGPU_EXPORT void OSMesaGetIntegerv(GLint pname, GLint* value) {
    *value = 0;
    if (pname == OSMESA_MAX_WIDTH || pname == OSMESA_MAX_HEIGHT) {
        *value = static_cast<GLint>(ffgpu::MaxSurfaceSize);
        return;
    }
    if (!current) return;
    switch (pname) {
    case OSMESA_WIDTH:
        *value = current->width;
        break;
    case OSMESA_HEIGHT:
        *value = current->height;
        break;
    case OSMESA_FORMAT:
        *value = static_cast<GLint>(current->format);
        break;
    case OSMESA_TYPE:
        *value = static_cast<GLint>(current->type);
        break;
    case OSMESA_ROW_LENGTH:
        *value = current->row_length;
        break;
    case OSMESA_Y_UP:
        *value = current->y_up;
        break;
    default:
        break;
    }
}

// The depth buffer as it is now, in 32-bit words of depth in the upper bits; valid until the next
// call.
FFGPU_EXPORT GLboolean OSMesaGetDepthBuffer(
    OSMesaContext c, GLint* width, GLint* height, GLint* bytesPerValue, void** buffer) {
    const Turn turn;
    if (!c || c->context->drawable().depth().format != ffgpu::Format::Depth24Stencil8)
        return GL_FALSE;
    c->context->context().flush_vertices();
    const ffgpu::Surface surface = c->context->drawable().readable_depth();
    c->depth.resize(std::size_t{surface.stride} / 4 * surface.height);
    ProcessGpu::instance().device().read_memory(surface.address,
                                                std::as_writable_bytes(std::span(c->depth)));
    *width = static_cast<GLint>(surface.stride / 4);
    *height = surface.height;
    *bytesPerValue = 4;
    *buffer = c->depth.data();
    return GL_TRUE;
}

FFGPU_EXPORT GLboolean
OSMesaGetColorBuffer(OSMesaContext c, GLint* width, GLint* height, GLint* format, void** buffer) {
    if (!c || !c->buffer) return GL_FALSE;
    *width = c->width;
    *height = c->height;
    *format = static_cast<GLint>(c->format);
    *buffer = c->buffer;
    return GL_TRUE;
}

FFGPU_EXPORT OSMESAproc OSMesaGetProcAddress(const char* funcName) {
    return ffgpu::gl::find_gl_function(funcName);
}

FFGPU_EXPORT void OSMesaColorClamp(GLboolean) {}
FFGPU_EXPORT void OSMesaPostprocess(OSMesaContext, const char*, unsigned) {}
