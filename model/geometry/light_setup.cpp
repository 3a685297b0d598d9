#include "model/geometry/light_setup.h"

#include "model/base/in_place.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace ffgpu {
namespace {

Vec3 xyz(const Vec4& v) {
    return {v[0], v[1], v[2]};
}

// Of a light: 0 times it must be 0.
Vec3 finite_color(const Vec4& v) {
    Vec3 color = xyz(v);
    for (float& c : color)
        if (!std::isfinite(c)) c = 0;
    return color;
}

bool is_black(const Vec3& color) {
    return color == Vec3{0, 0, 0};
}

// The zero vector stays zero.
Vec3 normalized(const Vec3& v) {
    const float length = std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
    if (!(length > 0)) return {0, 0, 0};
    return {v[0] / length, v[1] / length, v[2] / length};
}

LightSource make_light_source(const Light& light) {
    LightSource source;
    const float w = light.position[3];
    source.directional = w == 0;
    if (source.directional) {
        source.position = normalized(xyz(light.position));
        const auto [x, y, z] = source.position;
        source.half_way = normalized({x, y, z + 1});
    } else {
        source.position = {light.position[0] / w, light.position[1] / w, light.position[2] / w};
        source.attenuates = light.attenuation != Vec3{1, 0, 0};
    }
    source.ambient = finite_color(light.ambient);
    source.diffuse = finite_color(light.diffuse);
    source.specular = finite_color(light.specular);
    source.attenuation = light.attenuation;
    source.spot = light.spot_cutoff_cosine >= -0.5f;
    source.spot_direction = light.spot_direction;
    source.spot_exponent = light.spot_exponent;
    source.spot_cutoff_cosine = light.spot_cutoff_cosine;
    return source;
}

MaterialSide make_material_side(const Material& material, std::uint8_t color_material) {
    MaterialSide side;
    side.emission = xyz(material.emission);
    side.ambient = xyz(material.ambient);
    side.diffuse = xyz(material.diffuse);
    side.specular = xyz(material.specular);
    side.alpha = material.diffuse[3];
    side.shininess = material.shininess;
    side.color_material = color_material;
    side.has_specular = !is_black(side.specular) || (color_material & ColorMaterialSpecular) != 0;
    return side;
}

} // namespace

LightingSetup make_lighting_setup(const Lighting& lighting,
                                  const std::array<Light, Lights>& lights,
                                  const std::array<Material, 2>& materials) {
    LightingSetup setup;
    setup.enable = lighting.enable;
    setup.two_sided = lighting.two_sided;
    setup.separate_specular = lighting.separate_specular;
    setup.scene_ambient = xyz(lighting.scene_ambient);
    make_in_place(setup.sides[0],
                  [&] { return make_material_side(materials[0], lighting.color_material_front); });
    make_in_place(setup.sides[1],
                  [&] { return make_material_side(materials[1], lighting.color_material_back); });

    const bool specular =
        setup.sides[0].has_specular || (setup.two_sided && setup.sides[1].has_specular);
    for (const Light& light : lights)
        if (light.enable)
            make_in_place(setup.lights[setup.count++], [&] { return make_light_source(light); });

    // The viewer's place matters to the specular terms alone.
    setup.local_viewer = lighting.local_viewer && specular;
    const auto used = std::span(setup.lights).first(setup.count);
    setup.needs_view =
        (setup.local_viewer && setup.count > 0) ||
        std::any_of(used.begin(), used.end(), [](const auto& light) { return !light.directional; });
    return setup;
}

} // namespace ffgpu
