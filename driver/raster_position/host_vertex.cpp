#include "driver/raster_position/host_vertex.h"

#include "driver/math/matrix.h"
#include "model/arith/power.h"

#include <algorithm>
#include <cmath>

namespace ffgpu::gl {

namespace {

using Vec3 = std::array<float, 3>;

float dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

float dot(const Vec4& a, const Vec4& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Vec3 scale(const Vec3& v, float factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Vec3 normalize(const Vec3& v) {
    const float length = std::sqrt(dot(v, v));
    return length > 0 ? scale(v, 1 / length) : v;
}

Vec3 xyz(const Vec4& v) {
    return {v[0], v[1], v[2]};
}

// From a to b, where either may be a direction (w = 0); normalised.
Vec3 direction(const Vec4& a, const Vec4& b) {
    if (a[3] != 0 && b[3] == 0) return normalize(xyz(b));
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = b[i] * (a[3] != 0 ? a[3] : 1) - a[i] * (b[3] != 0 ? b[3] : 1);
    return normalize(result);
}

Vec4 clamp(const Vec4& color) {
    Vec4 result{};
    std::transform(color.begin(), color.end(), result.begin(), [](float c) {
        return c >= 1 ? 1.0f : c > 0 ? c : 0.0f;
    });
    return result;
}

void add_product(Vec4& sum, const Vec4& a, const Vec4& b, float factor) {
    for (std::size_t i = 0; i < 3; ++i)
        sum[i] += factor * a[i] * b[i];
}

// How much of a light arrives: attenuation and spot.
float strength(const Light& light, const EyeVertex& vertex, const Vec3& to_light) {
    float result = 1;
    if (light.position[3] != 0) {
        Vec3 way{};
        for (std::size_t i = 0; i < 3; ++i)
            way[i] =
                light.position[i] / light.position[3] - vertex.position[i] / vertex.position[3];
        const float d = std::sqrt(dot(way, way));
        result =
            1 / (light.attenuation[0] + light.attenuation[1] * d + light.attenuation[2] * d * d);
    }
    if (light.spot_cutoff_cosine < -0.5f) return result;
    const float cosine = -dot(to_light, light.spot_direction);
    if (cosine < light.spot_cutoff_cosine) return 0;
    return result * power(cosine, light.spot_exponent);
}

Material tracked_material(const Registers& registers, const Vec4& color) {
    Material material = registers.materials[0];
    const std::uint8_t tracked = registers.lighting.color_material_front;
    if (tracked & ColorMaterialAmbient) material.ambient = color;
    if (tracked & ColorMaterialDiffuse) material.diffuse = color;
    if (tracked & ColorMaterialSpecular) material.specular = color;
    if (tracked & ColorMaterialEmission) material.emission = color;
    return material;
}

Vec3 reflection(const EyeVertex& vertex) {
    const Vec3 u = normalize(xyz(vertex.position));
    const float twice = 2 * dot(vertex.normal, u);
    return {u[0] - vertex.normal[0] * twice,
            u[1] - vertex.normal[1] * twice,
            u[2] - vertex.normal[2] * twice};
}

float generated(TexGenMode mode,
                std::size_t coordinate,
                const Vec4& plane,
                const Vec4& object,
                const EyeVertex& vertex) {
    switch (mode) {
    case TexGenMode::ObjectLinear:
        return dot(plane, object);
    case TexGenMode::EyeLinear:
        return dot(plane, vertex.position);
    case TexGenMode::NormalMap:
        return coordinate < 3 ? vertex.normal[coordinate] : 1;
    case TexGenMode::ReflectionMap:
        return coordinate < 3 ? reflection(vertex)[coordinate] : 1;
    case TexGenMode::SphereMap: {
        const Vec3 r = reflection(vertex);
        const float m = 2 * std::sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] + 1) * (r[2] + 1));
        return coordinate < 2 && m > 0 ? r[coordinate] / m + 0.5f : 0;
    }
    case TexGenMode::Off:
        break;
    }
    return 0;
}

} // namespace

EyeVertex transform_vertex(const Registers& registers, const Vec4& object, const Vec4& normal) {
    const Transform& matrices = registers.transform;
    EyeVertex vertex;
    vertex.position = transform(matrices.model_view, object);
    vertex.clip = transform(matrices.projection, vertex.position);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            vertex.normal[i] += matrices.normal_matrix[3 * i + j] * normal[j];
    if (matrices.normal_mode == NormalMode::Rescale)
        vertex.normal = scale(vertex.normal, matrices.rescale);
    if (matrices.normal_mode == NormalMode::Normalize) vertex.normal = normalize(vertex.normal);
    return vertex;
}

bool is_inside(const Registers& registers, const EyeVertex& vertex) {
    const float w = vertex.clip[3];
    const std::size_t axes = registers.viewport.clamp_depth ? 2 : 3;
    for (std::size_t i = 0; i < axes; ++i)
        if (!(vertex.clip[i] >= -w && vertex.clip[i] <= w)) return false;
    for (std::size_t i = 0; i < ClipPlanes; ++i) {
        const bool enabled = (registers.clip_planes.enable >> i & 1) != 0;
        if (enabled && !(dot(registers.clip_planes.planes[i], vertex.position) >= 0)) return false;
    }
    return registers.viewport.clamp_depth ? w > 0 : w != 0;
}

LitColors light_vertex(const Registers& registers,
                       const EyeVertex& vertex,
                       const Vec4& color,
                       const Vec4& secondary_color) {
    const Lighting& model = registers.lighting;
    if (!model.enable) return {clamp(color), clamp(secondary_color)};

    const Material material = tracked_material(registers, color);
    Vec4 primary = material.emission;
    Vec4 specular{0, 0, 0, 1};
    add_product(primary, model.scene_ambient, material.ambient, 1);
    for (const Light& light : registers.lights) {
        if (!light.enable) continue;
        const Vec3 to_light = direction(vertex.position, light.position);
        const float arriving = strength(light, vertex, to_light);
        add_product(primary, light.ambient, material.ambient, arriving);
        const float facing = dot(vertex.normal, to_light);
        if (!(facing > 0)) continue;
        add_product(primary, light.diffuse, material.diffuse, arriving * facing);
        const Vec3 to_viewer =
            model.local_viewer ? direction(vertex.position, {0, 0, 0, 1}) : Vec3{0, 0, 1};
        const Vec3 half = normalize(
            {to_light[0] + to_viewer[0], to_light[1] + to_viewer[1], to_light[2] + to_viewer[2]});
        const float highlight = std::max(0.0f, dot(vertex.normal, half));
        const float shine = power(highlight, material.shininess);
        add_product(model.separate_specular ? specular : primary,
                    light.specular,
                    material.specular,
                    arriving * shine);
    }
    primary[3] = material.diffuse[3];
    return {clamp(primary), clamp(specular)};
}

Vec4 texture_coordinates(const TexCoordSetup& setup,
                         const Vec4& object,
                         const EyeVertex& vertex,
                         const Vec4& current) {
    Vec4 coordinates = current;
    for (std::size_t i = 0; i < 4; ++i) {
        if (setup.mode[i] != TexGenMode::Off)
            coordinates[i] = generated(setup.mode[i], i, setup.plane[i], object, vertex);
    }
    return setup.matrix_enable ? transform(setup.matrix, coordinates) : coordinates;
}

} // namespace ffgpu::gl
