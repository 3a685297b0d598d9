// LightingSetup: the enabled lights and the materials of a draw, ready for the lighting stage.

#pragma once

#include "model/device/registers/geometry.h"

#include <array>
#include <cstdint>

namespace ffgpu {

using Vec3 = std::array<float, 3>;

struct LightSource {
    bool directional = true;
    bool attenuates = false; // not directional, and its factors are not 1, 0, 0
    bool spot = false;
    Vec3 position{}; // divided by w; of a directional light the direction towards it, normalised
    Vec3 half_way{}; // directional lights with the viewer at infinity: the vector h, normalised
    Vec3 ambient{}, diffuse{}, specular{};
    Vec3 attenuation{};
    Vec3 spot_direction{};
    float spot_exponent = 0;
    float spot_cutoff_cosine = -1;
};

struct MaterialSide {
    Vec3 emission{}, ambient{}, diffuse{}, specular{};
    float alpha = 1;
    float shininess = 0;
    bool has_specular = false;       // else the specular terms are left out
    std::uint8_t color_material = 0; // ColorMaterialBits: replaced by the vertex's colour
};

struct LightingSetup {
    bool enable = false;
    bool two_sided = false;
    bool local_viewer = false;
    bool separate_specular = false;
    bool needs_view = false; // a light or the viewer is at a finite place
    Vec3 scene_ambient{};
    unsigned count = 0;
    std::array<LightSource, Lights> lights;
    std::array<MaterialSide, 2> sides; // front and back
};

LightingSetup make_lighting_setup(const Lighting& lighting,
                                  const std::array<Light, Lights>& lights,
                                  const std::array<Material, 2>& materials);

} // namespace ffgpu
