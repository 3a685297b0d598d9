#include "driver/device_context/textures_in_use.h"

#include "driver/device_context/device_context.h"
#include "driver/objects/shared_objects.h"
#include "driver/texture/filter_table.h"
#include "driver/texture/residency.h"

namespace ffgpu::gl {
namespace {

// Of the enabled targets of a unit the one of the highest precedence (GL 1.5, 3.8.15). Null: none.
TextureObject* texture_in_force(const TextureUnit& unit) {
    for (std::size_t target = TextureTargets; target-- > 0;) {
        if (unit.enabled[target]) return unit.bound[target].get();
    }
    return nullptr;
}

const TextureObject* bring_texture(DeviceContext& context, const TextureUnit& unit) {
    TextureObject* const texture = texture_in_force(unit);
    if (!texture || !texture->chain().complete) return nullptr;
    const ForcedFilter forced = context.shared().control_panel.texture_filter;
    if (forced != ForcedFilter::AsAsked) texture->forced_filter = filter_token(forced);
    if (!texture->resident_is_current()) {
        context.dirty.mark(Dirty::Targets);
        if (!make_resident(context.device_memory(), *texture)) {
            context.error(GL_OUT_OF_MEMORY);
            return nullptr;
        }
    }
    bring_filter_table(context.device_memory(), *texture);
    return texture;
}

} // namespace

TexturesInUse bring_textures(DeviceContext& context) {
    TexturesInUse textures{};
    for (unsigned i = 0; i < TextureUnits; ++i)
        textures[i] = bring_texture(context, context.state.texture.units[i]);
    return textures;
}

} // namespace ffgpu::gl
