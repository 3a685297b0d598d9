// glBlitFramebuffer (EXT_framebuffer_blit, ARB_framebuffer_object).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/blit.h"
#include "driver/objects/device_block.h"
#include "driver/objects/shared_objects.h"

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

// Mirrored, not scaled: resolved as it is, then mirrored.
void blit_resolved(Context& context, const Surface& from, const Surface& to, const Blit& blit) {
    Surface resolved = from.plane(0);
    const DeviceBlock block =
        DeviceBlock::allocate(context.shared().memory, resolved.plane_bytes());
    if (!block) return context.error(GL_OUT_OF_MEMORY);
    resolved.address = block.address();
    const BlitAxis all_x{0, from.width, 0, from.width}, all_y{0, from.height, 0, from.height};
    copy_colors(
        context, from, resolved, {.x = all_x, .y = all_y, .clip = {0, 0, from.width, from.height}});
    blit_colors(context.device(), resolved, to, blit);
}

// Of equally many samples each comes from its own, else all come from the one there is.
Surface sample_source(const Surface& from, unsigned sample) {
    return from.plane(from.samples > 1 ? sample : 0);
}

void blit_color(Context& context, const Surface& from, const Surface& to, const Blit& blit) {
    if (from.format == Format::None || to.format == Format::None) return;
    if (blit.x.is_copy() && blit.y.is_copy()) return copy_colors(context, from, to, blit);
    if (from.samples > to.samples) return blit_resolved(context, from, to, blit);
    for (unsigned i = 0; i < to.samples; ++i)
        blit_colors(context.device(), sample_source(from, i), to.plane(i), blit);
}

// Depths and stencils cannot be averaged: where there is one sample it is sample 0's.
void blit_depth(Context& context,
                const Surface& from,
                const Surface& to,
                const Blit& blit,
                DepthStencilMask mask) {
    for (unsigned i = 0; i < to.samples; ++i)
        blit_depth_stencil(context.device(), sample_source(from, i), to.plane(i), blit, mask);
}

// Windows with and without alpha go together: whether a window has it is the X server's affair.
bool are_resolvable(Format from, Format to) {
    const auto has_bytes = [](Format format) {
        return format == Format::Rgba8 || format == Format::Rgbx8;
    };
    return from == to || from == Format::None || to == Format::None ||
           (has_bytes(from) && has_bytes(to));
}

// EXT_framebuffer_multisample: where either side is multisampled nothing is scaled or converted.
GLenum
multisample_error(const ReadTarget& read, const Targets& targets, const Blit& blit, bool colors) {
    bool multisampled = read.color.samples > 1 || read.depth.samples > 1;
    bool resolvable = true;
    Targets::for_each(targets,
                      [&](const Surface& surface) { multisampled |= surface.samples > 1; });
    for (const Surface& target : targets.color)
        resolvable &= !colors || are_resolvable(read.color.format, target.format);
    const bool same_size = blit.x.keeps_size() && blit.y.keeps_size();
    return multisampled && !(same_size && resolvable) ? GL_INVALID_OPERATION : GL_NO_ERROR;
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
    ReadTarget read = find_read_target(context);
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
    const bool colors = (mask & GL_COLOR_BUFFER_BIT) != 0;
    if (const GLenum error = multisample_error(read, targets, blit, colors))
        return context.error(error);
    if (blit.empty()) return;
    if (read.is_supersampled()) read.color = read.pixel_colors();
    for (unsigned i = 0; i < context.draw_target().supersampling; ++i) {
        const auto picture = [i](const Surface& of_first) {
            return i == 0 || of_first.format == Format::None ? of_first : of_first.plane(i);
        };
        for (const Surface& target : targets.color)
            if (colors) blit_color(context, read.color, picture(target), blit);
        if (any_depth)
            blit_depth(context, read.depth, picture(targets.depth), blit, {depth, stencil});
    }
}

} // namespace ffgpu::gl::api
