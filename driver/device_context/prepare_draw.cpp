// DeviceContext::prepare_draw(): dirty groups of state become register values.

#include "driver/device_context/device_context.h"
#include "driver/device_context/textures_in_use.h"
#include "driver/framebuffer/drawable.h"
#include "driver/lower/combiner.h"
#include "driver/lower/fragment.h"
#include "driver/lower/lighting.h"
#include "driver/lower/primitive.h"
#include "driver/lower/sampler.h"
#include "driver/lower/targets.h"
#include "driver/lower/texture_image.h"
#include "driver/lower/transform.h"
#include "model/base/in_place.h"

namespace ffgpu::gl {
namespace {

void lower_matrices(const State& state, RegisterFile& registers) {
    make_in_place(registers.wanted.transform, [&] { return lower_transform(state.transform); });
    registers.update<&Registers::transform>();
}

void lower_lighting(const LightingState& lighting, RegisterFile& registers) {
    make_in_place(registers.wanted.lighting, [&] { return lower_lighting(lighting); });
    registers.update<&Registers::lighting>();
    for (unsigned i = 0; i < Lights; ++i)
        make_in_place(registers.wanted.lights[i], [&] { return lower_light(lighting.lights[i]); });
    registers.update<&Registers::lights>();
    for (unsigned i = 0; i < 2; ++i)
        make_in_place(registers.wanted.materials[i],
                      [&] { return lower_material(lighting.materials[i]); });
    registers.update<&Registers::materials>();
}

void lower_tex_coords(const State& state, RegisterFile& registers) {
    for (unsigned i = 0; i < TextureUnits; ++i) {
        registers.wanted.tex_coords[i] =
            lower_tex_coords(state.texture.units[i], state.transform.matrices.texture[i].top());
    }
    registers.update<&Registers::tex_coords>();
}

void lower_primitives(const State& state, RegisterFile& registers) {
    registers.wanted.primitive =
        lower_primitive(state.rasterization, state.texture, state.lighting.shade_model);
    registers.update<&Registers::primitive>();
    registers.wanted.polygon_stipple = lower_polygon_stipple(state.rasterization);
    registers.update<&Registers::polygon_stipple>();
}

void lower_texturing(const TextureState& state,
                     const TexturesInUse& textures,
                     RegisterFile& registers) {
    SampledFormats formats{};
    for (unsigned i = 0; i < TextureUnits; ++i) {
        const TextureObject* const texture = textures[i];
        const float lod_bias = state.units[i].environment.lod_bias;
        registers.wanted.images[i] = texture ? lower_texture_image(*texture) : TextureImage{};
        registers.wanted.samplers[i] = texture ? lower_sampler(*texture, lod_bias) : Sampler{};
        formats[i] = texture ? sampled_format(*texture) : BaseFormat::None;
    }
    for (unsigned i = 0; i < TextureUnits; ++i)
        registers.wanted.combiners[i] = lower_combiner(state.units[i].environment, i, formats);
    registers.update<&Registers::images>();
    registers.update<&Registers::samplers>();
    registers.update<&Registers::combiners>();
}

void lower_fragments(const DeviceContext& context,
                     const DrawTarget& target,
                     RegisterFile& registers) {
    const DepthTarget depth = target.depth;
    const FragmentState& fragment = context.state.fragment;
    registers.wanted.fog = lower_fog(fragment.fog);
    registers.update<&Registers::fog>();
    registers.wanted.fragment = lower_fragment_control(
        fragment, context.state.lighting, context.queries.active != 0, target.srgb_capable);
    registers.update<&Registers::fragment>();
    registers.wanted.stencil = lower_stencil(fragment.stencil, depth);
    registers.update<&Registers::stencil>();
    registers.wanted.depth = lower_depth(fragment.depth, depth);
    registers.update<&Registers::depth>();
    registers.wanted.blend = lower_blend(fragment.blend, context.state.framebuffer.color_mask);
    registers.update<&Registers::blend>();
    registers.wanted.multisample = lower_multisample(context.state.rasterization.multisample);
    registers.update<&Registers::multisample>();
}

} // namespace

void DeviceContext::lower_state() {
    if (draw_drawable_ && !state.framebuffer.draw_object) draw_drawable_->settle();
    if (draw_drawable_ && draw_drawable_->generation() != drawable_generation_) {
        drawable_generation_ = draw_drawable_->generation();
        dirty.mark(Dirty::Targets);
    }
    if (dirty == DirtyGroups{}) [[likely]]
        return;

    const auto any = [&](auto... groups) { return (dirty.has(groups) || ...); };
    // What was a target until now may be a texture whose filter has a table of it.
    if (dirty.has(Dirty::Targets)) dirty.mark(Dirty::Textures);
    // First: textures that move in device memory make the targets dirty.
    if (any(Dirty::Textures, Dirty::Environments))
        lower_texturing(state.texture, bring_textures(*this), registers);
    if (dirty.has(Dirty::Targets)) {
        draw_target_ = find_draw_target(*this);
        registers.wanted.targets = draw_target_.targets;
        registers.update<&Registers::targets>();
    }
    if (dirty.has(Dirty::Matrices)) lower_matrices(state, registers);
    if (any(Dirty::TextureMatrices, Dirty::TexGen)) lower_tex_coords(state, registers);
    if (dirty.has(Dirty::Lighting)) lower_lighting(state.lighting, registers);
    if (dirty.has(Dirty::ClipPlanes)) {
        registers.wanted.clip_planes = lower_clip_planes(state.transform.group);
        registers.update<&Registers::clip_planes>();
    }
    if (any(Dirty::Viewport, Dirty::Targets)) {
        registers.wanted.viewport =
            lower_viewport(state.transform.viewport, state.transform.group.depth_clamp);
        registers.update<&Registers::viewport>();
        registers.wanted.scissor =
            lower_scissor(state.fragment.scissor, draw_target_.width, draw_target_.height);
        registers.update<&Registers::scissor>();
    }
    // Point sprites replace coordinates as the texture environments say.
    if (any(Dirty::Primitive, Dirty::Environments)) lower_primitives(state, registers);
    if (any(Dirty::Fragment, Dirty::Targets)) lower_fragments(*this, draw_target_, registers);
    dirty.clear();
}

bool DeviceContext::prepare_draw() {
    lower_state();
    if (draw_target_.status != GL_FRAMEBUFFER_COMPLETE) [[unlikely]] {
        error(GL_INVALID_FRAMEBUFFER_OPERATION);
        return false;
    }
    if (draw_target_.resolved_window) [[unlikely]]
        draw_target_.resolved_window->note_drawing();
    return draw_target_.width > 0 && draw_target_.height > 0;
}

} // namespace ffgpu::gl
