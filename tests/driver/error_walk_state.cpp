// State without objects: enumerants, values, stacks.

#include "driver/limits.h"
#include "driver/state/transform_state.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr GLenum NoBuffers[ColorTargets + 1] = {};
constexpr GLenum BothBuffers[] = {GL_FRONT_AND_BACK};
constexpr GLenum OneBufferTwice[] = {GL_BACK_LEFT, GL_NONE, GL_BACK_LEFT};
constexpr GLenum Attachments[] = {GL_COLOR_ATTACHMENT0};

constexpr RefusedCall Calls[] = {
    REFUSED(GL_INVALID_ENUM, Accum, GL_BLEND, 1),
    REFUSED(GL_INVALID_ENUM, ActiveStencilFaceEXT, GL_FRONT_AND_BACK),
    REFUSED(GL_INVALID_ENUM, ActiveTexture, GL_TEXTURE0 + TextureUnits),
    REFUSED(GL_INVALID_ENUM, ActiveTexture, GL_TEXTURE0 - 1),
    REFUSED(GL_INVALID_ENUM, AlphaFunc, GL_NEVER - 1, 0),
    REFUSED(GL_INVALID_ENUM, AlphaFunc, GL_ALWAYS + 1, 0),
    REFUSED(GL_INVALID_ENUM, BlendEquation, GL_LOGIC_OP),
    REFUSED(GL_INVALID_ENUM, BlendEquationSeparateEXT, GL_ADD, GL_FUNC_ADD),
    REFUSED(GL_INVALID_ENUM, BlendEquationSeparateEXT, GL_FUNC_ADD, GL_ADD),
    REFUSED(GL_INVALID_ENUM, BlendFunc, GL_LESS, GL_ZERO),
    REFUSED(GL_INVALID_ENUM, BlendFunc, GL_ONE, GL_SRC_ALPHA_SATURATE),
    REFUSED(GL_INVALID_ENUM, BlendFuncSeparate, GL_LESS, GL_ZERO, GL_ONE, GL_ZERO),
    REFUSED(GL_INVALID_ENUM, BlendFuncSeparate, GL_ONE, GL_LESS, GL_ONE, GL_ZERO),
    REFUSED(GL_INVALID_ENUM, BlendFuncSeparate, GL_ONE, GL_ZERO, GL_LESS, GL_ZERO),
    REFUSED(GL_INVALID_ENUM, BlendFuncSeparate, GL_ONE, GL_ZERO, GL_ONE, GL_LESS),
    REFUSED(GL_INVALID_VALUE, Clear, GL_COLOR_BUFFER_BIT | GL_CURRENT_BIT),
    REFUSED(GL_INVALID_ENUM, ClipPlane, GL_CLIP_PLANE0 + ClipPlanes, doubles),
    REFUSED(GL_INVALID_ENUM, ColorMaterial, GL_LEFT, GL_AMBIENT),
    REFUSED(GL_INVALID_ENUM, ColorMaterial, GL_FRONT, GL_SHININESS),
    REFUSED(GL_INVALID_ENUM, CullFace, GL_LEFT),
    REFUSED(GL_INVALID_VALUE, DepthBoundsEXT, 0.75, 0.5),
    REFUSED(GL_INVALID_ENUM, DepthFunc, GL_ALWAYS + 1),
    REFUSED(GL_INVALID_ENUM, Disable, GL_VERTEX_ARRAY_POINTER),
    REFUSED(GL_INVALID_ENUM, Enable, GL_AMBIENT),
    REFUSED(GL_INVALID_ENUM, Enable, GL_LIGHT0 + Lights),
    REFUSED(GL_INVALID_ENUM, DrawBuffer, GL_TEXTURE),
    REFUSED(GL_INVALID_OPERATION, DrawBuffer, GL_AUX0),
    REFUSED(GL_INVALID_OPERATION, DrawBuffer, GL_COLOR_ATTACHMENT0),
    REFUSED(GL_INVALID_VALUE, DrawBuffers, -1, names),
    REFUSED(GL_INVALID_VALUE, DrawBuffers, ColorTargets + 1, NoBuffers),
    REFUSED(GL_INVALID_ENUM, DrawBuffers, 1, names),
    REFUSED(GL_INVALID_OPERATION, DrawBuffers, 1, BothBuffers),
    REFUSED(GL_INVALID_OPERATION, DrawBuffers, 3, OneBufferTwice),
    REFUSED(GL_INVALID_OPERATION, DrawBuffers, 1, Attachments),
    REFUSED(GL_INVALID_ENUM, ReadBuffer, GL_FRONT_AND_BACK),
    REFUSED(GL_INVALID_OPERATION, ReadBuffer, GL_BACK_RIGHT),
    REFUSED(GL_INVALID_ENUM, FrontFace, GL_FRONT),
    REFUSED(GL_INVALID_VALUE, Frustum, -1, 1, -1, 1, 0, 1),
    REFUSED(GL_INVALID_VALUE, Frustum, -1, 1, -1, 1, 1, -1),
    REFUSED(GL_INVALID_VALUE, Frustum, 1, 1, -1, 1, 1, 2),
    REFUSED(GL_INVALID_VALUE, Frustum, -1, 1, 1, 1, 1, 2),
    REFUSED(GL_INVALID_VALUE, Frustum, -1, 1, -1, 1, 2, 2),
    REFUSED(GL_INVALID_VALUE, Ortho, 1, 1, -1, 1, 1, 2),
    REFUSED(GL_INVALID_VALUE, Ortho, -1, 1, 1, 1, 1, 2),
    REFUSED(GL_INVALID_VALUE, Ortho, -1, 1, -1, 1, 1, 1),
    REFUSED(GL_INVALID_ENUM, Hint, GL_FOG, GL_NICEST),
    REFUSED(GL_INVALID_ENUM, Hint, GL_FOG_HINT, GL_LINEAR),
    REFUSED(GL_INVALID_VALUE, LineWidth, 0),
    REFUSED(GL_INVALID_ENUM, LogicOp, GL_SET + 1),
    REFUSED(GL_INVALID_ENUM, MatrixMode, GL_COLOR),
    REFUSED(GL_INVALID_VALUE, PointSize, 0),
    REFUSED(GL_INVALID_ENUM, PolygonMode, GL_LEFT, GL_FILL),
    REFUSED(GL_INVALID_ENUM, PolygonMode, GL_FRONT, GL_QUADS),
    REFUSED(GL_STACK_UNDERFLOW, PopAttrib),
    REFUSED(GL_STACK_UNDERFLOW, PopClientAttrib),
    REFUSED(GL_STACK_UNDERFLOW, PopMatrix),
    REFUSED(GL_INVALID_VALUE, Scissor, 0, 0, -1, 0),
    REFUSED(GL_INVALID_VALUE, Scissor, 0, 0, 0, -1),
    REFUSED(GL_INVALID_ENUM, ShadeModel, GL_FILL),
    REFUSED(GL_INVALID_ENUM, StencilFunc, GL_KEEP, 0, 0),
    REFUSED(GL_INVALID_ENUM, StencilFuncSeparateATI, GL_KEEP, GL_LESS, 0, 0),
    REFUSED(GL_INVALID_ENUM, StencilFuncSeparateATI, GL_LESS, GL_KEEP, 0, 0),
    REFUSED(GL_INVALID_ENUM, StencilOp, GL_LESS, GL_KEEP, GL_KEEP),
    REFUSED(GL_INVALID_ENUM, StencilOp, GL_KEEP, GL_LESS, GL_KEEP),
    REFUSED(GL_INVALID_ENUM, StencilOp, GL_KEEP, GL_KEEP, GL_LESS),
    REFUSED(GL_INVALID_ENUM, StencilOpSeparateATI, GL_LEFT, GL_KEEP, GL_KEEP, GL_KEEP),
    REFUSED(GL_INVALID_ENUM, StencilOpSeparateATI, GL_FRONT, GL_KEEP, GL_KEEP, GL_LESS),
    REFUSED(GL_INVALID_VALUE, Viewport, 0, 0, -1, 1),
    REFUSED(GL_INVALID_VALUE, Viewport, 0, 0, 1, -1),
    // Entry points whose extensions are not advertised.
    REFUSED(GL_INVALID_OPERATION, PolygonOffsetClampEXT, 1, 1, 1),
    REFUSED(GL_INVALID_OPERATION, ProvokingVertex, GL_FIRST_VERTEX_CONVENTION),
};

void fill_stacks() {
    for (unsigned i = 1; i < ModelViewStackDepth; ++i)
        entry::PushMatrix();
    for (unsigned i = 0; i < AttributeStackDepth; ++i)
        entry::PushAttrib(GL_CURRENT_BIT);
    for (unsigned i = 0; i < ClientAttributeStackDepth; ++i)
        entry::PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
}

constexpr RefusedCall FullStacks[] = {
    REFUSED(GL_STACK_OVERFLOW, PushMatrix),
    REFUSED(GL_STACK_OVERFLOW, PushAttrib, GL_ALL_ATTRIB_BITS),
    REFUSED(GL_STACK_OVERFLOW, PushClientAttrib, GL_CLIENT_ALL_ATTRIB_BITS),
};

} // namespace

std::span<const Scene> state_scenes() {
    static const std::array all{
        Scene{"a fresh context", [] {}, Calls},
        Scene{"full stacks", fill_stacks, FullStacks},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
