// Names and bindings of textures, the active unit (GL 1.5, 2.7, 3.8.12).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/image_commands.h"
#include "driver/objects/framebuffer_object.h"
#include "driver/objects/shared_objects.h"
#include "driver/objects/texture_object.h"

#include <algorithm>

namespace ffgpu::gl::api {
namespace {

// Bindings and attachments of this context go back to nothing; those of others keep the object.
void unbind(Context& context, const TextureObject& texture) {
    const auto target = static_cast<std::size_t>(texture.target());
    TextureState& state = context.state.texture;
    for (TextureUnit& unit : state.units) {
        if (unit.bound[target].get() == &texture) unit.bound[target] = state.defaults[target];
    }
    for (const auto& object :
         {context.state.framebuffer.draw_object, context.state.framebuffer.read_object}) {
        if (object) object->detach(texture);
    }
    mark_textures(context);
}

} // namespace

void ActiveTexture(Context& context, GLenum texture) {
    if (texture < GL_TEXTURE0 || texture >= GL_TEXTURE0 + TextureUnits)
        return context.error(GL_INVALID_ENUM);
    context.state.texture.active_unit = texture - GL_TEXTURE0;
}

void GenTextures(Context& context, GLsizei n, GLuint* textures) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    context.shared().textures.generate({textures, static_cast<std::size_t>(n)});
}

void BindTexture(Context& context, GLenum target, GLuint texture) {
    const auto wanted = find_texture_target(target);
    if (!wanted) return context.error(GL_INVALID_ENUM);
    TextureState& state = context.state.texture;
    const auto index = static_cast<std::size_t>(*wanted);
    std::shared_ptr<TextureObject>& bound = state.active().bound[index];
    if (bound->name() == texture && !bound->deleted) return;
    if (texture == 0) {
        bound = state.defaults[index];
    } else {
        NameTable<TextureObject>& textures = context.shared().textures;
        std::shared_ptr<TextureObject> object = textures.share(texture);
        if (!object) {
            object = std::make_shared<TextureObject>(texture, *wanted);
            textures.set(texture, object);
        } else if (object->target() != *wanted) {
            return context.error(GL_INVALID_OPERATION);
        }
        bound = std::move(object);
    }
    if (!state.active().enabled[index]) return; // Nothing that is drawn depends on it.
    context.dirty.mark(Dirty::Textures);
    context.dirty.mark(Dirty::Environments);
}

void DeleteTextures(Context& context, GLsizei n, const GLuint* textures) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i) {
        if (textures[i] == 0) continue;
        const auto texture = context.shared().textures.remove(textures[i]);
        if (!texture) continue;
        texture->deleted = true;
        unbind(context, *texture);
    }
}

GLboolean IsTexture(Context& context, GLuint texture) {
    return context.shared().textures.find(texture) != nullptr;
}

void PrioritizeTextures(Context& context,
                        GLsizei n,
                        const GLuint* textures,
                        const GLfloat* priorities) {
    if (n < 0) return context.error(GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i) {
        TextureObject* const texture = context.shared().textures.find(textures[i]);
        if (texture) texture->parameters.priority = std::clamp(priorities[i], 0.0f, 1.0f);
    }
}

// Each texture is resident as soon as it is drawn with: there is no working set to fall out of.
GLboolean AreTexturesResident(Context& context, GLsizei n, const GLuint* textures, GLboolean*) {
    if (n < 0) {
        context.error(GL_INVALID_VALUE);
        return GL_FALSE;
    }
    for (GLsizei i = 0; i < n; ++i) {
        if (context.shared().textures.find(textures[i])) continue;
        context.error(GL_INVALID_VALUE);
        return GL_FALSE;
    }
    return GL_TRUE;
}

void GenTexturesEXT(Context& context, GLsizei n, GLuint* textures) {
    GenTextures(context, n, textures);
}

void DeleteTexturesEXT(Context& context, GLsizei n, const GLuint* textures) {
    DeleteTextures(context, n, textures);
}

GLboolean IsTextureEXT(Context& context, GLuint texture) {
    return IsTexture(context, texture);
}

GLboolean
AreTexturesResidentEXT(Context& context, GLsizei n, const GLuint* textures, GLboolean* residences) {
    return AreTexturesResident(context, n, textures, residences);
}

} // namespace ffgpu::gl::api
