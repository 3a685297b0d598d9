// Renderbuffers (EXT_framebuffer_object, EXT_framebuffer_multisample, EXT_packed_depth_stencil).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/objects/framebuffer_object.h"
#include "driver/objects/shared_objects.h"
#include "driver/pixel/pixel_layout.h"

namespace ffgpu::gl::api {
namespace {

void bind_renderbuffer(Context& context, GLenum target, GLuint name) {
    if (target != GL_RENDERBUFFER) return context.error(GL_INVALID_ENUM);
    std::shared_ptr<Renderbuffer> object = context.shared().renderbuffers.share(name);
    if (!object && name != 0) {
        object = std::make_shared<Renderbuffer>();
        object->name = name;
        context.shared().renderbuffers.set(name, object);
    }
    context.state.framebuffer.renderbuffer = std::move(object);
}

// Contents are undefined; zeroes, so that the same program draws the same picture.
void clear_storage(Device& device, const DeviceBlock& block) {
    const std::vector<std::byte> zeroes(block.bytes());
    device.write_memory(block.address(), zeroes);
}

void allocate_storage(
    Context& context, GLenum target, GLsizei samples, GLenum internal_format, ImageSize size) {
    if (target != GL_RENDERBUFFER) return context.error(GL_INVALID_ENUM);
    const InternalFormat format = renderbuffer_format(internal_format);
    if (format.base == BaseFormat::None) return context.error(GL_INVALID_ENUM);
    constexpr auto MaxSize = static_cast<GLsizei>(MaxSurfaceSize);
    if (size.width < 0 || size.height < 0 || size.width > MaxSize || size.height > MaxSize ||
        samples < 0 || samples > GLsizei{MaxSamples}) {
        return context.error(GL_INVALID_VALUE);
    }
    Renderbuffer* const buffer = context.state.framebuffer.renderbuffer.get();
    if (!buffer) return context.error(GL_INVALID_OPERATION);

    buffer->block = {};
    buffer->internal_format = internal_format;
    buffer->format = format;
    buffer->width = size.width;
    buffer->height = size.height;
    buffer->samples = samples > 0 ? GLsizei{MaxSamples} : 0;
    context.dirty.mark(Dirty::Targets);
    if (size.empty()) return;
    buffer->block = DeviceBlock::allocate(context.shared().memory, buffer->layout().bytes());
    if (!buffer->block) {
        *buffer = {.name = buffer->name};
        return context.error(GL_OUT_OF_MEMORY);
    }
    clear_storage(context.device(), buffer->block);
}

} // namespace

void GenRenderbuffers(Context& context, GLsizei n, GLuint* renderbuffers) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    context.shared().renderbuffers.generate({renderbuffers, static_cast<std::size_t>(n)});
}

void DeleteRenderbuffers(Context& context, GLsizei n, const GLuint* renderbuffers) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    FramebufferState& state = context.state.framebuffer;
    for (GLsizei i = 0; i < n; ++i) {
        const auto removed = context.shared().renderbuffers.remove(renderbuffers[i]);
        if (!removed) continue;
        if (state.renderbuffer == removed) state.renderbuffer = nullptr;
        if (state.draw_object) state.draw_object->detach(*removed);
        if (state.read_object) state.read_object->detach(*removed);
        context.dirty.mark(Dirty::Targets);
    }
}

GLboolean IsRenderbuffer(Context& context, GLuint renderbuffer) {
    return context.shared().renderbuffers.find(renderbuffer) != nullptr;
}

// ARB_framebuffer_object binds generated names only.
void BindRenderbuffer(Context& context, GLenum target, GLuint renderbuffer) {
    if (renderbuffer != 0 && !context.shared().renderbuffers.is_used(renderbuffer))
        return context.error(GL_INVALID_OPERATION);
    bind_renderbuffer(context, target, renderbuffer);
}

void BindRenderbufferEXT(Context& context, GLenum target, GLuint renderbuffer) {
    bind_renderbuffer(context, target, renderbuffer);
}

void RenderbufferStorage(
    Context& context, GLenum target, GLenum internalformat, GLsizei width, GLsizei height) {
    allocate_storage(context, target, 0, internalformat, {width, height, 1});
}

// The device has one number of samples: at least as many as are asked for.
void RenderbufferStorageMultisample(Context& context,
                                    GLenum target,
                                    GLsizei samples,
                                    GLenum internalformat,
                                    GLsizei width,
                                    GLsizei height) {
    allocate_storage(context, target, samples, internalformat, {width, height, 1});
}

void GetRenderbufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (target != GL_RENDERBUFFER) return context.error(GL_INVALID_ENUM);
    const Renderbuffer* const buffer = context.state.framebuffer.renderbuffer.get();
    if (!buffer) return context.error(GL_INVALID_OPERATION);
    const ComponentBits bits = component_bits(buffer->format);
    switch (pname) {
    case GL_RENDERBUFFER_WIDTH:
        *params = buffer->width;
        break;
    case GL_RENDERBUFFER_HEIGHT:
        *params = buffer->height;
        break;
    case GL_RENDERBUFFER_INTERNAL_FORMAT:
        *params = static_cast<GLint>(buffer->internal_format);
        break;
    case GL_RENDERBUFFER_RED_SIZE:
        *params = bits.red;
        break;
    case GL_RENDERBUFFER_GREEN_SIZE:
        *params = bits.green;
        break;
    case GL_RENDERBUFFER_BLUE_SIZE:
        *params = bits.blue;
        break;
    case GL_RENDERBUFFER_ALPHA_SIZE:
        *params = bits.alpha;
        break;
    case GL_RENDERBUFFER_DEPTH_SIZE:
        *params = bits.depth;
        break;
    case GL_RENDERBUFFER_STENCIL_SIZE:
        *params = bits.stencil;
        break;
    case GL_RENDERBUFFER_SAMPLES:
        *params = buffer->samples;
        break;
    default:
        context.error(GL_INVALID_ENUM);
    }
}

} // namespace ffgpu::gl::api
