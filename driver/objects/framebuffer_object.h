// FramebufferObject: attachments of textures' images and renderbuffers
// (EXT_framebuffer_object, ARB_framebuffer_object).

#pragma once

#include "driver/gl_types.h"
#include "driver/objects/renderbuffer.h"
#include "driver/objects/texture_object.h"
#include "driver/state/framebuffer_state.h"

#include <array>
#include <memory>

namespace ffgpu::gl {

constexpr unsigned MaxColorAttachments = 8;

// Either a level of a texture, or a renderbuffer, or nothing.
struct Attachment {
    std::shared_ptr<TextureObject> texture;
    unsigned face = 0;
    unsigned level = 0;
    unsigned layer = 0; // slice of a 3-D texture
    std::shared_ptr<Renderbuffer> renderbuffer;

    explicit operator bool() const { return texture || renderbuffer; }
    bool operator==(const Attachment&) const = default;

    // Of the attached image; base None where it is not there.
    InternalFormat format() const;
    GLsizei width() const;
    GLsizei height() const;
    GLsizei samples() const; // 0: single-sampled
};

struct FramebufferObject {
    GLuint name = 0;
    std::array<Attachment, MaxColorAttachments> colors;
    Attachment depth;
    Attachment stencil;
    DrawBufferList draw_buffers{GL_COLOR_ATTACHMENT0}; // each GL_NONE or GL_COLOR_ATTACHMENTi
    GLenum read_buffer = GL_COLOR_ATTACHMENT0;

    // Null where the token (GL_COLOR_ATTACHMENTi, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT) names
    // none.
    Attachment* find(GLenum attachment);

    // Takes the texture's images or the renderbuffer off all attachments.
    void detach(const TextureObject& texture);
    void detach(const Renderbuffer& removed);
};

// GL_FRAMEBUFFER_COMPLETE, or why it is not. Images of different sizes go together, as in
// ARB_framebuffer_object.
GLenum framebuffer_status(const FramebufferObject& framebuffer);

// Which of a Depth24Stencil8 surface's parts are attached: tests and writes of the other are off.
bool has_depth(const FramebufferObject& framebuffer);
bool has_stencil(const FramebufferObject& framebuffer);

// GL_SAMPLES: of every image of a complete framebuffer object; 0: single-sampled.
GLsizei samples(const FramebufferObject& framebuffer);

} // namespace ffgpu::gl
