#include "driver/lower/textures.h"

#include "driver/context/context.h"
#include "driver/lower/combiner.h"
#include "driver/lower/sampler.h"
#include "driver/lower/texture_image.h"
#include "driver/objects/shared_objects.h"
#include "driver/texture/residency.h"

namespace ffgpu::gl {

namespace {

// The texture that the unit samples, in device memory; null where the unit is off.
TextureObject* usable_texture(Context& context, const TextureUnit& unit) {
    TextureObject* const texture = texture_in_force(unit);
    if (!texture || !texture->chain().complete) return nullptr;
    if (texture->resident_is_current()) return texture;
    context.dirty.mark(Dirty::Targets);
    if (!make_resident({context.device(), context.shared().memory}, *texture)) {
        context.error(GL_OUT_OF_MEMORY);
        return nullptr;
    }
    return texture;
}

} // namespace

void lower_textures(Context& context, Registers& registers) {
    const TextureState& state = context.state.texture;
    SampledFormats formats{};
    for (unsigned i = 0; i < TextureUnits; ++i) {
        TextureObject* const texture = usable_texture(context, state.units[i]);
        registers.images[i] = texture ? lower_texture_image(*texture) : TextureImage{};
        registers.samplers[i] =
            texture ? lower_sampler(*texture, state.units[i].environment.lod_bias) : Sampler{};
        formats[i] = texture ? sampled_format(*texture) : BaseFormat::None;
    }
    for (unsigned i = 0; i < TextureUnits; ++i)
        registers.combiners[i] = lower_combiner(state.units[i].environment, i, formats);
}

} // namespace ffgpu::gl
