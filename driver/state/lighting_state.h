// Colours and colouring (GL 1.5, 2.14; state tables 6.8 to 6.10). All of it is GL_LIGHTING_BIT.

#pragma once

#include "driver/gl_types.h"
#include "model/device/registers/geometry.h"

#include <array>

namespace ffgpu::gl {

struct LightSource {
    bool enable = false;
    Vec4 ambient{0, 0, 0, 1};
    Vec4 diffuse{0, 0, 0, 1}; // Light 0: 1, 1, 1, 1, as its specular colour.
    Vec4 specular{0, 0, 0, 1};
    Vec4 position{0, 0, 1, 0};                     // in eye coordinates
    std::array<float, 3> spot_direction{0, 0, -1}; // in eye coordinates, not normalised
    float spot_exponent = 0;
    float spot_cutoff = 180;                   // in degrees
    std::array<float, 3> attenuation{1, 0, 0}; // constant, linear, quadratic
};

struct MaterialFace {
    Vec4 ambient{0.2f, 0.2f, 0.2f, 1};
    Vec4 diffuse{0.8f, 0.8f, 0.8f, 1};
    Vec4 specular{0, 0, 0, 1};
    Vec4 emission{0, 0, 0, 1};
    float shininess = 0;
    std::array<float, 3> color_indexes{0, 1, 1}; // ambient, diffuse, specular

    bool operator==(const MaterialFace&) const = default;
};

struct LightModel {
    Vec4 ambient{0.2f, 0.2f, 0.2f, 1};
    bool local_viewer = false;
    bool two_side = false;
    GLenum color_control = GL_SINGLE_COLOR;
};

struct ColorMaterialState {
    bool enable = false;
    GLenum face = GL_FRONT_AND_BACK;
    GLenum mode = GL_AMBIENT_AND_DIFFUSE;
};

struct LightingState {
    bool enable = false;
    GLenum shade_model = GL_SMOOTH;
    LightModel model;
    ColorMaterialState color_material;
    std::array<MaterialFace, 2> materials; // front, back
    std::array<LightSource, Lights> lights = [] {
        std::array<LightSource, Lights> all{};
        all[0].diffuse = all[0].specular = {1, 1, 1, 1};
        return all;
    }();
};

} // namespace ffgpu::gl
