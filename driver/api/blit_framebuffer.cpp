// glBlitFramebuffer (EXT_framebuffer_blit, ARB_framebuffer_object).

#include "driver/context/context.h"
#include "driver/entry_points/declarations.h"
#include "driver/pixel/blit.h"

namespace ffgpu::gl::api {
namespace {

constexpr GLbitfield AllBuffers = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;

GLenum arguments_error(GLbitfield mask, GLenum filter) {
    if ((mask & ~AllBuffers) != 0) return GL_INVALID_VALUE;
    if (filter != GL_NEAREST && filter != GL_LINEAR) return GL_INVALID_ENUM;
    if (filter == GL_LINEAR && (mask & ~GLbitfield{GL_COLOR_BUFFER_BIT}) != 0)
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

PixelRectangle rectangle_of(const ffgpu::Scissor& scissor) {
    return {scissor.x, scissor.y, scissor.width, scissor.height};
}

// Neither scaled nor mirrored: the device copies. Pixels from outside of the source are left out.
void copy_colors(Context& context, const Surface& from, const Surface& to, const Blit& blit) {
    const std::int64_t shift_x = blit.x.target_begin - blit.x.source_begin;
    const std::int64_t shift_y = blit.y.target_begin - blit.y.source_begin;
    PixelRectangle target = clip_to(to, blit.target());
    PixelRectangle source =
        clip_to(from, {target.x - shift_x, target.y - shift_y, target.width, target.height});
    if (source.empty()) return;
    CommandStream commands;
    commands.add(
        CopyRectangleCommand{.source = from,
                             .destination = to,
                             .source_x = static_cast<std::uint16_t>(source.x),
                             .source_y = static_cast<std::uint16_t>(source.y),
                             .destination_x = static_cast<std::uint16_t>(source.x + shift_x),
                             .destination_y = static_cast<std::uint16_t>(source.y + shift_y),
                             .width = static_cast<std::uint16_t>(source.width),
                             .height = static_cast<std::uint16_t>(source.height)});
    context.submit(commands);
}

void blit_color(Context& context, const Surface& from, const Surface& to, const Blit& blit) {
    if (from.format == Format::None || to.format == Format::None) return;
    if (blit.x.is_copy() && blit.y.is_copy()) return copy_colors(context, from, to, blit);
    blit_colors(context.device(), from, to, blit);
}

} // namespace

void BlitFramebuffer(Context& context,
                     GLint srcX0,
                     GLint srcY0,
                     GLint srcX1,
                     GLint srcY1,
                     GLint dstX0,
                     GLint dstY0,
                     GLint dstX1,
                     GLint dstY1,
                     GLbitfield mask,
                     GLenum filter) {
    if (const GLenum error = arguments_error(mask, filter)) return context.error(error);
    const ReadTarget read = find_read_target(context);
    if (read.status != GL_FRAMEBUFFER_COMPLETE)
        return context.error(GL_INVALID_FRAMEBUFFER_OPERATION);
    if (!context.prepare_draw()) return;

    // Buffers that either side lacks are left out (ARB_framebuffer_object).
    const Targets& targets = context.registers.wanted.targets;
    const bool depth = (mask & GL_DEPTH_BUFFER_BIT) != 0 && read.has_depth;
    const bool stencil = (mask & GL_STENCIL_BUFFER_BIT) != 0 && read.has_stencil;
    const bool any_depth = (depth || stencil) && targets.depth.format != Format::None;
    if (any_depth && targets.depth.format != read.depth.format)
        return context.error(GL_INVALID_OPERATION);

    const Blit blit{.x = {srcX0, srcX1, dstX0, dstX1},
                    .y = {srcY0, srcY1, dstY0, dstY1},
                    .linear = filter == GL_LINEAR,
                    .clip = rectangle_of(context.registers.wanted.scissor)};
    if (blit.empty()) return;
    if ((mask & GL_COLOR_BUFFER_BIT) != 0)
        for (const Surface& target : targets.color)
            blit_color(context, read.color, target, blit);
    if (any_depth)
        blit_depth_stencil(context.device(), read.depth, targets.depth, blit, {depth, stencil});
}

} // namespace ffgpu::gl::api
