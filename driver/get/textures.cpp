// Texture units: the active one, and its bindings (GL 1.5, state table 6.13).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"
#include "driver/objects/texture_object.h"

#include <array>

namespace ffgpu::gl {
namespace {

StateValue binding(const State& state, TextureTarget target) {
    return values::integer(state.texture.active().bound[static_cast<std::size_t>(target)]->name());
}

} // namespace

std::span<const StateVariable> texture_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_ACTIVE_TEXTURE, integer(GL_TEXTURE0 + s.texture.active_unit)),
        FFGPU_STATE(GL_TEXTURE_BINDING_1D, binding(s, TextureTarget::OneD)),
        FFGPU_STATE(GL_TEXTURE_BINDING_2D, binding(s, TextureTarget::TwoD)),
        FFGPU_STATE(GL_TEXTURE_BINDING_3D, binding(s, TextureTarget::ThreeD)),
        FFGPU_STATE(GL_TEXTURE_BINDING_CUBE_MAP, binding(s, TextureTarget::Cube)),
        FFGPU_STATE(GL_TEXTURE_BINDING_RECTANGLE, binding(s, TextureTarget::Rectangle)),
    };
    return Table;
}

} // namespace ffgpu::gl
