#include "driver/images/draw_buffers.h"

#include "driver/device_context/device_context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/framebuffer_object.h"

namespace ffgpu::gl {

GLenum draw_buffers_error(DeviceContext& context, PixelKind kind) {
    bool depth = false, stencil = false;
    if (const auto& object = context.state.framebuffer.draw_object) {
        if (framebuffer_status(*object) != GL_FRAMEBUFFER_COMPLETE)
            return GL_INVALID_FRAMEBUFFER_OPERATION;
        depth = has_depth(*object);
        stencil = has_stencil(*object);
    } else if (const Drawable* drawable = context.draw_drawable()) {
        depth = drawable->format().depth_bits > 0;
        stencil = drawable->format().stencil_bits > 0;
    }
    const bool needs_depth = kind == PixelKind::Depth || kind == PixelKind::DepthStencil;
    const bool needs_stencil = kind == PixelKind::Stencil || kind == PixelKind::DepthStencil;
    const bool found = (!needs_depth || depth) && (!needs_stencil || stencil);
    return found ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

} // namespace ffgpu::gl
