#include "driver/state/capabilities.h"

#include <array>

namespace ffgpu::gl {
namespace {

template <class... Groups>
constexpr DirtyGroups marks(Groups... groups) {
    DirtyGroups dirty;
    (dirty.mark(groups), ...);
    return dirty;
}

// A row of one flag that is not a texture unit's.
#define FLAG(name, expression, ...)                                                                \
    Capability {                                                                                   \
        name, 1, false, marks(__VA_ARGS__),                                                        \
            [](State& s, unsigned, unsigned) -> bool& { return s.expression; }                     \
    }

// A row of `count` flags with consecutive tokens, by index i.
#define FLAGS(name, count, expression, ...)                                                        \
    Capability {                                                                                   \
        name, count, false, marks(__VA_ARGS__),                                                    \
            [](State& s, unsigned, unsigned i) -> bool& { return s.expression; }                   \
    }

template <TextureTarget Target>
constexpr Capability texture_target(GLenum name) {
    return {name,
            1,
            true,
            marks(Dirty::Textures, Dirty::Environments),
            [](State& s, unsigned unit, unsigned) -> bool& {
                return s.texture.units[unit].enabled[static_cast<std::size_t>(Target)];
            }};
}

constexpr std::array Table{
    FLAG(GL_ALPHA_TEST, fragment.alpha_test.enable, Dirty::Fragment),
    FLAG(GL_AUTO_NORMAL, evaluator.settings.auto_normal),
    FLAG(GL_BLEND, fragment.blend.enable, Dirty::Fragment),
    FLAGS(GL_CLIP_PLANE0, ClipPlanes, transform.group.clip_plane_enable[i], Dirty::ClipPlanes),
    FLAG(GL_COLOR_LOGIC_OP, fragment.blend.color_logic_op, Dirty::Fragment),
    FLAG(GL_COLOR_MATERIAL, lighting.color_material.enable, Dirty::Lighting),
    FLAG(GL_COLOR_SUM, fragment.fog.color_sum, Dirty::Fragment),
    FLAG(GL_CULL_FACE, rasterization.polygon.cull, Dirty::Primitive),
    FLAG(GL_DEPTH_BOUNDS_TEST_EXT, fragment.depth.bounds_test, Dirty::Fragment),
    FLAG(GL_DEPTH_CLAMP, transform.group.depth_clamp, Dirty::Viewport),
    FLAG(GL_DEPTH_TEST, fragment.depth.enable, Dirty::Fragment),
    FLAG(GL_DITHER, fragment.blend.dither, Dirty::Fragment),
    FLAG(GL_FOG, fragment.fog.enable, Dirty::Fragment),
    FLAG(GL_FRAMEBUFFER_SRGB, fragment.blend.framebuffer_srgb, Dirty::Fragment),
    FLAG(GL_INDEX_LOGIC_OP, fragment.blend.index_logic_op),
    FLAGS(GL_LIGHT0, Lights, lighting.lights[i].enable, Dirty::Lighting),
    FLAG(GL_LIGHTING, lighting.enable, Dirty::Lighting, Dirty::Fragment),
    FLAG(GL_LINE_SMOOTH, rasterization.line.smooth, Dirty::Primitive),
    FLAG(GL_LINE_STIPPLE, rasterization.line.stipple, Dirty::Primitive),
    FLAGS(GL_MAP1_COLOR_4, MapCount, evaluator.settings.map1_enable[i]),
    FLAGS(GL_MAP2_COLOR_4, MapCount, evaluator.settings.map2_enable[i]),
    FLAG(GL_MULTISAMPLE, rasterization.multisample.enable, Dirty::Fragment),
    FLAG(GL_NORMALIZE, transform.group.normalize, Dirty::Matrices),
    FLAG(GL_POINT_SMOOTH, rasterization.point.smooth, Dirty::Primitive),
    FLAG(GL_POINT_SPRITE, rasterization.point.sprite, Dirty::Primitive),
    FLAG(GL_POLYGON_OFFSET_FILL, rasterization.polygon.offset_fill, Dirty::Primitive),
    FLAG(GL_POLYGON_OFFSET_LINE, rasterization.polygon.offset_line, Dirty::Primitive),
    FLAG(GL_POLYGON_OFFSET_POINT, rasterization.polygon.offset_point, Dirty::Primitive),
    FLAG(GL_POLYGON_SMOOTH, rasterization.polygon.smooth, Dirty::Primitive),
    FLAG(GL_POLYGON_STIPPLE, rasterization.polygon.stipple, Dirty::Primitive),
    FLAG(GL_RESCALE_NORMAL, transform.group.rescale_normal, Dirty::Matrices),
    FLAG(GL_SAMPLE_ALPHA_TO_COVERAGE, rasterization.multisample.alpha_to_coverage, Dirty::Fragment),
    FLAG(GL_SAMPLE_ALPHA_TO_ONE, rasterization.multisample.alpha_to_one, Dirty::Fragment),
    FLAG(GL_SAMPLE_COVERAGE, rasterization.multisample.sample_coverage, Dirty::Fragment),
    FLAG(GL_SCISSOR_TEST, fragment.scissor.enable, Dirty::Viewport),
    FLAG(GL_STENCIL_TEST, fragment.stencil.enable, Dirty::Fragment),
    FLAG(GL_STENCIL_TEST_TWO_SIDE_EXT, fragment.stencil.two_side, Dirty::Fragment),
    texture_target<TextureTarget::OneD>(GL_TEXTURE_1D),
    texture_target<TextureTarget::TwoD>(GL_TEXTURE_2D),
    texture_target<TextureTarget::ThreeD>(GL_TEXTURE_3D),
    texture_target<TextureTarget::Cube>(GL_TEXTURE_CUBE_MAP),
    texture_target<TextureTarget::Rectangle>(GL_TEXTURE_RECTANGLE),
    Capability{GL_TEXTURE_GEN_S,
               4,
               true,
               marks(Dirty::TexGen),
               [](State& s, unsigned unit, unsigned i) -> bool& {
                   return s.texture.units[unit].gen[i].enabled;
               }},
};

#undef FLAG
#undef FLAGS

} // namespace

std::span<const Capability> capabilities() {
    return Table;
}

const Capability* find_capability(GLenum name) {
    for (const Capability& capability : Table) {
        if (name - capability.name < capability.count) return &capability;
    }
    return nullptr;
}

} // namespace ffgpu::gl
