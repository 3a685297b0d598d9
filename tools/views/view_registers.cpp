#include "tools/views/view.h"

namespace ffgpu::tools {
namespace {

void take_textures(Registers& registers) {
    registers.images = {};
    registers.combiners = {};
}

// What is drawn is what primitives have, and nothing is mixed into it.
void take_mixing(Registers& registers) {
    registers.fog.mode = FogMode::Off;
    registers.fragment.color_sum = false;
    registers.fragment.alpha_test = false;
    const std::uint8_t write_mask = registers.blend.write_mask;
    registers.blend = {};
    registers.blend.write_mask = write_mask;
}

// One colour instead of all that environments make of textures.
void replace_color(Registers& registers, CombineSource source) {
    Combiner& combiner = registers.combiners[0];
    combiner.enable = true;
    combiner.rgb.arguments[0] = {source, CombineOperand::Color};
    combiner.alpha.arguments[0] = {CombineSource::One, CombineOperand::Alpha};
}

void draw_lines(Registers& registers) {
    take_textures(registers);
    take_mixing(registers);
    replace_color(registers, CombineSource::One);
    registers.primitive.front_mode = registers.primitive.back_mode = PolygonMode::Line;
    registers.primitive.polygon_stipple = false;
}

// Six directional lights make the colour 1/2 + n/2 of the eye-space normal n: each adds or takes
// its axis's half where the normal faces it.
void light_by_normals(Registers& registers) {
    take_textures(registers);
    take_mixing(registers);
    registers.lighting = {};
    registers.lighting.enable = true;
    registers.lighting.scene_ambient = {0, 0, 0, 1};
    Material material;
    material.ambient = material.specular = {0, 0, 0, 1};
    material.diffuse = {1, 1, 1, 1};
    material.emission = {0.5f, 0.5f, 0.5f, 1};
    registers.materials = {material, material};
    registers.lights = {};
    for (unsigned i = 0; i < 6; ++i) {
        const unsigned axis = i / 2;
        const float sign = i % 2 == 0 ? 1.0f : -1.0f;
        Light& light = registers.lights[i];
        light.enable = true;
        light.ambient = light.diffuse = light.specular = light.position = {};
        light.diffuse[axis] = sign / 2;
        light.position[axis] = sign;
    }
    registers.transform.normal_mode = NormalMode::Normalize;
    registers.primitive.flat_shading = false;
}

// Unit 0's coordinates as colours; what has no texture there stays black.
void show_coordinates(Registers& registers, DeviceAddress texture) {
    const bool has_texture = registers.images[0].shape.kind != TextureKind::None;
    take_textures(registers);
    take_mixing(registers);
    replace_color(registers, has_texture ? CombineSource::Texture0 : CombineSource::Zero);
    if (!has_texture) return;
    TextureImage& image = registers.images[0];
    image.shape = {.kind = TextureKind::TwoD,
                   .format = Format::Rgba8,
                   .width = ViewTextureSize,
                   .height = ViewTextureSize};
    image.address = texture;
    registers.samplers[0] = {};
    registers.samplers[0].magnify_linear = false;
    registers.samplers[0].mip_filter = MipFilter::None;
}

} // namespace

std::vector<std::byte> view_texture() {
    std::vector<std::byte> texels;
    texels.reserve(std::size_t{4} * ViewTextureSize * ViewTextureSize);
    for (std::uint32_t t = 0; t < ViewTextureSize; ++t)
        for (std::uint32_t s = 0; s < ViewTextureSize; ++s)
            for (const std::uint32_t value : {s, t, 0u, 255u})
                texels.push_back(static_cast<std::byte>(value));
    return texels;
}

Registers view_registers(View view, const Registers& registers, DeviceAddress texture) {
    Registers changed = registers;
    switch (view) {
    case View::Wireframe:
        draw_lines(changed);
        break;
    case View::Normals:
        light_by_normals(changed);
        break;
    case View::TexCoord:
        show_coordinates(changed, texture);
        break;
    case View::Unlit:
        changed.lighting.enable = false;
        break;
    case View::Untextured:
        take_textures(changed);
        break;
    case View::BeforeFog:
        changed.fog.mode = FogMode::Off;
        break;
    default:
        break;
    }
    return changed;
}

} // namespace ffgpu::tools
