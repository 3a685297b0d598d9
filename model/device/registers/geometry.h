// Registers of the geometry stage: transform, lighting, texture coordinate generation, clipping,
// viewport. Matrices are column-major, m[column * 4 + row], as OpenGL's.

#pragma once

#include "model/device/layout/limits.h"

#include <array>
#include <cstdint>

namespace ffgpu {

using Vec4 = std::array<float, 4>;
using Mat4 = std::array<float, 16>;

constexpr Mat4 Identity4{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

template <class Array, class Visitor>
constexpr void visit_floats(const char* name, Array& values, Visitor&& field) {
    for (auto& value : values)
        field(name, value);
}

enum class NormalMode : std::uint8_t { Keep, Rescale, Normalize };

struct Transform {
    static constexpr const char* Name = "transform";

    Mat4 model_view = Identity4;
    Mat4 projection = Identity4;
    // Row-major 3x3 for n_eye[i] = sum_j normal_matrix[3 * i + j] n[j]: the inverse transpose of
    // model_view's upper left 3x3.
    std::array<float, 9> normal_matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};
    float rescale = 1; // NormalMode::Rescale: factor on the transformed normal.
    NormalMode normal_mode = NormalMode::Keep;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        visit_floats("model_view", self.model_view, field);
        visit_floats("projection", self.projection, field);
        visit_floats("normal_matrix", self.normal_matrix, field);
        field("rescale", self.rescale);
        field("normal_mode", self.normal_mode, 2);
    }
    bool operator==(const Transform&) const = default;
};

// Which material colours follow the vertex's primary colour, as one bit per ColorMaterialBit.
enum ColorMaterialBit : std::uint8_t {
    ColorMaterialAmbient = 1,
    ColorMaterialDiffuse = 2,
    ColorMaterialSpecular = 4,
    ColorMaterialEmission = 8,
};

struct Lighting {
    static constexpr const char* Name = "lighting";

    bool enable = false;
    bool two_sided = false;
    bool local_viewer = false;
    bool separate_specular = false;
    std::uint8_t color_material_front = 0; // ColorMaterialBits
    std::uint8_t color_material_back = 0;
    Vec4 scene_ambient{0.2f, 0.2f, 0.2f, 1};

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, 1);
        field("two_sided", self.two_sided, 1);
        field("local_viewer", self.local_viewer, 1);
        field("separate_specular", self.separate_specular, 1);
        field("color_material_front", self.color_material_front, 4);
        field("color_material_back", self.color_material_back, 4);
        visit_floats("scene_ambient", self.scene_ambient, field);
    }
    bool operator==(const Lighting&) const = default;
};

struct Light {
    static constexpr const char* Name = "light";

    bool enable = false;
    Vec4 ambient{0, 0, 0, 1};
    Vec4 diffuse{0, 0, 0, 1};
    Vec4 specular{0, 0, 0, 1};
    Vec4 position{0, 0, 1, 0};                     // eye space; w = 0: directional
    std::array<float, 3> spot_direction{0, 0, -1}; // eye space, normalised
    float spot_exponent = 0;
    float spot_cutoff_cosine = -1;             // below -0.5: not a spot light (cut-off 180 degrees)
    std::array<float, 3> attenuation{1, 0, 0}; // constant, linear, quadratic

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, 1);
        visit_floats("ambient", self.ambient, field);
        visit_floats("diffuse", self.diffuse, field);
        visit_floats("specular", self.specular, field);
        visit_floats("position", self.position, field);
        visit_floats("spot_direction", self.spot_direction, field);
        field("spot_exponent", self.spot_exponent);
        field("spot_cutoff_cosine", self.spot_cutoff_cosine);
        visit_floats("attenuation", self.attenuation, field);
    }
    bool operator==(const Light&) const = default;
};

struct Material {
    static constexpr const char* Name = "material"; // 0 front, 1 back

    Vec4 ambient{0.2f, 0.2f, 0.2f, 1};
    Vec4 diffuse{0.8f, 0.8f, 0.8f, 1};
    Vec4 specular{0, 0, 0, 1};
    Vec4 emission{0, 0, 0, 1};
    float shininess = 0;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        visit_floats("ambient", self.ambient, field);
        visit_floats("diffuse", self.diffuse, field);
        visit_floats("specular", self.specular, field);
        visit_floats("emission", self.emission, field);
        field("shininess", self.shininess);
    }
    bool operator==(const Material&) const = default;
};

enum class TexGenMode : std::uint8_t {
    Off,
    ObjectLinear,
    EyeLinear,
    SphereMap,
    NormalMap,
    ReflectionMap,
};

// Generation of one unit's texture coordinates, then its matrix.
struct TexCoordSetup {
    static constexpr const char* Name = "tex_coord_setup";

    std::array<TexGenMode, 4> mode{}; // of s, t, r, q
    std::array<Vec4, 4> plane{};      // the plane of the mode in force, object or eye space
    bool matrix_enable = false;       // false: the matrix is the identity
    Mat4 matrix = Identity4;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        for (auto& mode : self.mode)
            field("mode", mode, 3);
        field("matrix_enable", self.matrix_enable, 1);
        for (auto& plane : self.plane)
            visit_floats("plane", plane, field);
        visit_floats("matrix", self.matrix, field);
    }
    bool operator==(const TexCoordSetup&) const = default;
};

struct UserClipPlanes {
    static constexpr const char* Name = "user_clip_planes";

    std::uint8_t enable = 0;               // one bit a plane
    std::array<Vec4, ClipPlanes> planes{}; // eye space; kept where dot(plane, position) >= 0

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, ClipPlanes);
        for (auto& plane : self.planes)
            visit_floats("plane", plane, field);
    }
    bool operator==(const UserClipPlanes&) const = default;
};

struct Viewport {
    static constexpr const char* Name = "viewport";

    float x = 0, y = 0; // lower left corner, in pixels
    float width = 0, height = 0;
    float near_depth = 0, far_depth = 1; // in [0, 1]
    bool clamp_depth = false;            // instead of clipping at near and far (ARB_depth_clamp)

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("clamp_depth", self.clamp_depth, 1);
        field("x", self.x);
        field("y", self.y);
        field("width", self.width);
        field("height", self.height);
        field("near_depth", self.near_depth);
        field("far_depth", self.far_depth);
    }
    bool operator==(const Viewport&) const = default;
};

enum class FogCoordinateSource : std::uint8_t {
    EyeZ,       // |z_eye|
    EyeZSigned, // z_eye, which is negative before the eye (NV_fog_distance)
    EyeRadial,  // distance to the eye
    Attribute,  // the FogCoordinate attribute
};

} // namespace ffgpu
