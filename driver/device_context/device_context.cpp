#include "driver/device_context/device_context.h"

#include "driver/device_context/supersampling.h"
#include "driver/objects/shared_objects.h"
#include "driver/texture/residency.h"

#include <utility>

namespace ffgpu::gl {

DeviceContext::DeviceContext(Device& device, std::shared_ptr<SharedObjects> shared)
    : device_(device)
    , shared_(std::move(shared)) {}

DeviceContext::~DeviceContext() = default;

DeviceMemory DeviceContext::device_memory() {
    return {device_, shared_->memory};
}

void DeviceContext::set_drawables(Drawable* draw, Drawable* read) {
    draw_drawable_ = draw;
    read_drawable_ = read;
}

void DeviceContext::error(GLenum code) {
    if (error_ == GL_NO_ERROR) error_ = code;
}

GLenum DeviceContext::take_error() {
    return std::exchange(error_, GL_NO_ERROR);
}

void DeviceContext::submit(const CommandStream& commands) {
    CommandStream& pending = registers.pending();
    if (!pending.empty()) {
        device_.submit(pending);
        pending.clear();
    }
    device_.submit(commands);
}

void DeviceContext::submit_drawing(const CommandStream& commands) {
    if (draw_target_.supersampling == 1) [[likely]]
        return submit(commands);
    submit_to_pictures(*this, commands);
}

} // namespace ffgpu::gl
