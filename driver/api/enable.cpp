// glEnable, glDisable, glIsEnabled. The client arrays' commands are with the arrays.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/get/client_arrays.h"
#include "driver/lower/color_material.h"
#include "driver/state/capabilities.h"

namespace ffgpu::gl::api {
namespace {

void set_capability(Context& context, GLenum cap, bool enable) {
    const Capability* const capability = find_capability(cap);
    if (!capability && find_client_array(context.client.arrays, cap)) // EXT_vertex_array
        return enable ? EnableClientState(context, cap) : DisableClientState(context, cap);
    if (!capability) return context.error(GL_INVALID_ENUM);
    bool& flag = capability_flag(*capability, context.state, cap);
    if (flag == enable) return;
    const auto follow_color = [&] {
        track_color(context.state.lighting, context.state.current.of(Attribute::Color));
    };
    if (cap == GL_COLOR_MATERIAL && !enable) follow_color(); // The materials keep it.
    flag = enable;
    if (cap == GL_COLOR_MATERIAL && enable) follow_color();
    context.dirty.mark(capability->dirty);
}

} // namespace

void Enable(Context& context, GLenum cap) {
    set_capability(context, cap, true);
}

void Disable(Context& context, GLenum cap) {
    set_capability(context, cap, false);
}

GLboolean IsEnabled(Context& context, GLenum cap) {
    if (const Capability* const capability = find_capability(cap))
        return capability_flag(*capability, context.state, cap) ? GL_TRUE : GL_FALSE;
    if (const VertexArray* const array = find_client_array(context.client.arrays, cap))
        return array->enabled ? GL_TRUE : GL_FALSE;
    context.error(GL_INVALID_ENUM);
    return GL_FALSE;
}

} // namespace ffgpu::gl::api
