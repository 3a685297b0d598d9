// Framebuffer objects: names, bindings, attachments (EXT_framebuffer_object, EXT_framebuffer_blit,
// ARB_framebuffer_object).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/framebuffer_object.h"
#include "driver/objects/shared_objects.h"
#include "driver/texture/texture_target.h"

#include <optional>

namespace ffgpu::gl::api {
namespace {

bool binds_draw(GLenum target) {
    return target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER;
}

bool binds_read(GLenum target) {
    return target == GL_FRAMEBUFFER || target == GL_READ_FRAMEBUFFER;
}

// The object bound to the target; GL_FRAMEBUFFER is the draw framebuffer. False: no such target.
bool find_bound(Context& context, GLenum target, FramebufferObject*& object) {
    if (!binds_draw(target) && !binds_read(target)) return false;
    const FramebufferState& state = context.state.framebuffer;
    object = (binds_draw(target) ? state.draw_object : state.read_object).get();
    return true;
}

void bind_framebuffer(Context& context, GLenum target, GLuint name) {
    if (!binds_draw(target) && !binds_read(target)) return context.error(GL_INVALID_ENUM);
    std::shared_ptr<FramebufferObject> object = context.shared().framebuffers.share(name);
    if (!object && name != 0) {
        object = std::make_shared<FramebufferObject>();
        object->name = name;
        context.shared().framebuffers.set(name, object);
    }
    FramebufferState& state = context.state.framebuffer;
    if (binds_read(target)) state.read_object = object;
    if (!binds_draw(target) || state.draw_object == object) return;
    state.draw_object = std::move(object);
    context.dirty.mark(Dirty::Targets);
    context.dirty.mark(Dirty::Viewport); // The scissor is limited to the target.
}

// Attaches to one point, or with GL_DEPTH_STENCIL_ATTACHMENT to two.
void attach(Context& context, GLenum target, GLenum point, const Attachment& attachment) {
    FramebufferObject* object = nullptr;
    if (!find_bound(context, target, object)) return context.error(GL_INVALID_ENUM);
    if (!object) return context.error(GL_INVALID_OPERATION);
    if (point == GL_DEPTH_STENCIL_ATTACHMENT) {
        object->depth = object->stencil = attachment;
    } else if (Attachment* const place = object->find(point)) {
        *place = attachment;
    } else {
        return context.error(GL_INVALID_ENUM);
    }
    context.dirty.mark(Dirty::Targets);
}

// An image of a texture as the glFramebufferTexture* commands name it.
struct TextureImageName {
    GLuint texture;
    GLenum image_target; // GL_TEXTURE_2D, a face of a cube map ...
    GLint level;
    GLint layer;
};

void attach_texture(Context& context,
                    GLenum target,
                    GLenum point,
                    unsigned dimensions,
                    const TextureImageName& name) {
    if (name.texture == 0) return attach(context, target, point, {});
    const auto image = find_image_target(name.image_target);
    const auto texture = context.shared().textures.share(name.texture);
    if (!texture) return context.error(GL_INVALID_OPERATION);
    if (!image || image->proxy || image->dimensions != dimensions ||
        image->target != texture->target()) {
        return context.error(GL_INVALID_OPERATION);
    }
    const auto levels = static_cast<GLint>(max_texture_levels(image->target));
    const auto layers = static_cast<GLint>(MaxTexture3dSize);
    if (name.level < 0 || name.level >= levels || name.layer < 0 || name.layer >= layers)
        return context.error(GL_INVALID_VALUE);
    attach(context,
           target,
           point,
           {texture,
            image->face,
            static_cast<unsigned>(name.level),
            static_cast<unsigned>(name.layer),
            nullptr});
}

} // namespace

void GenFramebuffers(Context& context, GLsizei n, GLuint* framebuffers) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    context.shared().framebuffers.generate({framebuffers, static_cast<std::size_t>(n)});
}

void DeleteFramebuffers(Context& context, GLsizei n, const GLuint* framebuffers) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    FramebufferState& state = context.state.framebuffer;
    for (GLsizei i = 0; i < n; ++i) {
        const auto object = context.shared().framebuffers.remove(framebuffers[i]);
        if (!object) continue;
        if (state.draw_object == object) bind_framebuffer(context, GL_DRAW_FRAMEBUFFER, 0);
        if (state.read_object == object) bind_framebuffer(context, GL_READ_FRAMEBUFFER, 0);
    }
}

GLboolean IsFramebuffer(Context& context, GLuint framebuffer) {
    return context.shared().framebuffers.find(framebuffer) != nullptr;
}

// ARB_framebuffer_object binds generated names only.
void BindFramebuffer(Context& context, GLenum target, GLuint framebuffer) {
    if (framebuffer != 0 && !context.shared().framebuffers.is_used(framebuffer))
        return context.error(GL_INVALID_OPERATION);
    bind_framebuffer(context, target, framebuffer);
}

void BindFramebufferEXT(Context& context, GLenum target, GLuint framebuffer) {
    bind_framebuffer(context, target, framebuffer);
}

GLenum CheckFramebufferStatus(Context& context, GLenum target) {
    FramebufferObject* object = nullptr;
    if (!find_bound(context, target, object)) {
        context.error(GL_INVALID_ENUM);
        return 0;
    }
    if (object) return framebuffer_status(*object);
    const bool has_window =
        (binds_draw(target) ? context.draw_drawable() : context.read_drawable()) != nullptr;
    return has_window ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_UNDEFINED;
}

void FramebufferTexture1D(Context& context,
                          GLenum target,
                          GLenum attachment,
                          GLenum textarget,
                          GLuint texture,
                          GLint level) {
    attach_texture(context, target, attachment, 1, {texture, textarget, level, 0});
}

void FramebufferTexture2D(Context& context,
                          GLenum target,
                          GLenum attachment,
                          GLenum textarget,
                          GLuint texture,
                          GLint level) {
    attach_texture(context, target, attachment, 2, {texture, textarget, level, 0});
}

void FramebufferTexture3D(Context& context,
                          GLenum target,
                          GLenum attachment,
                          GLenum textarget,
                          GLuint texture,
                          GLint level,
                          GLint zoffset) {
    attach_texture(context, target, attachment, 3, {texture, textarget, level, zoffset});
}

// The only textures with layers are three-dimensional.
void FramebufferTextureLayer(
    Context& context, GLenum target, GLenum attachment, GLuint texture, GLint level, GLint layer) {
    attach_texture(context, target, attachment, 3, {texture, GL_TEXTURE_3D, level, layer});
}

void FramebufferRenderbuffer(Context& context,
                             GLenum target,
                             GLenum attachment,
                             GLenum renderbuffertarget,
                             GLuint renderbuffer) {
    if (renderbuffertarget != GL_RENDERBUFFER) return context.error(GL_INVALID_ENUM);
    auto object = context.shared().renderbuffers.share(renderbuffer);
    if (!object && renderbuffer != 0) return context.error(GL_INVALID_OPERATION);
    attach(context, target, attachment, {nullptr, 0, 0, 0, std::move(object)});
}

} // namespace ffgpu::gl::api
