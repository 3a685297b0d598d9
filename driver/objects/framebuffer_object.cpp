#include "driver/objects/framebuffer_object.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

bool is_depth(BaseFormat base) {
    return base == BaseFormat::Depth || base == BaseFormat::DepthStencil;
}

bool is_stencil(BaseFormat base) {
    return base == BaseFormat::Stencil || base == BaseFormat::DepthStencil;
}

bool is_color(BaseFormat base) {
    return base != BaseFormat::None && !is_depth(base) && !is_stencil(base);
}

// The image is there, and GL allows its kind at this point.
bool is_attachment_complete(const Attachment& attachment, bool (*kind)(BaseFormat)) {
    return attachment.width() > 0 && attachment.height() > 0 && kind(attachment.format().base);
}

GLint border_of(const Attachment& attachment) {
    return attachment.texture ? attachment.texture->level(attachment.face, attachment.level).border
                              : 0;
}

// The device draws to all formats but compressed ones, without borders.
bool is_supported(const Attachment& attachment) {
    if (!attachment) return true;
    return is_renderable(attachment.format().format) && border_of(attachment) == 0 &&
           attachment.width() <= GLsizei{MaxSurfaceSize} &&
           attachment.height() <= GLsizei{MaxSurfaceSize};
}

// Depth and stencil are one surface.
bool share_surface(const Attachment& depth, const Attachment& stencil) {
    return !depth || !stencil || depth == stencil;
}

// EXT_framebuffer_multisample: all images have the same number of samples.
bool share_samples(const FramebufferObject& framebuffer) {
    const GLsizei expected = samples(framebuffer);
    const auto is_same = [expected](const Attachment& attachment) {
        return !attachment || attachment.samples() == expected;
    };
    return std::ranges::all_of(framebuffer.colors, is_same) && is_same(framebuffer.depth) &&
           is_same(framebuffer.stencil);
}

const TextureLevel& level_of(const Attachment& attachment) {
    return attachment.texture->level(attachment.face, attachment.level);
}

} // namespace

InternalFormat Attachment::format() const {
    if (renderbuffer) return renderbuffer->format;
    if (!texture) return {};
    const TextureLevel& image = level_of(*this);
    const bool has_layer = layer < static_cast<unsigned>(image.depth);
    return image.defined() && has_layer ? image.format : InternalFormat{};
}

GLsizei Attachment::width() const {
    return renderbuffer ? renderbuffer->width : texture ? level_of(*this).width : 0;
}

GLsizei Attachment::height() const {
    return renderbuffer ? renderbuffer->height : texture ? level_of(*this).height : 0;
}

GLsizei Attachment::samples() const {
    return renderbuffer ? renderbuffer->samples : 0;
}

Attachment* FramebufferObject::find(GLenum attachment) {
    if (attachment == GL_DEPTH_ATTACHMENT) return &depth;
    if (attachment == GL_STENCIL_ATTACHMENT) return &stencil;
    const GLuint color = attachment - GL_COLOR_ATTACHMENT0;
    return color < MaxColorAttachments ? &colors[color] : nullptr;
}

void FramebufferObject::detach(const TextureObject& removed) {
    const auto clear = [&](Attachment& attachment) {
        if (attachment.texture.get() == &removed) attachment = {};
    };
    for (Attachment& color : colors)
        clear(color);
    clear(depth);
    clear(stencil);
}

void FramebufferObject::detach(const Renderbuffer& removed) {
    const auto clear = [&](Attachment& attachment) {
        if (attachment.renderbuffer.get() == &removed) attachment = {};
    };
    for (Attachment& color : colors)
        clear(color);
    clear(depth);
    clear(stencil);
}

GLenum framebuffer_status(const FramebufferObject& framebuffer) {
    const auto& [name, colors, depth, stencil, draw_buffers, read_buffer] = framebuffer;
    bool any = depth || stencil;
    for (const Attachment& color : colors) {
        if (!color) continue;
        any = true;
        if (!is_attachment_complete(color, is_color)) return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
    }
    if (depth && !is_attachment_complete(depth, is_depth))
        return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
    if (stencil && !is_attachment_complete(stencil, is_stencil))
        return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
    if (!any) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
    if (!share_samples(framebuffer)) return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;

    const auto is_missing = [&colors = colors](GLenum buffer) {
        return buffer != GL_NONE && !colors[buffer - GL_COLOR_ATTACHMENT0];
    };
    if (std::any_of(draw_buffers.begin(), draw_buffers.end(), is_missing))
        return GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER;
    if (is_missing(read_buffer)) return GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER;

    for (const Attachment& color : colors) {
        if (!is_supported(color)) return GL_FRAMEBUFFER_UNSUPPORTED;
    }
    if (!is_supported(depth) || !is_supported(stencil) || !share_surface(depth, stencil))
        return GL_FRAMEBUFFER_UNSUPPORTED;
    return GL_FRAMEBUFFER_COMPLETE;
}

bool has_depth(const FramebufferObject& framebuffer) {
    return static_cast<bool>(framebuffer.depth);
}

bool has_stencil(const FramebufferObject& framebuffer) {
    return static_cast<bool>(framebuffer.stencil);
}

GLsizei samples(const FramebufferObject& framebuffer) {
    for (const Attachment& color : framebuffer.colors)
        if (color) return color.samples();
    return framebuffer.depth ? framebuffer.depth.samples() : framebuffer.stencil.samples();
}

} // namespace ffgpu::gl
