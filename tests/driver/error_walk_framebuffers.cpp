// Framebuffer objects and renderbuffers.

#include "model/device/layout/limits.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr GLenum F = GL_FRAMEBUFFER, R = GL_RENDERBUFFER, C0 = GL_COLOR_ATTACHMENT0;
constexpr GLenum T2 = GL_TEXTURE_2D, UB = GL_UNSIGNED_BYTE;
constexpr GLsizei TooWide = MaxSurfaceSize + 1;
constexpr GLbitfield ColorBit = GL_COLOR_BUFFER_BIT;

constexpr RefusedCall Window[] = {
    REFUSED(GL_INVALID_ENUM, BindFramebuffer, R, 0),
    REFUSED(GL_INVALID_OPERATION, BindFramebuffer, F, 99),
    REFUSED(GL_INVALID_ENUM, BindFramebufferEXT, R, 99),
    REFUSED(GL_INVALID_ENUM, BindRenderbuffer, F, 0),
    REFUSED(GL_INVALID_OPERATION, BindRenderbuffer, R, 99),
    REFUSED(GL_INVALID_ENUM, BindRenderbufferEXT, F, 99),
    REFUSED(GL_INVALID_VALUE, GenFramebuffers, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteFramebuffers, -1, names),
    REFUSED(GL_INVALID_VALUE, GenRenderbuffers, -1, names),
    REFUSED(GL_INVALID_VALUE, DeleteRenderbuffers, -1, names),
    REFUSED(GL_INVALID_ENUM, CheckFramebufferStatus, R),
    REFUSED(GL_INVALID_OPERATION, FramebufferTexture1D, F, C0, GL_TEXTURE_1D, 0, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTexture2D, F, C0, T2, 0, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTexture3D, F, C0, GL_TEXTURE_3D, 0, 0, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTextureLayer, F, C0, 0, 0, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferRenderbuffer, F, C0, R, 0),
    REFUSED(GL_INVALID_ENUM,
            GetFramebufferAttachmentParameteriv,
            R,
            GL_BACK,
            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
            ints),
    REFUSED(GL_INVALID_ENUM,
            GetFramebufferAttachmentParameteriv,
            F,
            C0,
            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
            ints),
    REFUSED(GL_INVALID_ENUM, RenderbufferStorage, F, GL_RGBA8, 4, 4),
    REFUSED(GL_INVALID_OPERATION, RenderbufferStorage, R, GL_RGBA8, 4, 4),
    REFUSED(GL_INVALID_ENUM, RenderbufferStorageMultisample, F, 0, GL_RGBA8, 4, 4),
    REFUSED(GL_INVALID_ENUM, GetRenderbufferParameteriv, F, GL_RENDERBUFFER_WIDTH, ints),
    REFUSED(GL_INVALID_OPERATION, GetRenderbufferParameteriv, R, GL_RENDERBUFFER_WIDTH, ints),
    REFUSED(
        GL_INVALID_VALUE, BlitFramebuffer, 0, 0, 4, 4, 0, 0, 4, 4, GL_ACCUM_BUFFER_BIT, GL_NEAREST),
    REFUSED(GL_INVALID_ENUM, BlitFramebuffer, 0, 0, 4, 4, 0, 0, 4, 4, ColorBit, GL_REPEAT),
    REFUSED(GL_INVALID_OPERATION,
            BlitFramebuffer,
            0,
            0,
            4,
            4,
            0,
            0,
            4,
            4,
            GL_DEPTH_BUFFER_BIT,
            GL_LINEAR),
};

void bind_empty_objects() {
    entry::BindTexture(T2, 1);
    entry::BindFramebufferEXT(F, 1);
    entry::BindRenderbufferEXT(R, 1);
}

constexpr RefusedCall Empty[] = {
    REFUSED(GL_INVALID_ENUM, FramebufferTexture1D, R, C0, GL_TEXTURE_1D, 0, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTexture1D, F, C0, GL_TEXTURE_1D, 1, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTexture2D, F, C0, T2, 99, 0),
    REFUSED(
        GL_INVALID_OPERATION, FramebufferTexture2D, F, C0, GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1, 0),
    REFUSED(GL_INVALID_VALUE, FramebufferTexture2D, F, C0, T2, 1, -1),
    REFUSED(GL_INVALID_VALUE, FramebufferTexture2D, F, C0, T2, 1, MaxTextureLevels),
    REFUSED(GL_INVALID_ENUM, FramebufferTexture2D, F, GL_BACK, T2, 1, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTexture3D, F, C0, GL_TEXTURE_3D, 1, 0, 0),
    REFUSED(GL_INVALID_OPERATION, FramebufferTextureLayer, F, C0, 1, 0, 0),
    REFUSED(GL_INVALID_ENUM, FramebufferRenderbuffer, F, C0, T2, 1),
    REFUSED(GL_INVALID_ENUM, FramebufferRenderbuffer, F, GL_BACK, R, 1),
    REFUSED(GL_INVALID_OPERATION, FramebufferRenderbuffer, F, C0, R, 99),
    REFUSED(GL_INVALID_ENUM, RenderbufferStorage, R, GL_LUMINANCE_ALPHA + 0x1000, 4, 4),
    REFUSED(GL_INVALID_VALUE, RenderbufferStorage, R, GL_RGBA8, -1, 4),
    REFUSED(GL_INVALID_VALUE, RenderbufferStorage, R, GL_RGBA8, 4, TooWide),
    REFUSED(GL_INVALID_VALUE, RenderbufferStorageMultisample, R, -1, GL_RGBA8, 4, 4),
    REFUSED(GL_INVALID_VALUE, RenderbufferStorageMultisample, R, MaxSamples + 1, GL_RGBA8, 4, 4),
    REFUSED(GL_INVALID_ENUM, GetRenderbufferParameteriv, R, GL_TEXTURE_WIDTH, ints),
    REFUSED(GL_INVALID_OPERATION, DrawBuffer, GL_BACK),
    REFUSED(GL_INVALID_OPERATION, ReadBuffer, GL_BACK),
    // The framebuffer object is incomplete.
    REFUSED(GL_INVALID_FRAMEBUFFER_OPERATION, Clear, ColorBit),
    REFUSED(GL_INVALID_FRAMEBUFFER_OPERATION, ReadPixels, 0, 0, 1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_FRAMEBUFFER_OPERATION, CopyPixels, 0, 0, 1, 1, GL_COLOR),
    REFUSED(GL_INVALID_FRAMEBUFFER_OPERATION, DrawPixels, 1, 1, GL_RGBA, UB, bytes),
    REFUSED(GL_INVALID_FRAMEBUFFER_OPERATION, CopyTexImage2D, T2, 0, GL_RGBA, 0, 0, 4, 4, 0),
    REFUSED(GL_INVALID_FRAMEBUFFER_OPERATION,
            BlitFramebuffer,
            0,
            0,
            4,
            4,
            0,
            0,
            4,
            4,
            ColorBit,
            GL_NEAREST),
};

} // namespace

std::span<const Scene> framebuffer_scenes() {
    static const std::array all{
        Scene{"the window's framebuffer", [] {}, Window},
        Scene{"a framebuffer object without attachments", bind_empty_objects, Empty},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
