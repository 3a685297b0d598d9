// Saving and restoring state (GL 1.5, 6.1.14).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {

void PushAttrib(Context& context, GLbitfield mask) {
    if (!context.attributes.push(context, mask)) context.error(GL_STACK_OVERFLOW);
}

void PopAttrib(Context& context) {
    if (!context.attributes.pop(context)) context.error(GL_STACK_UNDERFLOW);
}

void PushClientAttrib(Context& context, GLbitfield mask) {
    if (!context.attributes.push_client(context, mask)) context.error(GL_STACK_OVERFLOW);
}

void PopClientAttrib(Context& context) {
    if (!context.attributes.pop_client(context)) context.error(GL_STACK_UNDERFLOW);
}

} // namespace ffgpu::gl::api
