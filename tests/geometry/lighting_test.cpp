// Lighting against GL 1.5's equation, written down in binary64.

#include "tests/geometry/scene.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

using Double3 = std::array<double, 3>;

double dot(const Double3& a, const Double3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Double3 normalized(const Double3& v) {
    const double length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}
template <class Array>
Double3 xyz(const Array& v) {
    return {v[0], v[1], v[2]};
}

struct Surface {
    Double3 position, normal;
    std::array<float, 4> color;
};

struct Colors {
    std::array<double, 4> primary;
    std::array<double, 3> secondary;
};

// The factors of one light at the surface.
struct LightTerms {
    double weight, diffuse, specular;
};

LightTerms
terms_of(const Light& light, const Surface& surface, bool local_viewer, double shininess) {
    Double3 to_light = xyz(light.position);
    double weight = 1;
    if (light.position[3] != 0) {
        for (unsigned i = 0; i < 3; ++i)
            to_light[i] = to_light[i] / light.position[3] - surface.position[i];
        const double d = std::sqrt(dot(to_light, to_light));
        weight =
            1 / (light.attenuation[0] + light.attenuation[1] * d + light.attenuation[2] * d * d);
    }
    to_light = normalized(to_light);
    if (light.spot_cutoff_cosine >= -0.5f) {
        const double cosine = -dot(to_light, xyz(light.spot_direction));
        weight *= cosine >= light.spot_cutoff_cosine
                      ? std::pow(std::max(cosine, 0.0), double{light.spot_exponent})
                      : 0;
    }
    Double3 to_viewer{0, 0, 1};
    if (local_viewer)
        to_viewer = normalized({-surface.position[0], -surface.position[1], -surface.position[2]});
    const Double3 half = normalized(
        {to_light[0] + to_viewer[0], to_light[1] + to_viewer[1], to_light[2] + to_viewer[2]});
    const double n_dot_light = std::max(0.0, dot(surface.normal, to_light));
    const double n_dot_half = std::max(0.0, dot(surface.normal, half));
    return {weight, n_dot_light, n_dot_light > 0 ? std::pow(n_dot_half, shininess) : 0};
}

Colors reference(const Registers& registers, unsigned side, const Surface& surface) {
    const Lighting& lighting = registers.lighting;
    const Material& material = registers.materials[side];
    const auto follows = side == 0 ? lighting.color_material_front : lighting.color_material_back;
    const auto property = [&](std::uint8_t bit, const Vec4& value) {
        return follows & bit ? surface.color : value;
    };
    const Vec4 ambient = property(ColorMaterialAmbient, material.ambient);
    const Vec4 diffuse = property(ColorMaterialDiffuse, material.diffuse);
    const Vec4 specular = property(ColorMaterialSpecular, material.specular);
    const Vec4 emission = property(ColorMaterialEmission, material.emission);
    Colors colors{};
    for (unsigned c = 0; c < 3; ++c) {
        double primary =
            double{emission[c]} + double{ambient[c]} * double{lighting.scene_ambient[c]};
        double highlight = 0;
        for (const Light& light : registers.lights) {
            if (!light.enable) continue;
            const LightTerms terms =
                terms_of(light, surface, lighting.local_viewer, material.shininess);
            primary +=
                terms.weight * (double{ambient[c]} * double{light.ambient[c]} +
                                terms.diffuse * double{diffuse[c]} * double{light.diffuse[c]});
            highlight +=
                terms.weight * terms.specular * double{specular[c]} * double{light.specular[c]};
        }
        if (!lighting.separate_specular) primary += highlight;
        colors.primary[c] = std::clamp(primary, 0.0, 1.0);
        colors.secondary[c] = lighting.separate_specular ? std::clamp(highlight, 0.0, 1.0) : 0;
    }
    colors.primary[3] = std::clamp(double{diffuse[3]}, 0.0, 1.0);
    return colors;
}

template <class Values>
void randomize(Random& random, Values& values, float low, float high) {
    for (float& value : values)
        value = random.between(low, high);
}

void randomize(Random& random, Registers& registers) {
    Lighting& lighting = registers.lighting;
    lighting = {.enable = true,
                .two_sided = true,
                .local_viewer = random.below(2) != 0,
                .separate_specular = random.below(2) != 0,
                .color_material_front = static_cast<std::uint8_t>(random.below(16)),
                .color_material_back = static_cast<std::uint8_t>(random.below(16))};
    for (Light& light : registers.lights) {
        light.enable = random.below(4) == 0;
        randomize(random, light.ambient, 0, 0.2f);
        randomize(random, light.diffuse, 0, 1);
        randomize(random, light.specular, 0, 1);
        randomize(random, light.position, -4, 4);
        light.position[3] = random.below(2) ? 0.0f : random.between(0.5f, 2);
        const Double3 direction =
            normalized({random.between(-1, 1), random.between(-1, 1), random.between(0.1f, 1)});
        for (unsigned i = 0; i < 3; ++i)
            light.spot_direction[i] = static_cast<float>(direction[i]);
        if (random.below(2)) light.spot_cutoff_cosine = random.between(0, 0.5f);
        light.spot_exponent = random.below(2) ? random.between(0, 20) : 0;
        randomize(random, light.attenuation, 0.1f, 1);
    }
    for (Material& material : registers.materials) {
        randomize(random, material.ambient, 0, 1);
        randomize(random, material.diffuse, 0, 1);
        randomize(random, material.specular, 0, 1);
        randomize(random, material.emission, 0, 0.2f);
        material.shininess = random.between(0, 128);
    }
}

// A triangle whose three vertices lie close together, with one normal and colour.
struct LitTriangle {
    Scene scene;
    Surface surface;

    explicit LitTriangle(Random& random) {
        scene.layout.secondary = 4;
        scene.layout.count = 7;
        scene.carry(Attribute::Normal, 3);
        scene.carry_color();
        randomize(random, scene.registers);
        const Double3 n =
            normalized({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
        std::array<float, 3> at, normal;
        randomize(random, at, -0.8f, 0.8f);
        for (unsigned i = 0; i < 3; ++i)
            normal[i] = static_cast<float>(n[i]);
        randomize(random, surface.color, 0, 1);
        surface.position = xyz(at);
        surface.normal = xyz(normal);
        for (const auto& [dx, dy] : {std::pair{0.f, 0.f}, {0.05f, 0.f}, {0.f, 0.05f}}) {
            scene.vertex({at[0] + dx, at[1] + dy, at[2], 1, normal[0], normal[1], normal[2]});
            scene.vertex({surface.color[0], surface.color[1], surface.color[2], surface.color[3]});
        }
    }
};

void require_close(const WindowVertex& vertex, const Colors& expected) {
    for (unsigned c = 0; c < 4; ++c)
        REQUIRE(std::fabs(vertex.attributes[c] - expected.primary[c]) < 1e-4);
    for (unsigned c = 0; c < 3; ++c)
        REQUIRE(std::fabs(vertex.attributes[4 + c] - expected.secondary[c]) < 1e-4);
}

// Close to the edge of a spot light's cone either side is right.
bool near_a_cone(const Registers& registers, const Surface& surface) {
    return std::any_of(registers.lights.begin(), registers.lights.end(), [&](Light light) {
        if (!light.enable || light.spot_cutoff_cosine < -0.5f) return false;
        light.spot_exponent = 0;
        Light wider = light;
        light.spot_cutoff_cosine += 1e-5f;
        wider.spot_cutoff_cosine -= 1e-5f;
        return terms_of(light, surface, false, 0).weight !=
               terms_of(wider, surface, false, 0).weight;
    });
}

TEST_CASE("both sides of lit triangles have the colours of GL's lighting equation") {
    Random random(21);
    for (int round = 0; round < 3000; ++round) {
        LitTriangle triangle(random);
        Scene& scene = triangle.scene;
        if (near_a_cone(scene.registers, triangle.surface)) continue;
        const auto front = scene.draw(PrimitiveType::Triangles);
        REQUIRE(front.size() == 1);
        require_close(front[0][0], reference(scene.registers, 0, triangle.surface));

        scene.registers.primitive.front_is_clockwise = true;
        const auto back = scene.draw(PrimitiveType::Triangles);
        Surface turned = triangle.surface;
        for (double& n : turned.normal)
            n = -n;
        require_close(back.at(0)[0], reference(scene.registers, 1, turned));

        // Points have a front only; so does one-sided lighting.
        require_close(scene.draw(PrimitiveType::Points).at(0)[0],
                      reference(scene.registers, 0, triangle.surface));
        scene.registers.lighting.two_sided = false;
        require_close(scene.draw(PrimitiveType::Triangles).at(0)[0],
                      reference(scene.registers, 0, triangle.surface));
    }
}

TEST_CASE("a draw's back colours are not those of the draw before") {
    Scene scene;
    scene.registers.lighting.enable = true;
    scene.registers.lighting.two_sided = true;
    scene.registers.primitive.front_is_clockwise = true;
    for (const auto& [x, y] : {std::pair{0.f, 0.f}, {0.5f, 0.f}, {0.f, 0.5f}})
        scene.vertex({x, y, 0, 1});
    scene.fill_memory();
    GeometryUnit unit(scene.memory);
    for (const float red : {0.25f, 0.75f}) {
        scene.registers.materials[1].ambient = {0, 0, 0, 1};
        scene.registers.materials[1].emission = {red, 0, 0, 1};
        KeepingSink sink;
        unit.draw(scene.state(), scene.command(PrimitiveType::Triangles), sink);
        CHECK(sink.kept.at(0)[0].attributes[0] == red);
    }
}

TEST_CASE("with lighting off the vertices' colours pass, clamped") {
    Scene scene;
    scene.carry_color();
    scene.carry(Attribute::SecondaryColor, 3);
    scene.layout.secondary = 4;
    scene.layout.count = 7;
    scene.vertex({0, 0, 0, 1, -1, 2, 0.5f, 0.25f, 0.125f, 3, -4});
    const auto kept = scene.draw(PrimitiveType::Points);
    const auto& attributes = kept.at(0)[0].attributes;
    CHECK(std::vector<float>(attributes.begin(), attributes.begin() + 7) ==
          std::vector<float>{0, 1, 0.5f, 0.25f, 0.125f, 1, 0});
}

TEST_CASE("lighting alone, without lights, leaves emission and the scene's ambient light") {
    Scene scene;
    scene.registers.lighting.enable = true;
    scene.registers.lighting.scene_ambient = {0.5f, 0.5f, 0.5f, 1};
    scene.registers.materials[0].ambient = {0.5f, 0.25f, 0, 1};
    scene.registers.materials[0].emission = {0, 0, 0.125f, 1};
    scene.registers.materials[0].diffuse[3] = 0.75f;
    scene.vertex({0, 0, 0, 1});
    const auto kept = scene.draw(PrimitiveType::Points);
    const auto& attributes = kept.at(0)[0].attributes;
    CHECK(std::vector<float>(attributes.begin(), attributes.begin() + 4) ==
          std::vector<float>{0.25f, 0.125f, 0.125f, 0.75f});
    CHECK(scene.work.lights == 0);
}

} // namespace
} // namespace ffgpu
