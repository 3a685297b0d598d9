#include "driver/texture/saved_textures.h"

namespace ffgpu::gl {

SavedTextures save_textures(const TextureState& state) {
    SavedTextures saved{state, {}};
    for (std::size_t unit = 0; unit < TextureUnits; ++unit) {
        for (std::size_t target = 0; target < TextureTargets; ++target)
            saved.parameters[unit][target] = state.units[unit].bound[target]->parameters;
    }
    return saved;
}

void restore_textures(const SavedTextures& saved, TextureState& state) {
    state = saved.state;
    for (std::size_t unit = 0; unit < TextureUnits; ++unit) {
        for (std::size_t target = 0; target < TextureTargets; ++target) {
            std::shared_ptr<TextureObject>& texture = state.units[unit].bound[target];
            if (texture->deleted)
                texture = state.defaults[target];
            else if (texture->parameters != saved.parameters[unit][target]) {
                texture->parameters = saved.parameters[unit][target];
                texture->changed();
            }
        }
    }
}

} // namespace ffgpu::gl
