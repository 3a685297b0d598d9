// glGetFramebufferAttachmentParameter (EXT_framebuffer_object; ARB_framebuffer_object, table 6.28).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/framebuffer_object.h"
#include "driver/texture/texture_target.h"

#include <optional>

namespace ffgpu::gl::api {
namespace {

// What can be asked of an attachment of either kind of framebuffer.
struct Attached {
    GLenum type = GL_NONE;
    GLuint name = 0;
    const Attachment* image = nullptr; // null: a window's buffer
    ComponentBits bits;
    bool is_color = false;
};

ComponentBits masked(ComponentBits bits, GLenum point) {
    if (point == GL_DEPTH_ATTACHMENT || point == GL_DEPTH) bits.stencil = 0;
    if (point == GL_STENCIL_ATTACHMENT || point == GL_STENCIL) bits.depth = 0;
    return bits;
}

// Nothing: there is no such attachment point.
std::optional<Attached> find_window_buffer(const Drawable& drawable, GLenum point) {
    const PixelFormat& format = drawable.format();
    const auto alpha = static_cast<std::uint8_t>(format.alpha ? 8 : 0);
    switch (point) {
    case GL_FRONT:
    case GL_FRONT_LEFT:
        return Attached{GL_FRAMEBUFFER_DEFAULT, 0, nullptr, {8, 8, 8, alpha}, true};
    case GL_BACK:
    case GL_BACK_LEFT:
        if (!format.double_buffer) return Attached{};
        return Attached{GL_FRAMEBUFFER_DEFAULT, 0, nullptr, {8, 8, 8, alpha}, true};
    case GL_FRONT_RIGHT:
    case GL_BACK_RIGHT:
        return Attached{};
    case GL_DEPTH:
        if (format.depth_bits == 0) return Attached{};
        return Attached{GL_FRAMEBUFFER_DEFAULT, 0, nullptr, {.depth = format.depth_bits}, false};
    case GL_STENCIL:
        if (format.stencil_bits == 0) return Attached{};
        return Attached{
            GL_FRAMEBUFFER_DEFAULT, 0, nullptr, {.stencil = format.stencil_bits}, false};
    default:
        return std::nullopt;
    }
}

Attached find_attachment(const Attachment& attachment, GLenum point) {
    if (!attachment) return {};
    Attached found;
    found.type = attachment.texture ? GL_TEXTURE : GL_RENDERBUFFER;
    found.name = attachment.texture ? attachment.texture->name() : attachment.renderbuffer->name;
    found.image = &attachment;
    found.bits = masked(component_bits(attachment.format()), point);
    found.is_color = point >= GL_COLOR_ATTACHMENT0 && point <= GL_COLOR_ATTACHMENT31;
    return found;
}

// False: the parameter does not go with what is attached.
bool texture_parameter(const Attachment& image, GLenum name, GLint& value) {
    const bool cube = image.texture->target() == TextureTarget::Cube;
    switch (name) {
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL:
        value = static_cast<GLint>(image.level);
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
        value = cube ? static_cast<GLint>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + image.face) : 0;
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_3D_ZOFFSET_EXT:
        value = static_cast<GLint>(image.layer);
        break;
    default:
        return false;
    }
    return true;
}

// Of a window what GL_FRAMEBUFFER_SRGB makes of it.
bool holds_codes(const Attached& attached) {
    return attached.image ? attached.image->format().srgb : attached.is_color;
}

bool parameter_of(const Attached& attached, GLenum name, GLint& value) {
    switch (name) {
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE:
        value = static_cast<GLint>(attached.type);
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME:
        value = static_cast<GLint>(attached.name);
        return attached.type != GL_FRAMEBUFFER_DEFAULT;
    default:
        break;
    }
    if (attached.type == GL_NONE) return false;
    switch (name) {
    case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
        value = attached.bits.red;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
        value = attached.bits.green;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
        value = attached.bits.blue;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
        value = attached.bits.alpha;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
        value = attached.bits.depth;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
        value = attached.bits.stencil;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE:
        value = attached.bits.stencil != 0 ? GL_INDEX : GL_UNSIGNED_NORMALIZED;
        return true;
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING:
        value = holds_codes(attached) ? GL_SRGB : GL_LINEAR;
        return true;
    default:
        return attached.image && attached.image->texture &&
               texture_parameter(*attached.image, name, value);
    }
}

// GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING to _STENCIL_SIZE: what any image has.
bool is_component_size(GLenum name) {
    return name >= GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING &&
           name <= GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE;
}

} // namespace

void GetFramebufferAttachmentParameteriv(
    Context& context, GLenum target, GLenum attachment, GLenum pname, GLint* params) {
    const FramebufferState& state = context.state.framebuffer;
    const bool reads = target == GL_READ_FRAMEBUFFER;
    if (!reads && target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER)
        return context.error(GL_INVALID_ENUM);
    FramebufferObject* const object = (reads ? state.read_object : state.draw_object).get();
    const Drawable* const drawable = reads ? context.read_drawable() : context.draw_drawable();
    std::optional<Attached> attached;
    if (object && attachment == GL_DEPTH_STENCIL_ATTACHMENT) {
        if (object->depth != object->stencil) return context.error(GL_INVALID_OPERATION);
        attached = find_attachment(object->depth, attachment);
    } else if (object) {
        const Attachment* const place = object->find(attachment);
        if (place) attached = find_attachment(*place, attachment);
    } else if (drawable) {
        attached = find_window_buffer(*drawable, attachment);
    } else {
        return context.error(GL_INVALID_OPERATION);
    }
    if (!attached) return context.error(GL_INVALID_ENUM);
    GLint value = 0;
    if (!parameter_of(*attached, pname, value)) {
        const bool nothing = attached->type == GL_NONE && is_component_size(pname);
        return context.error(nothing ? GL_INVALID_OPERATION : GL_INVALID_ENUM);
    }
    *params = value;
}

} // namespace ffgpu::gl::api
